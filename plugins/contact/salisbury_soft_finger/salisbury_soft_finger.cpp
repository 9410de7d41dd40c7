#include "preshape/base/require.h"
#include "preshape/contact/contact_model.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ContactFrame;
using preshape::ParameterDeclaration;
using preshape::Wrench;

/// Salisbury's soft finger, weighted as in thesis eq. 3.6.5:
///   f = Ka a + Kn n + Ko t,   m = Mn n
/// with the approach axis a as it is, not its part in the contact plane, unless `project_approach` asks for that.
/// The unit wrenches are the forces along a, t and n and the moment about n (eq. 3.6.6).
class SalisburySoftFinger final : public preshape::ContactModel {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("ka", 0.45, 0.0, 10.0, "1", "force along the approach axis, share of the normal force"),
            ParameterDeclaration::number("ko", 0.25, 0.0, 10.0, "1", "force along t = n x a, share of the normal force"),
            ParameterDeclaration::number("kn", 1.0, 0.0, 10.0, "1", "normal force"),
            ParameterDeclaration::number("mn", 0.8, 0.0, 10.0, "1", "moment about the normal, over normal force times L"),
            ParameterDeclaration::flag("project_approach", false, "use the approach axis' part in the contact plane")};
  }
  static std::vector<std::string> capabilities() { return {"frame_covariant", "friction", "propagates_nonfinite"}; }

  explicit SalisburySoftFinger(const preshape::Parameters& p)
      : ka_(p.number("ka")), ko_(p.number("ko")), kn_(p.number("kn")), mn_(p.number("mn")),
        project_(p.flag("project_approach")) {}

  int basis_size() const noexcept override { return 4; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<preshape::WrenchBasis> basis) const override {
    preshape::require_size("columns of the basis", contacts.size() * 4, static_cast<std::size_t>(basis.cols()));
    basis.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      basis.col(column++).head<3>() = approach(C);
      basis.col(column++).head<3>() = C.t;
      basis.col(column++).head<3>() = C.n;
      basis.col(column++).tail<3>() = C.n;
    }
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const ContactFrame& C = contacts[i];
      F_C_O[i] = Wrench(ka_ * approach(C) + kn_ * C.n + ko_ * C.t, mn_ * C.n);
    }
  }

 private:
  Eigen::Vector3d approach(const ContactFrame& C) const {
    return project_ ? Eigen::Vector3d(C.a - C.a.dot(C.n) * C.n) : C.a;
  }

  double ka_, ko_, kn_, mn_;
  bool project_;
};

}  // namespace

PRESHAPE_PLUGIN(({"salisbury_soft_finger", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Salisbury's soft finger with the thesis's weights"}),
                ({"contact/salisbury_soft_finger"}),
                preshape::component<SalisburySoftFinger>("salisbury_soft_finger",
                                                         "Soft finger weighted by Ka, Ko, Kn, Mn (thesis eq. 3.6.5)"))
