#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "preshape/base/parameters.h"

namespace preshape::dh {

/// One table of a hand description, checked against the keys that it may have. What it returns is what was
/// written: units are the caller's matter.
class Section {
 public:
  /// The table must outlive the section.
  /// @param owner what the table is, as a message calls it: "finger 2 'index'"
  /// @param place where to point when the table itself has no place
  /// @throws InputError with the first mistake: place, owner, key and the nearest right key
  Section(std::string owner, std::vector<ParameterDeclaration> keys, const Value& table, const SourcePlace& place);

  const std::string& owner() const { return owner_; }
  const SourcePlace& place() const { return place_; }

  /// Whether the table has the key, so that its value is not the default.
  bool has(std::string_view key) const { return given_->find(key) != nullptr; }
  double number(std::string_view key) const { return values_.number(key); }
  const std::string& text(std::string_view key) const { return values_.text(key); }
  const Value& value(std::string_view key) const { return values_.value(key); }
  /// The value in the table itself, which has the key.
  const Value& given(std::string_view key) const { return *given_->find(key); }

  /// Exactly `count` numbers.
  std::vector<double> numbers(std::string_view key, std::size_t count) const;
  Eigen::Vector3d vector(std::string_view key) const;
  /// Roll, pitch, yaw [rad]: R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll).
  Eigen::Matrix3d rotation(std::string_view key) const;
  /// A list of tables, possibly empty.
  std::span<const Value> list(std::string_view key) const;

  /// Throws InputError "place: owner: 'key' sentence".
  [[noreturn]] void refuse(std::string_view key, std::string_view sentence) const;

 private:
  std::string owner_;
  SourcePlace place_;
  const Value* given_;
  Parameters values_;
};

/// Declarations as hand descriptions need them. Lengths and angles are bounded, so that infinities and angles in
/// degrees are refused.
ParameterDeclaration length(std::string name, double default_value, std::string text);
ParameterDeclaration positive_length(std::string name, std::string text);
ParameterDeclaration angle(std::string name, std::string text);
ParameterDeclaration optional_label(std::string name, std::string text);
ParameterDeclaration required_label(std::string name, std::string text);
ParameterDeclaration optional_list(std::string name, std::string text);
ParameterDeclaration required_numbers(std::string name, std::string unit, std::string text);
ParameterDeclaration point(std::string name, std::string text);
ParameterDeclaration roll_pitch_yaw(std::string name, std::string text);

}  // namespace preshape::dh
