// What a contact transmits and what it adds to the pattern of a grasp.
#include <cmath>

#include "cone.h"
#include "contact.h"
#include "frames.h"
#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

constexpr double kTolerance = 1e-10;  // of wrenches of unit size, after a turn

std::vector<Block> with(std::vector<Block> blocks, std::initializer_list<Block> more) {
  blocks.insert(blocks.end(), more);
  return blocks;
}

/// Two contacts of one model on the x axis of O, one unit apart and pressing on each other.
std::array<ContactFrame, 2> opposed(const Eigen::Matrix3d& R) {
  const auto x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  return {rotated(R, ContactFrame::at(0.5 * x, -x, z)), rotated(R, ContactFrame::at(-0.5 * x, x, z))};
}

/// The wrenches of each contact, moved to O.
WrenchBasis about_origin(std::span<const ContactFrame> contacts, WrenchBasis wrenches) {
  const Eigen::Index each = wrenches.cols() / std::ssize(contacts);
  for (Eigen::Index k = 0; k < wrenches.cols(); ++k) {
    const Eigen::Vector3d p = contacts[static_cast<std::size_t>(k / each)].p_OC, f = wrenches.col(k).head<3>();
    wrenches.col(k).tail<3>() += p.cross(f);
  }
  return wrenches;
}

/// Loads that friction bears: forces across the contacts' line, moments about the axes across it.
WrenchBasis friction_loads(const Eigen::Matrix3d& R) {
  WrenchBasis loads = WrenchBasis::Zero(6, 4);
  loads.col(0).head<3>() = loads.col(2).tail<3>() = R.col(1);
  loads.col(1).head<3>() = loads.col(3).tail<3>() = R.col(2);
  return loads;
}

/// The first of the friction loads, either way round, that the two contacts do not bear; "" when they bear all.
std::string unborne(const ContactModel& model, const Eigen::Matrix3d& R) {
  const auto contacts = opposed(R);
  const ContactLimits* limits = contact_limits(model);
  const WrenchBasis loads = friction_loads(R);
  const WrenchBasis held = about_origin(contacts, limits ? edges_of(*limits, contacts, 8) : basis_of(model, contacts));
  for (Eigen::Index i = 0; i < loads.cols(); ++i) {
    for (const double sign : {1e-2, -1e-2}) {
      const Eigen::Matrix<double, 6, 1> load = sign * loads.col(i);
      const double missing = limits ? distance_from_cone(held, load) : outside(held, load);
      if (!(missing <= 1e-8)) return wrench_text(load);
    }
  }
  return "";
}

std::string odd_text(const ContactModel& model, const ContactFrame& contact) {
  try {
    if (!basis_of(model, {&contact, 1}).allFinite()) return "a unit wrench is not finite";
    if (!pattern_of(model, {&contact, 1}).allFinite()) return "the pattern wrench is not finite";
    const ContactLimits* limits = contact_limits(model);
    if (!limits) return "";
    limits->admits(contact, Wrench(contact.n, Eigen::Vector3d::Zero()), 1e-9);
    if (!edges_of(*limits, {&contact, 1}, 8).allFinite()) return "an edge is not finite";
  } catch (const InputError&) {
  }
  return "";
}

