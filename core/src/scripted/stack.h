#pragma once

#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include <lua.hpp>

#include "preshape/contact/contact_frame.h"

namespace preshape::scripted {

// Numbers to and from the stack of a state, where going through Value would be too slow. All of it inside of
// Host::enter.

/// Overwrites the items 1 .. n of the table at `table`.
void refill(lua_State* L, int table, std::span<const double> numbers);
void refill(lua_State* L, int table, const Eigen::Vector3d& vector);

/// Pushes a list of numbers.
void push_numbers(lua_State* L, std::span<const double> numbers);

/// Pushes a list of the rows of a matrix.
void push_rows(
    lua_State* L,
    const Eigen::Ref<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>& rows);

/// A contact as scripts see it, { p =, n =, a =, t = }, three numbers each. Lives on the stack, refilled for
/// each.
class ContactTable {
 public:
  /// Leaves five tables on the stack. @throws ScriptError when there is no room
  explicit ContactTable(lua_State* L);
  /// Pushes it, filled.
  void push(const ContactFrame& C) const;

 private:
  lua_State* L_;
  int table_;
};

/// Pushes a list of contacts.
void push_contacts(lua_State* L, std::span<const ContactFrame> contacts);

/// Reads the number at `index`. @returns "" or what is wrong: "a finite number, got nan"
std::string read_number(lua_State* L, int index, double& number);

/// Reads the list at `index`, which must have as many items as `numbers`. @returns "" or what is wrong, such
/// as "a list of 6 finite numbers, got item 2 = nil"
std::string read_numbers(lua_State* L, int index, std::span<double> numbers);

/// Reads the results of a call, all that stands above `base`: as many numbers, or one list of them.
std::string read_results(lua_State* L, int base, std::span<double> numbers);

/// Takes a rounding beyond an end of the range back to that end. @returns whether the number is in the range
bool settle(double& number, double lowest, double highest);

/// The check that what a script is given is finite: a script's answer to anything else would mean nothing.
/// @throws InputError "<owner>: <what> must be finite, got (1, nan)"
void require_finite(const std::string& owner, std::string_view what, std::span<const double> numbers);
void require_finite(const std::string& owner, std::span<const ContactFrame> contacts);

/// "(1, 0.5, nan)": for messages.
std::string text_of(std::span<const double> numbers);

/// What stands at `index`, for messages: "nil", "number nan", "table".
std::string told_of(lua_State* L, int index);

}  // namespace preshape::scripted
