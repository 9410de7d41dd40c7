#pragma once

#include "context.h"

namespace preshape::conformance {

/// Starts the command anew with the check's `fresh` part and the input on its standard input.
/// @returns what it printed
/// @throws Failure when it does not end well
std::string ask_fresh_process(const Check& check, const Subject& subject, const Settings& settings,
                              std::string_view input);

/// The other side: what such a process does with its standard input; prints the answer. Returns the exit code.
int answer_as_fresh_process(const Check& check, const Subject& subject, const Settings& settings);

/// Bytes as text that a pipe and a person can carry, and back.
std::string hex_text(std::string_view bytes);
std::string hex_text(std::span<const double> numbers);

}  // namespace preshape::conformance