bool refuses_resolution(const ContactLimits& limits, int resolution) {
  const ContactFrame contact = ContactFrame::at({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  WrenchBasis room(6, std::clamp(limits.primitive_count(resolution), 0, 1000));
  try {
    limits.primitive_wrenches({&contact, 1}, resolution, room);
  } catch (const InputError&) {
    return true;
  }
  return false;
}

}  // namespace

void c01_covariant(Context& context) {
  const auto model = context.create<ContactModel>();
  const ContactLimits* limits = contact_limits(*model);
  const auto blocks = with(frame_blocks(), {rotation_block(), {"load", 6, -1.0, 1.0, {0.0}}});
  context.for_all(blocks, context.cases(1000), [&](Case c) -> std::string {
    const auto contact = frame_of(c);
    // An approach axis along the normal names no tangents, so none can turn with the contact.
    if (!contact || contact->t.norm() < 1e-3) return "";
    const Eigen::Matrix3d R = rotation_of(c.subspan(9, 4));
    const ContactFrame turned = rotated(R, *contact);
    const double basis = apart(rotated(R, basis_of(*model, {&*contact, 1})), basis_of(*model, {&turned, 1}));
    if (!(basis <= kTolerance)) return fmt::format("the unit wrenches of the rotated contact are {} beside the rotated ones", basis);
    const double pattern = apart(rotated(R, pattern_of(*model, {&*contact, 1})), pattern_of(*model, {&turned, 1}));
    if (!(pattern <= kTolerance)) return fmt::format("the pattern wrench of the rotated contact is {} beside the rotated one", pattern);
    if (!limits) return "";
    const Eigen::Map<const Eigen::Matrix<double, 6, 1>> load(c.data() + 13);
    const Wrench F(contact->n + load.head<3>(), load.tail<3>());
    // Two tolerances: on the border a rounding decides.
    const bool here = limits->admits(*contact, F, 1e-9), there = limits->admits(turned, F.rotated(R), 1e-7);
    return here && !there ? "the rotated contact does not bear the rotated load" : "";
  });
}

void c02_own_point(Context& context) {
  const auto model = context.create<ContactModel>();
  const auto blocks = with(frame_blocks(), {{"moved to", 3, -100.0, 100.0, {0.0}}});
  context.for_all(blocks, context.cases(1000), [&](Case c) -> std::string {
    const auto contact = frame_of(c);
    if (!contact) return "";
    ContactFrame moved = *contact;
    moved.p_OC = Eigen::Vector3d(c[9], c[10], c[11]);
    const double basis = apart(basis_of(*model, {&*contact, 1}), basis_of(*model, {&moved, 1}));
    if (!(basis <= kTolerance)) return fmt::format("moving the contact changes its unit wrenches by {}", basis);
    const double pattern = apart(pattern_of(*model, {&*contact, 1}), pattern_of(*model, {&moved, 1}));
    return pattern <= kTolerance ? "" : fmt::format("moving the contact changes its pattern wrench by {}", pattern);
  });
}

void c03_reciprocal(Context& context) {
  const auto model = context.create<ContactModel>();
  context.for_all(frame_blocks(), context.cases(1000), [&](Case c) -> std::string {
    const auto contact = frame_of(c);
    if (!contact) return "";
    const ContactFrame other = ContactFrame::at(contact->p_OC, -contact->n, contact->a);
    const WrenchBasis ours = basis_of(*model, {&*contact, 1}), theirs = basis_of(*model, {&other, 1});
    for (Eigen::Index k = 0; k < theirs.cols(); ++k) {
      if (outside(ours, theirs.col(k)) <= 1e-8) continue;
      return fmt::format("the other body is given the wrench {}, which is none of those that this one transmits",
                         wrench_text(theirs.col(k)));
    }
    return "";
  });
}

void c04_pushes_only(Context& context) {
  const auto model = context.create<ContactModel>();
  const ContactLimits* limits = contact_limits(*model);
  const bool declared = context.declares("adhesive");
  bool pulls = false;
  const auto blocks = with(frame_blocks(), {{"load", 6, -1.0, 1.0, {0.0}}});
  context.for_all(blocks, context.cases(1000), [&](Case c) -> std::string {
    const auto contact = frame_of(c);
    if (!contact) return "";
    const Eigen::Matrix<double, 6, 1> F = pattern_of(*model, {&*contact, 1}).col(0);
    const double push = F.head<3>().dot(contact->n);
    if (!(push >= -1e-12 * F.norm())) {
      if (!declared) return fmt::format("the pattern wrench pulls with {}", -push);
      pulls = true;
    }
    Eigen::Matrix<double, 6, 1> load = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(c.data() + 9);
    load.head<3>() -= std::abs(load.head<3>().dot(contact->n)) * 2.0 * contact->n;
    if (!limits || load.head<3>().dot(contact->n) > -1e-3) return "";
    const bool borne = limits->admits(*contact, Wrench::from_vector(load), 1e-9);
    pulls = pulls || borne;
    return borne && !declared ? fmt::format("the pull {} is borne", wrench_text(load)) : "";
  });
  if (declared && !pulls) context.warn("it promises to be 'adhesive', but no case was found in which it pulls");
}

void c11_basis_rank(Context& context) {
  const auto model = context.create<ContactModel>();
  const int size = model->basis_size();
  context.require(size >= 1 && size <= 6, "it says that a contact has {} unit wrenches; there are 1 to 6", size);
  context.for_all(frame_blocks(), context.cases(1000), [&](Case c) -> std::string {
    const auto contact = square_frame_of(c);
    if (!contact) return "";
    const WrenchBasis basis = basis_of(*model, {&*contact, 1});
    for (Eigen::Index k = 0; k < basis.cols(); ++k) {
      if (!(std::abs(basis.col(k).norm() - 1.0) <= kTolerance)) {
        return fmt::format("unit wrench {} is {}, of length {}", k + 1, wrench_text(basis.col(k)), basis.col(k).norm());
      }
    }
    const int rank = rank_of(basis), now = model->basis_size();
    if (now != size) return fmt::format("it said that a contact has {} unit wrenches, and now {}", size, now);
    return rank == size ? "" : fmt::format("of its {} unit wrenches {} are independent", size, rank);
  });
}

void c15_odd_frames(Context& context) {
  const auto model = context.create<ContactModel>();
  constexpr double kHuge = 1e100, kTiny = 1e-200;
  const std::vector<Block> blocks = {{"point", 3, -1.0, 1.0},
                                     {"normal", 3, -2.0, 2.0, {0.0, kTiny, kHuge}},
                                     {"approach", 3, -2.0, 2.0, {0.0, kTiny, kHuge}}};
  context.for_all(blocks, context.cases(1000), [&](Case c) {
    return odd_text(*model, ContactFrame::at({c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}));
  });
  const ContactLimits* limits = contact_limits(*model);
  for (int resolution = -1; limits && resolution < 3; ++resolution) {
    context.require(refuses_resolution(*limits, resolution), "it gives edges at the resolution {}, which is below 3", resolution);
  }
}

void c17_opposed(Context& context) {
  const auto model = context.create<ContactModel>();
  const bool declared = context.declares("friction");
  bool bears = true;
  const std::vector<Block> blocks = {rotation_block()};
  context.for_all(blocks, context.cases(50), [&](Case c) -> std::string {
    const std::string load = unborne(*model, rotation_of(c));
    bears = bears && load.empty();
    return declared && !load.empty() ? fmt::format("two opposed contacts do not bear the load {}", load) : "";
  });
  if (declared) return;
  if (!bears) context.skip("it does not promise 'friction'");
  context.warn("two opposed contacts bear loads across their line; it may promise 'friction'");
}

void c18_independent(Context& context) {
  const auto model = context.create<ContactModel>();
  const ContactLimits* limits = contact_limits(*model);
  auto blocks = frame_blocks();
  const auto second = frame_blocks();
  blocks.insert(blocks.end(), second.begin(), second.end());
  for (std::size_t i = 0; i < 3; ++i) blocks[i + 3].name = "other " + blocks[i + 3].name;
  const auto compare = [](const char* what, const WrenchBasis& first, const WrenchBasis& last, const WrenchBasis& both) {
    const Eigen::Index each = first.cols();
    const bool same = both.cols() == 2 * each && both.leftCols(each) == first && both.rightCols(each) == last;
    return same ? std::string() : fmt::format("with another contact beside it the {} of a contact change", what);
  };
  context.for_all(blocks, context.cases(500), [&](Case c) -> std::string {
    const auto one = frame_of(c.first(9)), other = frame_of(c.subspan(9));
    if (!one || !other) return "";
    const ContactFrame both[] = {*one, *other}, reversed[] = {*other, *one};
    const auto basis = [&](std::span<const ContactFrame> contacts) { return basis_of(*model, contacts); };
    const auto edges = [&](std::span<const ContactFrame> contacts) { return edges_of(*limits, contacts, 8); };
    std::string found = compare("unit wrenches", basis({both, 1}), basis({reversed, 1}), basis(both));
    if (found.empty()) found = compare("unit wrenches", basis({reversed, 1}), basis({both, 1}), basis(reversed));
    if (limits && found.empty()) found = compare("edges", edges({both, 1}), edges({reversed, 1}), edges(both));
    return found;
  });
}

void c19_pattern_in_basis(Context& context) {
  const auto model = context.create<ContactModel>();
  context.for_all(frame_blocks(), context.cases(1000), [&](Case c) -> std::string {
    const auto contact = frame_of(c);
    if (!contact) return "";
    const Eigen::Matrix<double, 6, 1> F = pattern_of(*model, {&*contact, 1}).col(0);
    // Near the parallel, t and the part of a across the normal are small, and so are their errors.
    const double share = outside(basis_of(*model, {&*contact, 1}), F);
    return share <= 1e-8 ? "" : fmt::format("of the pattern wrench {} the share {} is outside the unit wrenches", wrench_text(F), share);
  });
}

}  // namespace preshape::conformance
