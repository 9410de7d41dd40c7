#pragma once

#include <string>
#include <string_view>

#include "preshape/base/value.h"

namespace preshape::scripted {

/// What a classifier in Lua has learned: its own data, and what it is a model of.
struct LearnedModel {
  Value model;
  int features = 0, bits = 0;
};

/// As text: a head with the component's name and the sizes, the model as Lua source, a SHA-256 of all that.
std::string model_text(const std::string& component, const LearnedModel& learned);

/// The model of such a text. @throws InputError with the reason when it is anything else
LearnedModel model_from(const std::string& component, std::string_view text);

}  // namespace preshape::scripted
