#include "preshape/contact/wrench_union.h"

#include "preshape/base/assert.h"

namespace preshape {

WrenchUnion wrench_union(const ContactModel& model, std::span<const ContactFrame> contacts, double length_m) {
  const int size = model.basis_size();
  const auto count = static_cast<Eigen::Index>(contacts.size());
  WrenchBasis basis(6, count * size);
  model.wrench_basis(contacts, basis);
  WrenchUnion rows(count * size, 6);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d p_CO_normalised = -contacts[static_cast<std::size_t>(i)].p_OC / length_m;
    for (Eigen::Index k = i * size; k < (i + 1) * size; ++k) {
      rows.row(k) = Wrench::from_vector(basis.col(k)).shifted(p_CO_normalised).vector().transpose();
    }
  }
  return rows;
}

Wrench resultant_wrench(std::span<const ContactFrame> contacts, std::span<const Wrench> F_C_O, double length_m) {
  PRESHAPE_DEMAND(contacts.size() == F_C_O.size());
  Wrench F_O;
  for (std::size_t i = 0; i < contacts.size(); ++i) F_O += F_C_O[i].shifted(-contacts[i].p_OC / length_m);
  return F_O;
}

}  // namespace preshape
