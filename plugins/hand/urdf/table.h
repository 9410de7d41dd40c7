#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "preshape/base/parameters.h"
#include "preshape/spatial/pose.h"

namespace preshape::urdf_hand {

/// One table of a hand's Lua file, checked against the keys that it may have. The table must outlive it.
class Table {
 public:
  /// @param owner what the table is, as a message calls it: "finger 2 'index'"
  /// @param place where to point when the table itself has no place
  /// @throws InputError with the first mistake: place, owner, key and the nearest right key
  Table(std::string owner, std::vector<ParameterDeclaration> keys, const Value& table,
        const SourcePlace& place);

  const std::string& owner() const { return owner_; }
  const SourcePlace& place() const { return place_; }
  bool has(std::string_view key) const { return given_->find(key) != nullptr; }
  /// Where a key's value was written, or where the table was.
  const SourcePlace& place_of(std::string_view key) const;

  double number(std::string_view key) const { return values_.number(key); }
  const std::string& text(std::string_view key) const { return values_.text(key); }
  /// The value in the table itself, which has the key.
  const Value& given(std::string_view key) const { return *given_->find(key); }
  Eigen::Vector3d vector(std::string_view key) const;
  /// Of the keys `position` and `rotation`.
  Pose pose() const;
  /// A list of tables.
  std::span<const Value> list(std::string_view key) const;

  /// Throws InputError "place: owner: 'key' sentence".
  [[noreturn]] void refuse(std::string_view key, std::string_view sentence) const;

 private:
  std::string owner_;
  SourcePlace place_;
  const Value* given_;
  Parameters values_;
};

ParameterDeclaration positive_length(std::string name, std::string text);
ParameterDeclaration required_label(std::string name, std::string text);
ParameterDeclaration point(std::string name, std::string text);
ParameterDeclaration roll_pitch_yaw(std::string name, std::string text);

/// Roll, pitch, yaw [rad]: R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll), as in a URDF's `rpy`.
Eigen::Matrix3d turned(const Eigen::Vector3d& rpy);

}  // namespace preshape::urdf_hand
