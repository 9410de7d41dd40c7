#include "preshape/agent/preshape_analyser.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "preshape/base/assert.h"
#include "preshape/base/error.h"

namespace preshape {

namespace {

constexpr const char* kThumb = "thumb";
/// The forefingers that take part, by their number (thesis sec. 3.4).
const std::vector<std::string>& forefinger_names() {
  static const std::vector<std::string> names = {"index", "middle", "ring"};
  return names;
}

std::size_t find_number(const std::vector<QualityNumber>& numbers, const char* name) {
  const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const auto& n) { return n.name == name; });
  if (found == numbers.end()) {
    throw InputError(fmt::format("no quality measure gives '{}', which the classifier reads; add 'sta_manu' to quality", name));
  }
  return static_cast<std::size_t>(found - numbers.begin());
}

}  // namespace

PreshapeAnalyser::PreshapeAnalyser(Models models, HandDimensions hand, ApproachPlanes planes, ApproachSymbols symbols,
                                   AnalysisSettings settings)
    : models_(std::move(models)), hand_(hand), planes_(std::move(planes)), symbols_(std::move(symbols)),
      settings_(settings) {
  for (const auto& measure : models_.quality) {
    numbers_.insert(numbers_.end(), measure->numbers().begin(), measure->numbers().end());
  }
  stability_ = find_number(numbers_, "stability");
  manipulability_ = find_number(numbers_, "manipulability");
}

/// Rays of the fingers of one station, thumb first.
struct PreshapeAnalyser::Fingers {
  std::vector<Ray> rays;
};

PreshapeAnalyser::Fingers PreshapeAnalyser::place_fingers(const SensedObject& object, const Station& station,
                                                          VirtualGrasp& grasp) const {
  const auto index = static_cast<std::size_t>(station.plane);
  const ApproachPlane& plane = planes_[index];
  grasp = {};
  grasp.plane = station.plane;
  grasp.approach_fraction = station.approach;
  grasp.transverse_fraction = station.transverse;
  grasp.approach_m = station.approach * object.half_extent_a_m[index];

  const SectionSpan span = object.profiles[object.profile_of[index]].cut(grasp.approach_m, plane.transverse);
  if (span.empty) {
    grasp.detail = "the object has no section at this station";
    return {};
  }
  grasp.depth_m = span.width();
  grasp.virtual_fingers = station.virtual_fingers > 0 ? station.virtual_fingers
                                                      : ruled_virtual_fingers(grasp.depth_m, hand_.unit_length_m);
  grasp.virtual_fingers = std::min(grasp.virtual_fingers, settings_.most_forefingers);
  const double opening = std::max(hand_.maximum_opening_m,
                                  object.half_extent_o_m[index] + settings_.ray_margin_U * hand_.unit_length_m);
  const Eigen::Vector3d middle = grasp.approach_m * plane.a + (span.middle() + station.transverse * span.width() / 2) * plane.transverse;
  Fingers fingers;
  fingers.rays.push_back({middle + opening * plane.n_f, -plane.n_f});
  grasp.fingers.emplace_back(kThumb);
  std::size_t name = 0;
  for (const double place : forefinger_places(grasp.virtual_fingers, hand_.finger_spacing_m)) {
    fingers.rays.push_back({middle + place * plane.transverse - opening * plane.n_f, plane.n_f});
    grasp.fingers.push_back(forefinger_names()[name++]);
  }
  return fingers;
}

