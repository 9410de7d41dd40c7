// What a contact can bear, by the extension ContactLimits.
#include <cmath>
#include <numbers>

#include "cone.h"
#include "contact.h"
#include "frames.h"

namespace preshape::conformance {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// A model with its limits; a check of them is skipped where it has none.
struct Limited {
  std::shared_ptr<ContactModel> model;
  const ContactLimits& limits;
};

Limited limited(Context& context, std::shared_ptr<ContactModel> model) {
  const ContactLimits* limits = contact_limits(*model);
  if (!limits) context.skip("it offers no contact limits, so nothing says what a contact bears");
  return {std::move(model), *limits};
}
Limited limited(Context& context) { return limited(context, context.create<ContactModel>()); }

/// Unit direction across the normal of a square frame.
Vector6 across(const ContactFrame& contact, double angle) {
  Vector6 direction = Vector6::Zero();
  direction.head<3>() = std::cos(angle) * contact.a + std::sin(angle) * contact.t;
  return direction;
}

/// A load that the basis transmits, without its part along the normal force; near zero: none.
std::optional<Vector6> transmitted(const Limited& it, const ContactFrame& contact, Case six) {
  const WrenchBasis basis = basis_of(*it.model, {&contact, 1});
  Vector6 load = Vector6::Zero();
  for (Eigen::Index k = 0; k < basis.cols(); ++k) load += six[static_cast<std::size_t>(k)] * basis.col(k);
  load.head<3>() -= load.head<3>().dot(contact.n) * contact.n;
  if (load.norm() < 1e-3) return std::nullopt;
  return load / load.norm();
}

std::vector<Block> load_blocks(std::initializer_list<Block> more = {}) {
  auto blocks = frame_blocks();
  blocks.push_back({"load", 6, -1.0, 1.0, {-1.0, 0.0, 1.0}});
  blocks.insert(blocks.end(), more);
  return blocks;
}
Case load_in(Case c) { return c.subspan(kFrameNumbers, 6); }

const Block kAngle = {"angle", 1, -std::numbers::pi, std::numbers::pi};

/// Coulomb's coefficient, for models with a parameter `mu`.
std::optional<double> friction_of(Context& context) {
  const ParameterDeclaration* declared = context.record().schema.find("mu");
  if (!declared || !declared->default_value.is_number()) return std::nullopt;
  const Value parameters = context.parameters();
  const Value* given = parameters.find("mu");
  return (given ? *given : declared->default_value).number();
}

/// Nothing beyond `mu` of the normal force is borne across it.
std::string beyond_friction(const Limited& it, const ContactFrame& contact, double mu, double angle) {
  const Vector6 direction = across(contact, angle);
  const double more = mu * (1.0 + 1e-6) + 1e-6;
  if (it.limits.admits(contact, loaded(contact, more, direction), 1e-9)) {
    return fmt::format("with mu = {} a force of {} across a unit normal force is borne", mu, more);
  }
  const WrenchBasis edges = edges_of(it.limits, {&contact, 1}, 8);
  for (Eigen::Index k = 0; k < edges.cols(); ++k) {
    const Eigen::Vector3d f = edges.col(k).head<3>();
    const double normal = f.dot(contact.n), side = (f - normal * contact.n).norm();
    // Rounding in the tangents, besides the bound itself.
    if (!(side <= mu * normal * (1.0 + 1e-9) + 1e-12)) return fmt::format("with mu = {} edge {} has {} across {}", mu, k + 1, side, normal);
  }
  return "";
}

std::string edges_text(const Limited& it, const ContactFrame& contact, int resolution, const WrenchBasis& edges, Case weights) {
  Vector6 sum = Vector6::Zero();
  double total = 1e-9;
  for (Eigen::Index k = 0; k < edges.cols(); ++k) {
    const double normal = edges.col(k).head<3>().dot(contact.n);
    if (!(std::abs(normal - 1.0) <= 1e-10)) return fmt::format("edge {} of {} has the normal force {}", k + 1, resolution, normal);
    if (!it.limits.admits(contact, Wrench::from_vector(edges.col(k)), 1e-9)) {
      return fmt::format("edge {} of {}, {}, is not borne", k + 1, resolution, wrench_text(edges.col(k)));
    }
    const double weight = weights[static_cast<std::size_t>(k) % weights.size()];
    sum += weight * edges.col(k);
    total += weight;
  }
  sum /= total;
  if (it.limits.admits(contact, Wrench::from_vector(sum), 1e-9)) return "";
  return fmt::format("{}, a sum of edges of {}, is not borne", wrench_text(sum), resolution);
}

}  // namespace

