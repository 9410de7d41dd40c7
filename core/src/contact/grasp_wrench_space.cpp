#include "preshape/contact/grasp_wrench_space.h"

#include <fmt/format.h>

#include "preshape/base/assert.h"
#include "preshape/base/error.h"
#include "preshape/contact/contact_limits.h"

namespace preshape {

GraspWrenchSpace::GraspWrenchSpace(WrenchBasis primitives, Eigen::Index per_contact, ForceBound bound)
    : primitives_(std::move(primitives)), per_contact_(per_contact), bound_(bound), radius_(0.0) {
  PRESHAPE_DEMAND(per_contact_ > 0 && primitives_.cols() % per_contact_ == 0);
  if (!primitives_.allFinite()) throw InputError("grasp wrench space: a primitive wrench is not finite");
  for (Eigen::Index first = 0; first < primitives_.cols(); first += per_contact_) {
    const double longest = primitives_.middleCols(first, per_contact_).colwise().norm().maxCoeff();
    radius_ = bound_ == ForceBound::kEach ? radius_ + longest : std::max(radius_, longest);
  }
}

WrenchVector GraspWrenchSpace::support(const WrenchVector& u) const {
  WrenchVector sum = WrenchVector::Zero();
  double farthest = 0.0;
  for (Eigen::Index first = 0; first < primitives_.cols(); first += per_contact_) {
    if (bound_ == ForceBound::kEach) farthest = 0.0;
    Eigen::Index best = -1;
    for (Eigen::Index k = first; k < first + per_contact_; ++k) {
      const double reach = primitives_.col(k).dot(u);
      if (reach > farthest) farthest = reach, best = k;
    }
    if (best < 0) continue;
    if (bound_ == ForceBound::kEach)
      sum += primitives_.col(best);
    else
      sum = primitives_.col(best);
  }
  return sum;
}

GraspPrimitives grasp_primitives(const ContactModel* model, std::span<const ContactFrame> contacts,
                                 int resolution, double length_m, std::string_view owner) {
  const ContactLimits* limits = model ? contact_limits(*model) : nullptr;
  if (!limits) {
    throw InputError(
        fmt::format("{}: {}; choose one that has limits, such as contact = \"hard_finger\" "
                    "(`preshape plugins --kind contact` lists the models)",
                    owner,
                    model ? "the contact model does not say what a contact can bear"
                          : "the grasp's contact model is not known"));
  }
  GraspPrimitives made;
  made.per_contact = limits->primitive_count(resolution);
  made.wrenches.resize(6, std::ssize(contacts) * made.per_contact);
  limits->primitive_wrenches(contacts, resolution, made.wrenches);
  for (Eigen::Index i = 0; i < made.wrenches.cols(); ++i) {
    const auto& contact = contacts[static_cast<std::size_t>(i / made.per_contact)];
    made.wrenches.col(i) =
        Wrench::from_vector(made.wrenches.col(i)).shifted(-contact.p_OC / length_m).vector();
  }
  if (!made.wrenches.allFinite())
    throw InputError(fmt::format("{}: a contact's wrench is not finite", owner));
  return made;
}

}  // namespace preshape
