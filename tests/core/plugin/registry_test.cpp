#include <algorithm>
#include <cstdlib>

#include "fixtures.h"
#include "preshape/base/error.h"
#include "support/near.h"
#include "support/registry.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/plugin");

namespace {

/// Sets an environment variable for a scope.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    setenv(name, value.c_str(), 1);
  }
  ~Environment() {
    if (old_.empty()) {
      unsetenv(name_);
    } else {
      setenv(name_, old_.c_str(), 1);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::string old_;
};

bool any_line_has(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("Registry: it finds libraries in a folder and one below, and not deeper") {
  const TemporaryDirectory folder;
  std::filesystem::create_directories(folder / "contact/deep");
  std::filesystem::copy_file(fixture_file("marks"), folder / "marks.so");
  std::filesystem::copy_file(fixture_file("family"), folder / "contact/family.so");
  std::filesystem::copy_file(fixture_file("throws"), folder / "contact/deep/throws.so");
  const Registry registry = registry_of(folder.path());
  CHECK(registry.libraries().size() == 2);
  const std::vector<ComponentKey> expected = {{"contact", "normal"}, {"similarity", "marks"}, {"similarity", "zero"}};
  CHECK(registry.components() == expected);  // in the order of the kinds, then by name
  CHECK(registry.names("similarity") == std::vector<std::string>{"marks", "zero"});
  CHECK(registry.has("contact", "normal"));
  CHECK_FALSE(registry.has("contact", "zero"));
  CHECK_FALSE(registry.has("similarity", "marks "));
}

TEST_CASE("Registry: a folder that is not there, and one named twice, change nothing") {
  const auto folder = fixture_file("family").parent_path();
  const Registry registry({{"/nowhere/at/all", "test"}, {folder, "first"}, {folder, "second"}});
  CHECK(registry.libraries().size() == 1);
  CHECK(registry.libraries()[0].origin == "first");
  CHECK(registry.folders().size() == 3);
}

TEST_CASE("Registry: a link to a library that was found already is the same library") {
  const TemporaryDirectory folder;
  std::filesystem::create_symlink(fixture_file("family"), folder / "again.so");
  std::filesystem::create_symlink("/nowhere/at/all.so", folder / "dangling.so");
  const Registry registry({{fixture_file("family").parent_path(), "first"}, {folder.path(), "second"}});
  CHECK(registry.libraries().size() == 1);
}

TEST_CASE("Registry: the first folder wins, and the library behind it is reported as shadowed") {
  const TemporaryDirectory first, second;
  std::filesystem::copy_file(fixture_file("family"), first / "family.so");
  std::filesystem::copy_file(fixture_file("family"), second / "family.so");
  const Registry registry({{first.path(), "first"}, {second.path(), "second"}});
  REQUIRE(registry.libraries().size() == 2);
  CHECK(registry.libraries()[0].status == LibraryRecord::Status::kUsable);
  CHECK(registry.libraries()[1].status == LibraryRecord::Status::kShadowed);
  CHECK(any_line_has(registry.libraries()[1].reasons,
                     "contact 'normal' is already taken by '" + std::filesystem::canonical(first / "family.so").string()));
  CHECK(registry.describe("contact", "normal").file == std::filesystem::canonical(first / "family.so"));
}

TEST_CASE("Registry: a library that loses one of its components keeps the others") {
  const TemporaryDirectory first, second;
  write_tampered("marks", first / "marks.so", [](Manifest& m) { std::strcpy(m.components[0], "similarity/zero"); });
  std::filesystem::copy_file(fixture_file("family"), second / "family.so");
  const Registry registry({{first.path(), "first"}, {second.path(), "second"}});
  CHECK(registry.libraries()[1].status == LibraryRecord::Status::kUsable);
  CHECK(any_line_has(registry.libraries()[1].reasons, "similarity 'zero' is already taken"));
  CHECK(registry.describe("contact", "normal").plugin == "family");
}

TEST_CASE("Registry: a description is what the author declared") {
  const Registry registry = registry_of_fixture("family");
  const ComponentRecord& record = registry.describe("contact", "normal");
  CHECK(record.summary == "The normal force alone");
  CHECK(record.capabilities == std::vector<std::string>{"frame_covariant"});
  CHECK(record.schema.names() == std::vector<std::string>{"stiffness"});
  CHECK(record.schema.owner() == "contact 'normal'");
  CHECK(record.plugin == "family");
  CHECK(record.version == "1.2.0");
  CHECK(record.licence == "MIT");
  CHECK(record.author == "A. Author");
  CHECK(&registry.describe("contact", "normal") == &record);
}

TEST_CASE("Registry: components are made with the parameters given and defaults for the rest") {
  const Registry registry = registry_of_fixture("family");
  const ContactFrame C = ContactFrame::at({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  std::vector<Wrench> W(1);
  registry.create<ContactModel>("normal")->pattern_wrenches({&C, 1}, W);
  CHECK(W[0].force().y() == 1.0);
  registry.create<ContactModel>("normal", Value::table({{"stiffness", 3}}))->pattern_wrenches({&C, 1}, W);
  CHECK(W[0].force().y() == 3.0);
  CHECK(registry.create<Similarity>("zero")->scale(7).nearest == 1.0);
}

TEST_CASE("Registry: a wrong parameter is told with its place, its owner and the nearest right one") {
  const Registry registry = registry_of_fixture("family");
  Value misspelt(2.0);
  misspelt.at({"scenario.lua", 8});
  const Value given = Value::table({{"stifness", misspelt}});
  CHECK_THROWS_SAYING(registry.create<ContactModel>("normal", given, {"scenario.lua", 3}), InputError,
                      "scenario.lua:8: contact 'normal': unknown key 'stifness'; did you mean 'stiffness'?");
  CHECK_THROWS_SAYING(registry.create<ContactModel>("normal", Value::table({{"stiffness", -1}}), {"scenario.lua", 3}),
                      InputError, "scenario.lua:3: contact 'normal': 'stiffness' must be in 0 .. 10, got -1");
  CHECK_THROWS_SAYING(registry.create<ContactModel>("normal", Value::table({{"stiffness", "hard"}})), InputError,
                      "'stiffness' must be a number, got string \"hard\"");
  CHECK_THROWS_SAYING(registry.create<Similarity>("zero", Value::table({{"x", 1}})), InputError,
                      "similarity 'zero': unknown key 'x'; it has no parameters");
}

TEST_CASE("Registry: what is not there is named with the nearest that is") {
  const Registry registry = registry_of_fixture("family");
  CHECK_THROWS_SAYING(registry.create<ContactModel>("normall"), PluginError,
                      "there is no contact 'normall'; did you mean 'normal'?");
  CHECK_THROWS_SAYING(registry.describe("contact", "zero"), PluginError, "there is no contact 'zero'; known: normal");
  CHECK_THROWS_SAYING(registry.describe("similarty", "zero"), PluginError,
                      "there is no kind 'similarty'; did you mean 'similarity'?");
  CHECK_THROWS_SAYING(registry.create<HandModel>("dh"), PluginError,
                      "there is no plugin of kind 'hand' on the search path");
}

TEST_CASE("Registry: the search path runs from the command line over the environment and the user to the installation") {
  const Environment path("PRESHAPE_PLUGIN_PATH", "/one::/two"), data("XDG_DATA_HOME", "/data");
  const std::vector<std::filesystem::path> first = {"/given"};
  const auto folders = default_search_folders(first);
  REQUIRE(folders.size() == 5);
  const std::vector<std::string> expected = {"/given", "/one", "/two", "/data/preshape/plugins",
                                             PRESHAPE_BINARY_DIR "/lib/preshape/plugins"};
  const std::vector<std::string> origins = {"--plugin-path", "PRESHAPE_PLUGIN_PATH", "PRESHAPE_PLUGIN_PATH", "user",
                                            "installation"};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(folders[i].path == std::filesystem::path(expected[i]));
    CHECK(folders[i].origin == origins[i]);
  }
}

TEST_CASE("Registry: why tells every folder, every library of that name, what was decided and the host") {
  const TemporaryDirectory refused, second;
  write_tampered("family", refused / "family.so", [](Manifest& m) { m.fingerprint.sdk_major = 41; });
  std::filesystem::copy_file(fixture_file("family"), second / "family.so");
  write_bytes(second / "damaged.so", read_bytes(fixture_file("family")).substr(0, 5000));
  const Registry registry({{"/nowhere/at/all", "user"}, {refused.path(), "first"}, {second.path(), "second"}});
  const auto lines = registry.why("contact", "normal");
  const auto path = [](const std::filesystem::path& p) { return std::filesystem::canonical(p).string(); };
  CHECK(lines[0] == "folder /nowhere/at/all (user): not there");
  CHECK(any_line_has(lines, "(first)"));
  CHECK(any_line_has(lines, "library " + path(refused / "family.so") + " (family 1.2.0): refused"));
  CHECK(any_line_has(lines, "  SDK major version: plugin 41, host 0; rebuild the plugin"));
  CHECK(any_line_has(lines, "library " + path(second / "family.so") + " (family 1.2.0): usable"));
  CHECK(any_line_has(lines, "library " + path(second / "damaged.so") + ": refused"));
  CHECK(any_line_has(lines, "host       SDK 0.1, "));
  CHECK(lines.back() == "result: " + path(second / "family.so") + " is used");
  CHECK(registry.why("contact", "nobody").back() == "result: no usable contact 'nobody'");
}

TEST_CASE("Registry: every shipped component can be described, and its parameters have a text and a default or need one") {
  for (const auto& [kind, name] : registry().components()) {
    INFO(kind, " ", name);
    const ComponentRecord& record = registry().describe(kind, name);
    CHECK_FALSE(record.summary.empty());
    CHECK_FALSE(record.licence.empty());
    for (const auto& parameter : record.schema.declarations()) CHECK_FALSE(parameter.text.empty());
  }
  for (const auto& library : registry().libraries()) {
    INFO(library.file.string());
    CHECK(library.status == LibraryRecord::Status::kUsable);
  }
}

TEST_SUITE_END();