void c05_friction_bound(Context& context) {
  const Limited it = limited(context);
  const auto mu = friction_of(context);
  auto blocks = frame_blocks();
  blocks.push_back(kAngle);
  const auto over = [&](const Limited& some, std::optional<double> coefficient, int count) {
    context.for_all(blocks, count, [&](Case c) -> std::string {
      const auto contact = square_frame_of(c);
      if (!contact) return "";
      if (some.limits.admits(*contact, loaded(*contact, 1e6, across(*contact, c[9])), 1e-9)) {
        return "a force of 1e6 across a unit normal force is borne";
      }
      return coefficient ? beyond_friction(some, *contact, *coefficient, c[9]) : "";
    });
  };
  over(it, mu, context.cases(500));
  if (!mu || context.record().schema.find("mu")->minimum > 0.0) return;
  Value slippery = context.parameters();
  slippery.set("mu", 0.0);
  over(limited(context, context.create<ContactModel>(slippery)), 0.0, context.cases(100));
}

void c08_cone(Context& context) {
  const Limited it = limited(context);
  const auto blocks = load_blocks({{"other load", 6, -1.0, 1.0, {-1.0, 0.0, 1.0}},
                                   {"share", 2, 0.0, 0.999},
                                   {"multiple", 1, 0.0, 1e6, {1e-6, 0.5, 2.0, 1e3}}});
  context.for_all(blocks, context.cases(300), [&](Case c) -> std::string {
    const auto contact = square_frame_of(c);
    if (!contact) return "";
    const auto bears = [&](const Wrench& F) { return it.limits.admits(*contact, F, 1e-9); };
    if (!bears(Wrench(contact->n, Eigen::Vector3d::Zero()))) return "the pure normal force is not borne";
    if (!bears(Wrench())) return "the zero wrench is not borne";
    const auto one = transmitted(it, *contact, load_in(c)), other = transmitted(it, *contact, c.subspan(15, 6));
    if (!one || !other) return "";
    const double reach_one = reach(it.limits, *contact, *one), multiple = c[23];
    const Wrench a = loaded(*contact, c[21] * reach_one, *one);
    const Wrench b = loaded(*contact, c[22] * reach(it.limits, *contact, *other), *other);
    if (!bears(a * multiple)) return fmt::format("{} is borne, {} times it is not", wrench_text(a.vector()), multiple);
    if (!bears(a + b)) return fmt::format("{} and {} are borne, their sum is not", wrench_text(a.vector()), wrench_text(b.vector()));
    const Wrench beyond = loaded(*contact, 1.001 * reach_one + 1e-6, *one);
    if (multiple > 1e-6 && bears(beyond * multiple)) {
      return fmt::format("{} is not borne, {} times it is", wrench_text(beyond.vector()), multiple);
    }
    return "";
  });
}

