#include "components.h"
#include "preshape/base/error.h"
#include "preshape/contact/contact_limits.h"
#include "preshape/contact/wrench_union.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

namespace {

constexpr const char* kPoint = "basis_size = 1, basis = function(C) return { { C.n[1], C.n[2], C.n[3], 0, 0, 0 } } end";

ContactFrame random_contact(Random& random) {
  const Eigen::Vector3d p = random_vector(random), n = random_unit(random);
  return ContactFrame::at(p, n, random_unit(random));
}

std::string failing(const std::string& inside) {
  const OneComponent component("contact", "x", inside);
  const ContactFrame C = ContactFrame::at({0.5, 0, 0}, {0, 1, 0}, {1, 0, 0});
  try {
    const auto model = component->create<ContactModel>("x");
    WrenchBasis basis(6, model->basis_size());
    model->wrench_basis({&C, 1}, basis);
    Wrench F;
    model->pattern_wrenches({&C, 1}, {&F, 1});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Lua contact: the twin of Salisbury's soft finger gives its wrenches") {
  const OneComponent twin(
      "contact", "x",
      "local function six(f, m) return { f[1], f[2], f[3], m[1], m[2], m[3] } end\n"
      "local zero = { 0, 0, 0 }\n"
      "return { basis_size = 4,\n"
      "  basis = function(C) return { six(C.a, zero), six(C.t, zero), six(C.n, zero), six(zero, C.n) } end,\n"
      "  pattern = function(C)\n"
      "    local f = {}\n"
      "    for i = 1, 3 do f[i] = 0.45 * C.a[i] + 1.0 * C.n[i] + 0.25 * C.t[i] end\n"
      "    return f[1], f[2], f[3], 0.8 * C.n[1], 0.8 * C.n[2], 0.8 * C.n[3]\n"
      "  end }");
  const auto scripted = twin->create<ContactModel>("x"), compiled = registry().create<ContactModel>("salisbury_soft_finger");
  Random random(3);
  std::vector<ContactFrame> contacts;
  for (int i = 0; i < 50; ++i) contacts.push_back(random_contact(random));
  CHECK(wrench_union(*scripted, contacts, 0.18) == wrench_union(*compiled, contacts, 0.18));
  std::vector<Wrench> a(contacts.size()), b(contacts.size());
  scripted->pattern_wrenches(contacts, a);
  compiled->pattern_wrenches(contacts, b);
  for (std::size_t i = 0; i < a.size(); ++i) CHECK_NEAR(a[i].vector(), b[i].vector(), 4 * kEps);
  CHECK(scripted->extension(ContactLimits::kId) == nullptr);
}

TEST_CASE("Lua contact: hard_finger_lua bears what lies in Coulomb's cone, and its primitive wrenches lie on it") {
  const auto model = registry().create<ContactModel>("hard_finger_lua", Value::table({{"mu", 0.6}}));
  const ContactLimits* limits = contact_limits(*model);
  REQUIRE(limits != nullptr);
  CHECK(limits->primitive_count(8) == 8);
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const ContactFrame C = random_contact(random);
    WrenchBasis edges(6, 8);
    limits->primitive_wrenches({&C, 1}, 8, edges);
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector3d f = edges.col(k).head<3>();
      CHECK_NEAR(f.dot(C.n), 1.0, 8 * kEps);
      CHECK_NEAR((f - C.n).norm(), 0.6, 8 * kEps);
      CHECK(edges.col(k).tail<3>().norm() == 0.0);
      CHECK(limits->admits(C, {0.999 * (f - C.n) + C.n, Eigen::Vector3d::Zero()}, 0.0));
      CHECK_FALSE(limits->admits(C, {1.001 * (f - C.n) + C.n, Eigen::Vector3d::Zero()}, 0.0));
    }
    CHECK_FALSE(limits->admits(C, {-C.n, Eigen::Vector3d::Zero()}, 0.1));
    CHECK_FALSE(limits->admits(C, {C.n, 0.2 * C.n}, 0.1));
    Wrench F;
    model->pattern_wrenches({&C, 1}, {&F, 1});
    CHECK(limits->admits(C, F, 0.0));
    WrenchBasis basis(6, 3);
    model->wrench_basis({&C, 1}, basis);
    CHECK_NEAR(basis.topRows<3>().transpose() * basis.topRows<3>(), Eigen::Matrix3d::Identity(), 8 * kEps);
  }
  const auto smooth = registry().create<ContactModel>("hard_finger_lua", Value::table({{"mu", 0}}));
  CHECK(contact_limits(*smooth)->primitive_count(8) == 1);
  const ContactFrame C = random_contact(random);
  WrenchBasis edges(6, 2);
  const ContactFrame odd = ContactFrame::at({0, 0, std::nan("")}, {0, 1, 0}, {1, 0, 0});
  Wrench F;
  CHECK_THROWS_SAYING(model->pattern_wrenches({&odd, 1}, {&F, 1}), InputError, "contact 'hard_finger_lua': p of a contact must be finite, got (0, 0, nan)");
  CHECK_THROWS_SAYING(limits->primitive_wrenches({&C, 1}, 2, edges), InputError, "the resolution must be at least 3, got 2");
}

TEST_CASE("Lua contact: wrong keys and results are errors with component, file, line and contact") {
  const std::string contact = " for the contact with p = (0.5, 0, 0), n = (0, 1, 0), a = (1, 0, 0)";
  const auto with = [](const std::string& pattern) { return failing("return { " + std::string(kPoint) + ",\n pattern = " + pattern + " }"); };
  CHECK(with("function() return 1, 2, 3 end").ends_with("x.plugin.lua:5: contact 'x': 'pattern' must return a list of 6 finite numbers, got number 1" + contact));
  CHECK(with("function() return { 1, 2, 3, 4, 5, math.huge } end").ends_with("a list of 6 finite numbers, got item 6 = number inf" + contact));
  CHECK(with("function() return { 1, 2, 3, 4, 5, 6, 7 } end").ends_with("a list of 6 finite numbers, got 7 items" + contact));
  CHECK(with("function() return { 1, 2, 3, 4, 5, 6 } end").empty());
  CHECK(failing("return { basis_size = 2, basis = function() return { { 0, 0, 0, 0, 0, 0 } } end, pattern = print }").ends_with("'basis' must return a list of 2 wrenches, got 1" + contact));
  CHECK(failing("return { basis_size = 0, basis = print, pattern = print }").ends_with("x.plugin.lua:4: contact 'x': 'basis_size' must be in 1 .. 64, got 0"));
  CHECK(failing("return { basis = print, pattern = print }").find("contact 'x': 'basis_size' is missing") != std::string::npos);
  CHECK(failing("return { basis_size = 1, basis = print }").ends_with("contact 'x': the function 'pattern' is missing"));
  CHECK(failing("return { basis_size = 1, basis = print, pattern = print, admits = print }").ends_with("'primitives' and 'admits' go together; give both or neither"));
}

TEST_SUITE_END();
