#include <fstream>

#include "preshape/base/error.h"
#include "preshape/workbench/catalogue.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

namespace {

void put(const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << "return {}\n";
}

}  // namespace

TEST_CASE("Catalogue: the first folder that has a name wins, and names are sorted without repetition") {
  TemporaryDirectory mine, shipped;
  put(mine / "objects/mug/object.lua");
  put(mine / "objects/apple/object.lua");
  put(shipped / "objects/mug/object.lua");
  put(shipped / "objects/cube/object.lua");
  put(shipped / "hands/claw/hand.lua");
  put(shipped / "scripts/pretrain/cube.lua");
  std::filesystem::create_directories(shipped / "objects/shapes");  // a folder without a description is no object
  const Catalogue catalogue({mine.path(), shipped.path()});
  CHECK(catalogue.objects() == std::vector<std::string>{"apple", "cube", "mug"});
  CHECK(catalogue.hands() == std::vector<std::string>{"claw"});
  CHECK(catalogue.object("mug") == mine / "objects/mug/object.lua");
  CHECK(catalogue.object("cube") == shipped / "objects/cube/object.lua");
  CHECK(catalogue.hand("claw") == shipped / "hands/claw/hand.lua");
  CHECK(catalogue.script("pretrain/cube.lua") == shipped / "scripts/pretrain/cube.lua");
  CHECK(catalogue.module_roots() == std::vector<std::filesystem::path>{mine / "scripts", shipped / "scripts"});
}

TEST_CASE("Catalogue: an unknown name is told with the nearest one, or with those there are") {
  const Catalogue catalogue({PRESHAPE_SOURCE_DIR});
  CHECK_THROWS_SAYING(catalogue.object("mugg"), InputError, "there is no object 'mugg'; did you mean 'mug'?");
  CHECK_THROWS_SAYING(catalogue.object("zeppelin"), InputError, "there is no object 'zeppelin'; known: bottle, box, cone");
  CHECK_THROWS_SAYING(catalogue.object(""), InputError, "there is no object ''");
  CHECK_THROWS_SAYING(catalogue.hand("utah_mitt"), InputError, "there is no hand 'utah_mitt'; did you mean 'utah_mit'?");
  CHECK_THROWS_SAYING(catalogue.script("none.lua"), InputError, "there is no script 'none.lua' in the installation");
}

TEST_CASE("Catalogue: where no folder was found it points to the doctor") {
  const Catalogue nothing({"/nonexistent"});
  CHECK(nothing.objects().empty());
  CHECK_THROWS_SAYING(nothing.object("cube"), InputError, "there is no object 'cube'; no folder of them was found, see 'preshape doctor'");
}

TEST_CASE("Catalogue: every shipped object and hand is found by its name") {
  const Catalogue catalogue({PRESHAPE_SOURCE_DIR});
  CHECK(catalogue.objects().size() == 13);
  for (const auto& name : catalogue.objects()) CHECK(std::filesystem::exists(catalogue.object(name)));
  CHECK(catalogue.hands() == std::vector<std::string>{"allegro", "barrett", "leap", "shadow", "utah_mit"});
}

TEST_SUITE_END();
