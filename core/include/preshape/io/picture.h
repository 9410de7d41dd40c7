#pragma once

#include <optional>
#include <string>
#include <vector>

#include "preshape/geometry/collision.h"
#include "preshape/io/grasp_scene.h"
#include "preshape/io/png.h"

namespace preshape {

/// Where a picture is seen from, in O.
struct PictureView {
  std::string name;  ///< written under it
  Eigen::Vector3d direction =
      -Eigen::Vector3d::UnitZ();                  ///< the way the camera looks; of any length but zero
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();  ///< not along the direction
};

/// The view along a direction with z, or y where that is the direction, upwards.
/// @throws InputError on a direction that is zero or not finite
PRESHAPE_API PictureView picture_view(const Eigen::Vector3d& direction);

/// Along the approach axis, along the opposition axis, and oblique; the hand comes from above in the last
/// two.
PRESHAPE_API std::vector<PictureView> grasp_views(const GraspScene& scene);

/// What is drawn and how.
struct PictureOptions {
  int width = 1440,
      height = 620;  ///< of the whole picture [px]; kSmallestWidth, kSmallestHeight .. Image::kWidest
  std::vector<PictureView> views;  ///< side by side; grasp_views when empty
  double field_of_view =
      0.0;  ///< [rad] perspective, below pi / 2; 0: orthographic, and all views in one scale
  double hand_opacity = 0.45;  ///< 0: no hand, 1: solid
  int frame = -1;              ///< of the motion: 0 the open hand; negative counts from the last
  bool marks = true;           ///< contacts, normals, wrenches, plane and axis, approach volume
  bool words = true;           ///< title, verdict, legend, names of the views, scale
};

inline constexpr int kSmallestWidth = 240, kSmallestHeight = 180;

/// What the colours mean.
enum class PictureInk {
  kBackground,
  kObject,
  kHand,
  kContact,
  kNormal,
  kForce,
  kMoment,
  kResultant,
  kResultantMoment,
  kPlane,
  kAxis,
  kVolume,
  kEntrance,
  kCollision
};
PRESHAPE_API Rgb picture_ink(PictureInk ink);

/// A part of a picture with a camera of its own.
struct PRESHAPE_API PicturePanel {
  PictureView view;
  int left = 0, top = 0, width = 0, height = 0;  ///< [px] in the picture
  Eigen::Matrix3d R_OE;                          ///< eye E: x to the right, y upwards, looks along -z
  Eigen::Vector3d p_OE;                          ///< the eye; orthographic: any point before everything
  double pixel_m = 0.0;                          ///< of a pixel; perspective: at 1 m before the eye
  bool perspective = false;

  /// Where a point is seen, in pixels of the picture; the middle of the first pixel is at (0.5, 0.5).
  Eigen::Vector2d pixel(const Eigen::Vector3d& p_O) const;
  /// What is seen there.
  Ray ray(const Eigen::Vector2d& pixel) const;
};

/// How the views of a picture lie in it: as large as lets everything drawn be seen.
/// @throws InputError on a size, a field of view, a frame or a view that cannot be drawn
PRESHAPE_API std::vector<PicturePanel> picture_panels(const GraspScene& scene,
                                                      const PictureOptions& options = {});

/// Draws a scene by casting rays: object shaded, hand translucent, contacts as balls with their inward
/// normals, wrenches as arrows (couples with two heads) and the resultant's at O, approach plane and
/// opposition axis, the approach volume of the open hand with the outline of its entrance and its normal.
/// Links that were found in collision have a colour of their own. What the object hides of these shines
/// through. The same scene gives the same pixels, whichever exact backend casts the rays.
/// @throws InputError as picture_panels
PRESHAPE_API Image picture(const GraspScene& scene, const CollisionBackend& collision,
                           const PictureOptions& options = {});

}  // namespace preshape
