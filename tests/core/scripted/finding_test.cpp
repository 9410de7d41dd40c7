#include <algorithm>

#include "components.h"
#include "preshape/base/error.h"
#include "preshape/workbench/components.h"
#include "support/near.h"
#include "support/registry.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

namespace {

constexpr const char* kBody = "return { scale = { farthest = 0, nearest = 1 }, compare = function() return 1 end }";

std::filesystem::path shipped(const std::string& kind, const std::string& name) {
  return std::filesystem::path(PRESHAPE_BINARY_DIR) / "lib/preshape/plugins" / kind / (name + ".so");
}

bool any_line_has(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(), [&](const auto& line) { return line.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("Lua components: they are found beside shared objects, in a folder and one below, and by no other ending") {
  const TemporaryDirectory folder;
  std::filesystem::create_directories(folder / "below/deep");
  std::filesystem::copy_file(shipped("similarity", "tfvadi"), folder / "tfvadi.so");
  write_component(folder.path(), "here", component_text("similarity", "here", kBody));
  write_component(folder / "below", "below", component_text("similarity", "below", kBody));
  write_component(folder / "below/deep", "deep", component_text("similarity", "deep", kBody));
  std::ofstream(folder / "module.lua") << "error('never run')";
  std::ofstream(folder / ".plugin.lua") << "error('never run')";
  const Registry registry({{folder.path(), "test"}}, lua_loaders());
  CHECK(registry.names("similarity") == std::vector<std::string>{"below", "here", "tfvadi"});
  CHECK(registry.libraries().size() == 3);
  const Registry native_only(std::vector<SearchFolder>{{folder.path(), "test"}});
  CHECK(native_only.names("similarity") == std::vector<std::string>{"tfvadi"});
}

TEST_CASE("Lua components: a folder for sandboxed ones gives no shared object and nothing from below") {
  const TemporaryDirectory folder;
  std::filesystem::create_directories(folder / "below");
  std::filesystem::copy_file(shipped("similarity", "tfvadi"), folder / "tfvadi.so");
  write_component(folder.path(), "here", component_text("similarity", "here", kBody));
  write_component(folder / "below", "below", component_text("similarity", "below", kBody));
  const Registry registry({{folder.path(), "test", true}}, lua_loaders());
  CHECK(registry.names("similarity") == std::vector<std::string>{"here"});
}

TEST_CASE("Lua components: the first folder wins, in one folder the shared object, and the other is told as shadowed") {
  const TemporaryDirectory first, second;
  write_component(first.path(), "tfvadi", component_text("similarity", "tfvadi", kBody));
  std::filesystem::copy_file(shipped("similarity", "tfvadi"), second / "tfvadi.so");
  const Registry scripted_first({{first.path(), "first"}, {second.path(), "second"}}, lua_loaders());
  CHECK(scripted_first.describe("similarity", "tfvadi").language == "Lua");
  CHECK(scripted_first.libraries()[1].status == LibraryRecord::Status::kShadowed);
  CHECK(any_line_has(scripted_first.why("similarity", "tfvadi"), "similarity 'tfvadi' is already taken by"));
  CHECK(any_line_has(scripted_first.why("similarity", "tfvadi"), "  written in Lua"));
  write_component(second.path(), "tfvadi", component_text("similarity", "tfvadi", kBody));
  const Registry together({{second.path(), "second"}}, lua_loaders());
  CHECK(together.describe("similarity", "tfvadi").language == "C++");
  CHECK(together.libraries()[1].status == LibraryRecord::Status::kShadowed);
}

TEST_CASE("Lua components: a refused file tells why under its name, whatever is known of it, and the others stay usable") {
  const TemporaryDirectory folder;
  write_component(folder.path(), "fine", component_text("similarity", "fine", kBody));
  write_component(folder.path(), "half", component_text("similarity", "half", kBody, "autor = 'x',"));
  write_component(folder.path(), "torn", "return {\n  kind = \"contact\",\n  name = ");
  const Registry registry({{folder.path(), "test"}}, lua_loaders());
  CHECK(registry.names("similarity") == std::vector<std::string>{"fine"});
  CHECK_NOTHROW(registry.create<Similarity>("fine"));
  CHECK_THROWS_SAYING(registry.create<Similarity>("half"), PluginError, "half.plugin.lua:2: component: unknown key 'autor'; did you mean 'author'?");
  CHECK_THROWS_SAYING(registry.create<ContactModel>("torn"), PluginError, "torn.plugin.lua:3: unexpected symbol");
  CHECK(any_line_has(registry.why("contact", "torn"), "torn.plugin.lua:3: unexpected symbol"));
  CHECK_FALSE(any_line_has(registry.why("contact", "half"), "half.plugin.lua"));
  CHECK(registry.why("", "torn").back() == "result: no usable component 'torn'");
}

TEST_CASE("Lua components: a file that has changed since it was found is not used") {
  const TemporaryDirectory folder;
  write_component(folder.path(), "x", component_text("similarity", "x", kBody));
  const Registry registry({{folder.path(), "test"}}, lua_loaders());
  write_component(folder.path(), "x", component_text("contact", "x", kBody));
  CHECK_THROWS_SAYING(registry.describe("similarity", "x"), PluginError, "has been changed since it was found; start again");
}

TEST_CASE("Lua components: an object lives on when the registry and the file are gone") {
  std::shared_ptr<Similarity> similarity;
  {
    const OneComponent component("similarity", "x", kBody);
    similarity = component->create<Similarity>("x");
  }
  CHECK(similarity->scale(7).nearest == 1.0);
  const FuzzyPartition partition = FuzzyPartition::thesis();
  const Patterns q(partition, {1, 0, 0, 0, 0, 0});
  double score = 0.0;
  similarity->compare(q.view(), q.view(), {&score, 1});
  CHECK(score == 1.0);
}

TEST_CASE("Lua components: `require` reads modules beside the file and from the module roots, and only from there") {
  const TemporaryDirectory folder, roots;
  std::ofstream(folder / "near.lua") << "return 0.25";
  std::filesystem::create_directories(roots / "lib");
  std::ofstream(roots / "lib/far.lua") << "return 0.5";
  write_component(folder.path(), "x", "local sum = require('near') + require('lib.far')\n" +
                                          component_text("similarity", "x", "return { scale = { farthest = 0, nearest = 1 }, compare = function() return sum end }"));
  const Registry registry({{folder.path(), "test"}}, {std::make_shared<LuaLoader>(std::vector<std::filesystem::path>{roots.path()})});
  const FuzzyPartition partition = FuzzyPartition::thesis();
  const Patterns q(partition, {1, 0, 0, 0, 0, 0});
  double score = 0.0;
  registry.create<Similarity>("x")->compare(q.view(), q.view(), {&score, 1});
  CHECK(score == 0.75);
  const Registry rootless({{folder.path(), "test"}}, lua_loaders());
  CHECK(rootless.libraries()[0].reasons[0].find("x.plugin.lua:1: require: module 'lib.far' was not found") != std::string::npos);
}

TEST_CASE("component_folders: the scenario's own folder goes before the environment, the user's before the installation") {
  const TemporaryDirectory data;
  const Catalogue catalogue({data.path(), "/installed"});
  const std::vector<std::filesystem::path> first = {"/given"};
  const auto folders = component_folders(catalogue, first, "/somewhere/s.lua");
  const auto at = [&](const std::filesystem::path& path) {
    return std::find_if(folders.begin(), folders.end(), [&](const auto& folder) { return folder.path == path; }) - folders.begin();
  };
  CHECK(at("/given") == 0);
  CHECK(at("/somewhere") == 1);
  CHECK(folders[1].sandboxed_only);
  CHECK(folders[1].origin == "beside the scenario");
  CHECK(at(data / "scripts/components") < at(PRESHAPE_BINARY_DIR "/lib/preshape/plugins"));
  CHECK(at("/installed/scripts/components") == std::ssize(folders) - 1);
  CHECK(component_folders(catalogue, {}, "s.lua")[0].path == ".");
}

TEST_SUITE_END();