void PreshapeAnalyser::close_fingers(const SensedObject& object, std::span<const Ray> rays,
                                     std::span<const RayHit> hits, VirtualGrasp& grasp) const {
  const ApproachPlane& plane = planes_[static_cast<std::size_t>(grasp.plane)];
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits[i].met()) {
      grasp.status = VirtualGrasp::Status::kMissed;
      grasp.detail = fmt::format("the {} passes the object by", i == 0 ? kThumb : grasp.fingers[i] + " finger");
      grasp.contacts.clear();
      return;
    }
    Eigen::Vector3d n = object.object.mesh_O.area_vector(static_cast<std::size_t>(hits[i].triangle)).normalized();
    // The ray comes from outside, so the inward normal goes along with it, however the triangle is wound.
    if (n.dot(rays[i].direction) < 0.0) n = -n;
    grasp.contacts.push_back(ContactFrame::at(rays[i].origin + hits[i].distance * rays[i].direction, n, plane.a));
  }
  const double least = std::cos(settings_.opposition_angle_deg * std::numbers::pi / 180.0);
  const ContactFrame& thumb = grasp.contacts.front();
  for (std::size_t i = 1; i < grasp.contacts.size(); ++i) {
    const ContactFrame& finger = grasp.contacts[i];
    const double opening = (thumb.p_OC - finger.p_OC).dot(plane.n_f);
    grasp.opening_m = std::max(grasp.opening_m, opening);
    if (opening <= 0.0) {
      grasp.status = VirtualGrasp::Status::kNoOpposition;
      grasp.detail = fmt::format("the thumb meets the object beyond where the {} finger does", grasp.fingers[i]);
      return;
    }
    // Exact opposition within a rounding also when the angle allowed is zero.
    if (-thumb.n.dot(finger.n) < least - 1e-9) {
      grasp.status = VirtualGrasp::Status::kNoOpposition;
      grasp.detail = fmt::format("thumb and {} finger do not oppose each other within {} degrees", grasp.fingers[i],
                                 number_text(settings_.opposition_angle_deg));
      return;
    }
  }
  grasp.status = VirtualGrasp::Status::kGrasp;
  grasp.F_C_O.resize(grasp.contacts.size());
  models_.contact->pattern_wrenches(grasp.contacts, grasp.F_C_O);
  grasp.resultant = resultant_wrench(grasp.contacts, grasp.F_C_O, object.length_m);
}

void PreshapeAnalyser::measure(double length_m, VirtualGrasp& grasp, std::span<const JointAction> joints) const {
  grasp.wrench_union = wrench_union(*models_.contact, grasp.contacts, length_m);
  grasp.quality.resize(numbers_.size());
  const ApproachPlane& plane = planes_[static_cast<std::size_t>(grasp.plane)];
  const GraspView view{grasp.contacts, grasp.F_C_O, grasp.wrench_union,    grasp.resultant, length_m,
                       models_.contact.get(), plane.a, plane.n_f, joints};
  std::size_t first = 0;
  for (const auto& measure : models_.quality) {
    const std::size_t count = measure->numbers().size();
    measure->evaluate(view, std::span(grasp.quality).subspan(first, count));
    first += count;
  }
  grasp.stability = grasp.quality[stability_];
  grasp.manipulability = grasp.quality[manipulability_];
}

void PreshapeAnalyser::analyse(const SensedObject& object, std::span<const Station> stations,
                               std::span<VirtualGrasp> grasps, bool measures) const {
  PRESHAPE_DEMAND(stations.size() == grasps.size());
  // One batch of rays for all stations: the collision plugin is entered once.
  std::vector<Ray> rays;
  std::vector<std::size_t> first = {0};
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Fingers fingers = place_fingers(object, stations[i], grasps[i]);
    rays.insert(rays.end(), fingers.rays.begin(), fingers.rays.end());
    first.push_back(rays.size());
  }
  std::vector<RayHit> hits(rays.size());
  object.scene->cast(rays, hits);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const std::size_t count = first[i + 1] - first[i];
    if (count == 0) continue;
    close_fingers(object, std::span(rays).subspan(first[i], count), std::span(hits).subspan(first[i], count), grasps[i]);
    if (measures && grasps[i].is_grasp()) measure(object.length_m, grasps[i]);
  }
}

VirtualGrasp PreshapeAnalyser::analyse(const SensedObject& object, const Station& station) const {
  VirtualGrasp grasp;
  analyse(object, {&station, 1}, {&grasp, 1});
  return grasp;
}

Station PreshapeAnalyser::station(const SensedObject& object, const Preshape& preshape) const {
  const auto index = static_cast<std::size_t>(preshape.plane - 1);
  return {preshape.plane - 1, symbols_.fraction(preshape.symbol, object.half_extent_a_m[index], object.length_m),
          settings_.free_virtual_fingers ? preshape.virtual_fingers : 0};
}

Preshape PreshapeAnalyser::preshape(const SensedObject& object, const VirtualGrasp& grasp) const {
  const auto index = static_cast<std::size_t>(grasp.plane);
  return {grasp.plane + 1, symbols_.symbol(grasp.approach_fraction, object.half_extent_a_m[index], object.length_m),
          grasp.virtual_fingers};
}

}  // namespace preshape