void c09_inner_polyhedron(Context& context) {
  const Limited it = limited(context);
  // A regular polygon in a circle misses pi^2 / 2 = 4.9 over k^2 of the radius, in an ellipse of axes 2 : 1 with
  // edges at equal angles up to four times that.
  constexpr double kError = 20.0;
  const auto blocks = load_blocks({kAngle, {"weights", 7, 0.0, 1.0}});
  context.for_all(blocks, context.cases(40), [&](Case c) -> std::string {
    const auto contact = square_frame_of(c);
    if (!contact) return "";
    const auto load = transmitted(it, *contact, load_in(c));
    const Vector6 side = across(*contact, c[15]);
    const double side_reach = reach(it.limits, *contact, side), load_reach = load ? reach(it.limits, *contact, *load) : 0.0;
    for (const int k : {3, 4, 8, 64}) {
      if (it.limits.primitive_count(k) < 1) return fmt::format("it has {} edges at the resolution {}", it.limits.primitive_count(k), k);
      const WrenchBasis edges = edges_of(it.limits, {&*contact, 1}, k);
      if (auto found = edges_text(it, *contact, k, edges, c.subspan(16)); !found.empty()) return found;
      const double inside = side_reach * (1.0 - kError / (k * k));
      if (inside > 0.0 && distance_from_cone(edges, loaded(*contact, inside, side).vector()) > 1e-8) {
        return fmt::format("{} across a unit normal force is borne, but {} edges do not even span {}", side_reach, k, inside);
      }
      if (!load) continue;
      const Vector6 outside = loaded(*contact, 1.001 * load_reach + 1e-6, *load).vector();
      if (distance_from_cone(edges, outside) < 1e-9) return fmt::format("{} is not borne, but {} edges span it", wrench_text(outside), k);
    }
    return "";
  });
}

void c10_isotropic(Context& context) {
  const Limited it = limited(context);
  const auto blocks = load_blocks({kAngle});
  context.for_all(blocks, context.cases(500), [&](Case c) -> std::string {
    const auto contact = square_frame_of(c);
    if (!contact) return "";
    const auto load = transmitted(it, *contact, load_in(c));
    if (!load) return "";
    const ContactFrame turned = ContactFrame::at(contact->p_OC, contact->n, across(*contact, c[15]).head<3>());
    const double here = reach(it.limits, *contact, *load), there = reach(it.limits, turned, *load);
    if (std::abs(here - there) <= 1e-6 * (1.0 + here)) return "";
    return fmt::format("along {} it bears {}, and {} with its approach axis turned", wrench_text(*load), here, there);
  });
}

void c20_limits_in_basis(Context& context) {
  const Limited it = limited(context);
  context.for_all(load_blocks(), context.cases(500), [&](Case c) -> std::string {
    const auto contact = square_frame_of(c);
    if (!contact) return "";
    const WrenchBasis basis = basis_of(*it.model, {&*contact, 1}), edges = edges_of(it.limits, {&*contact, 1}, 8);
    for (Eigen::Index k = 0; k < edges.cols(); ++k) {
      if (outside(basis, edges.col(k)) > 1e-8) return fmt::format("edge {}, {}, is outside the unit wrenches", k + 1, wrench_text(edges.col(k)));
    }
    const Eigen::Map<const Vector6> load(load_in(c).data());
    const Vector6 small = 1e-2 * load;
    if (outside(basis, loaded(*contact, 1.0, small).vector()) < 1e-3) return "";
    const bool borne = it.limits.admits(*contact, loaded(*contact, 1.0, small), 1e-9);
    return borne ? fmt::format("{} added to a unit normal force is borne, but no unit wrenches transmit it", wrench_text(small)) : "";
  });
}

void c21_tolerance(Context& context) {
  const Limited it = limited(context);
  const auto blocks = load_blocks({{"share", 1, 0.8, 1.2, {0.999, 1.0, 1.001}}, {"tolerances", 2, 0.0, 0.1, {1e-9, 1e-3}}});
  context.for_all(blocks, context.cases(500), [&](Case c) -> std::string {
    const auto contact = square_frame_of(c);
    if (!contact) return "";
    const auto load = transmitted(it, *contact, load_in(c));
    if (!load) return "";
    const Wrench F = loaded(*contact, c[15] * reach(it.limits, *contact, *load), *load);
    const auto [small, large] = std::minmax(c[16], c[17]);
    if (!it.limits.admits(*contact, F, small) || it.limits.admits(*contact, F, large)) return "";
    return fmt::format("{} is borne at the tolerance {} and not at {}", wrench_text(F.vector()), small, large);
  });
}

}  // namespace preshape::conformance
