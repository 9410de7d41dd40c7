#include <thread>

#include "fixtures.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/plugin");

TEST_CASE("Lifetime: an object keeps its library mapped when the registry is gone, and the last one lets it go") {
  const TemporaryDirectory folder;
  const auto file = folder / "family.so";
  std::filesystem::copy_file(fixture_file("family"), file);
  auto registry = std::make_unique<Registry>(std::vector<SearchFolder>{{folder.path(), "test"}});
  CHECK_FALSE(mapped(file));
  auto contact = registry->create<ContactModel>("normal", Value::table({{"stiffness", 2}}));
  auto similarity = registry->create<Similarity>("zero");
  registry.reset();
  CHECK(mapped(file));
  contact.reset();
  CHECK(mapped(file));
  CHECK(similarity->scale(7).nearest == 1.0);
  similarity.reset();
  CHECK_FALSE(mapped(file));
}

TEST_CASE("Lifetime: a library can be loaded and let go of many times") {
  const TemporaryDirectory folder;
  const auto file = folder / "family.so";
  std::filesystem::copy_file(fixture_file("family"), file);
  for (int i = 0; i < 50; ++i) {
    CHECK(registry_of(folder.path()).create<Similarity>("zero")->scale(7).nearest == 1.0);
    CHECK_FALSE(mapped(file));
  }
}

TEST_CASE("Lifetime: threads may describe and make components of one registry at once") {
  const Registry registry = registry_of_fixture("family");
  std::vector<std::thread> threads;
  std::vector<double> forces(8, 0.0);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    threads.emplace_back([&, i] {
      const ContactFrame C = ContactFrame::at({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
      for (int k = 0; k < 50; ++k) {
        const auto contact = registry.create<ContactModel>("normal", Value::table({{"stiffness", static_cast<int>(i)}}));
        Wrench W;
        contact->pattern_wrenches({&C, 1}, {&W, 1});
        forces[i] = W.force().y();
      }
    });
  }
  for (auto& thread : threads) thread.join();
  for (std::size_t i = 0; i < forces.size(); ++i) CHECK(forces[i] == static_cast<double>(i));
}

#if defined(PRESHAPE_AVX2_FIXTURES)
TEST_CASE("Lifetime: plugins built for AVX2 and FMA work beside a host that was not") {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    MESSAGE("skipped: this processor has no AVX2 and FMA");
    return;
  }
  const Registry contact_registry = registry_of_fixture("avx2_contact"), hand_registry = registry_of_fixture("avx2_hand");
  CHECK((contact_registry.libraries()[0].manifest.fingerprint.instruction_set & 6u) == 6u);

  Random random(31);
  const auto wide = contact_registry.create<ContactModel>("salisbury_soft_finger");
  const auto stock = registry().create<ContactModel>("salisbury_soft_finger");
  std::vector<ContactFrame> contacts;
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector3d p = random_vector(random), n = random_unit(random);
    contacts.push_back(ContactFrame::at(p, n, random_unit(random)));
  }
  WrenchBasis wide_basis(6, 20), stock_basis(6, 20);
  wide->wrench_basis(contacts, wide_basis);
  stock->wrench_basis(contacts, stock_basis);
  CHECK_NEAR(wide_basis, stock_basis, 8 * kEps);
  std::vector<Wrench> wide_wrenches(5), stock_wrenches(5);
  wide->pattern_wrenches(contacts, wide_wrenches);
  stock->pattern_wrenches(contacts, stock_wrenches);
  for (std::size_t i = 0; i < 5; ++i) CHECK_NEAR(wide_wrenches[i].vector(), stock_wrenches[i].vector(), 8 * kEps);

  Value joint = Value::table({{"name", "j"}, {"a", 1}, {"alpha", 0.5}, {"limits", Value::numbers({-1, 1})}});
  Value finger = Value::table({{"name", "index"}, {"role", "index"}, {"base", Value::table({})},
                               {"joints", Value::list({joint})}});
  const Value description = Value::table({{"unit_length", 0.03}, {"finger_spacing", 1}, {"maximum_opening", 1},
                                          {"base_width", 1}, {"fingers", Value::list({finger})}});
  const auto hand = hand_registry.create<HandModel>("dh", Value::table({{"description", description}}));
  std::vector<Pose> poses_H(3);
  const std::vector<double> q = {0.25};
  hand->forward(0, q, poses_H);
  CHECK_NEAR(poses_H.back().p, Eigen::Vector3d(std::cos(0.25), std::sin(0.25), 0), 8 * kEps);
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, 1);
  hand->jacobian(0, q, J);
  CHECK_NEAR(J, (Eigen::Matrix<double, 6, 1>() << -std::sin(0.25), std::cos(0.25), 0, 0, 0, 1).finished(), 8 * kEps);
}
#endif

TEST_SUITE_END();
