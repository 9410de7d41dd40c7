#include "components.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

namespace {

constexpr const char* kBody = "return { scale = { farthest = 0, nearest = 1 }, compare = function() return 1 end }";

/// Why a file called x.plugin.lua is refused; "" when it is not.
std::string refusal(const std::string& text) {
  const OneComponent component("x", text);
  const LibraryRecord& library = component->libraries()[0];
  return library.reasons.empty() ? "" : library.reasons[0];
}

/// The same with the usual declaration of a similarity and `more` on its second line.
std::string refusal_with(const std::string& more) { return refusal(component_text("similarity", "x", kBody, more)); }

}  // namespace

TEST_CASE("Lua components: a declaration arrives as it was written") {
  const OneComponent component("similarity", "x", kBody,
                               "capabilities = { 'symmetric', 'rejects_nonfinite' }, parameters = {\n"
                               "{ name = 'flag', type = 'boolean', default = true, text = 'a flag' },\n"
                               "{ name = 'count', type = 'integer', default = 3, minimum = 1, text = 'a count' },\n"
                               "{ name = 'ratio', type = 'number', default = 0.5, minimum = 0, maximum = 1, unit = '1', text = 'a ratio' },\n"
                               "{ name = 'word', type = 'text', default = 'w', text = 'a word' },\n"
                               "{ name = 'way', type = 'choice', default = 'a', choices = { 'a', 'b' }, text = 'a way' },\n"
                               "{ name = 'list', type = 'numbers', default = { 1, 2.5 }, text = 'numbers' },\n"
                               "{ name = 'tree', type = 'table', text = 'a table' } },");
  const ComponentRecord& record = component->describe("similarity", "x");
  CHECK(record.language == "Lua");
  CHECK(record.version == "1.0.0");
  CHECK(record.licence == "MIT");
  CHECK(record.author == "A. Author");
  CHECK(record.summary == "One line");
  CHECK(record.capabilities == std::vector<std::string>{"symmetric", "rejects_nonfinite"});
  CHECK(record.schema.names() == std::vector<std::string>{"flag", "count", "ratio", "word", "way", "list", "tree"});
  const auto& d = record.schema.declarations();
  CHECK(d[0].type == ParameterType::kBoolean);
  CHECK(d[1].bounds_text() == ">= 1");
  CHECK(d[2].bounds_text() == "0 .. 1");
  CHECK(d[2].unit == "1");
  CHECK(d[3].default_value == Value("w"));
  CHECK(d[4].choices == std::vector<std::string>{"a", "b"});
  CHECK(d[5].default_value.items().size() == 2);
  CHECK(d[6].default_value.is_nil());
  CHECK_THROWS_SAYING(component->create<Similarity>("x"), InputError, "similarity 'x': 'tree' is missing");
  CHECK_THROWS_SAYING(component->create<Similarity>("x", Value::table({{"ratoi", 1}})), InputError,
                      "unknown key 'ratoi'; did you mean 'ratio'?");
}

TEST_CASE("Lua components: `new` is given the parameters, defaults filled in") {
  const OneComponent component(
      "similarity", "x",
      "assert(p.a == 2 and p.b == 'kept' and p.list[2] == 0.5, 'wrong parameters'); " + std::string(kBody),
      "parameters = { { name = 'a', type = 'integer', default = 1, text = 'a' }, { name = 'b', type = 'text', default = "
      "'kept', text = 'b' }, { name = 'list', type = 'numbers', default = {}, text = 'list' } },");
  CHECK_NOTHROW(component->create<Similarity>("x", Value::table({{"a", 2}, {"list", Value::numbers({1.0, 0.5})}})));
  CHECK_THROWS_SAYING(component->create<Similarity>("x", {}, {"scenario.lua", 9}), PluginError,
                      "scenario.lua:9: similarity 'x': ");
}

TEST_CASE("Lua components: every wrong declaration is refused with its file, its line and the mend") {
  CHECK(refusal("return 3").ends_with("x.plugin.lua: a component's file returns its declaration, a table, got number"));
  CHECK(refusal("return {").ends_with("x.plugin.lua:1: unexpected symbol near <eof>"));
  CHECK(refusal("local t = nil\nreturn t.x").find("x.plugin.lua:2: attempt to index a nil value") != std::string::npos);
  const std::string text = component_text("similarity", "x", kBody);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    return refusal(changed.replace(changed.find(from), from.size(), to));
  };
  CHECK(with("summary", "sumary").ends_with("x.plugin.lua:2: component: unknown key 'sumary'; did you mean 'summary'?"));
  CHECK(with("\"similarity\"", "\"similarty\"").ends_with("x.plugin.lua:1: component: 'kind' cannot be 'similarty'; did you mean 'similarity'?"));
  CHECK(with("\"similarity\"", "\"collision\"").find("x.plugin.lua:1: component: a collision backend cannot be written in Lua; write it in C++") != std::string::npos);
  CHECK(with("\"1.0.0\"", "1").ends_with("x.plugin.lua:1: component: 'version' must be a string, got number 1"));
  CHECK(with("author = \"A. Author\",", "").find("component: 'author' is missing") != std::string::npos);
  CHECK(with("\"One line\"", "\"\"").ends_with("x.plugin.lua:2: component: 'summary' is empty"));
  CHECK(with("\"1.0.0\"", "\"1.0.0-prerelease.17\"").ends_with("component: 'version' has 19 bytes, there is room for 15; shorten it"));
  CHECK(with("\"x\"", "\"y\"").ends_with("x.plugin.lua:1: component: its name is 'y' but its file is 'x.plugin.lua'; call the file 'y.plugin.lua'"));
  CHECK(with("\"x\"", "\"a/b\"").ends_with("component: 'a/b' is no name: letters, digits and '_' make one"));
  CHECK(with("new = function", "knew = function").find("unknown key 'knew'; did you mean 'new'?") != std::string::npos);
  CHECK(with("new = function(p)", "new = 3, old = function(p)").find("unknown key 'old'") != std::string::npos);
}

TEST_CASE("Lua components: wrong capabilities and parameters are refused with the nearest right one") {
  CHECK(refusal_with("capabilities = { 'symetric' },").ends_with("x.plugin.lua:2: component: a similarity cannot promise 'symetric'; did you mean 'symmetric'?"));
  CHECK(refusal_with("capabilities = { 'propagates_nonfinite' },").ends_with("component: Lua is given finite numbers alone; promise 'rejects_nonfinite' instead"));
  CHECK(refusal_with("capabilities = { 1 },").ends_with("component: a capability is a text, got 1"));
  CHECK(refusal_with("capabilities = 'symmetric',").find("'capabilities' must be a table, got string") != std::string::npos);
  const auto parameter = [](const std::string& inside) { return refusal_with("parameters = { { " + inside + " } },"); };
  CHECK(parameter("name = 'a', type = 'number', txt = 'a'").ends_with("x.plugin.lua:2: parameter 'a': unknown key 'txt'; did you mean 'text'?"));
  CHECK(parameter("name = 'a', type = 'nubmer', text = 'a'").ends_with("parameter 'a': 'type' cannot be 'nubmer'; did you mean 'number'?"));
  CHECK(parameter("name = 'a', type = 'number', default = 'b', text = 'a'").ends_with("parameter 'a': 'a' must be a number, got string \"b\""));
  CHECK(parameter("name = 'a', type = 'number', default = 3, maximum = 1, text = 'a'").ends_with("parameter 'a': 'a' must be <= 1, got 3"));
  CHECK(parameter("name = 'a', type = 'number', minimum = 2, maximum = 1, text = 'a'").ends_with("parameter 'a': 'minimum' is above 'maximum'"));
  CHECK(parameter("name = 'a', type = 'choice', default = 'b', text = 'a'").ends_with("a choice, and nothing else, has 'choices', a list of texts"));
  CHECK(parameter("type = 'number', text = 'a'").ends_with("parameter 1: 'name' is missing (of the parameter)"));
  CHECK(parameter("name = 'a', type = 'number', text = 'a' }, { name = 'a', type = 'text', text = 'b'").ends_with("parameter 'a': it is declared twice"));
}

TEST_CASE("Lua components: a file has no way to files, processes or an endless loop while it is scanned") {
  CHECK(refusal("local f = io.open('/etc/passwd')\nreturn {}").find("x.plugin.lua:1: 'io' is not there") != std::string::npos);
  CHECK(refusal("return os.exit(1)").find("x.plugin.lua:1: 'os' is not there") != std::string::npos);
  CHECK(refusal("while true do end").find("x.plugin.lua:1: stopped after 20000000 instructions") != std::string::npos);
  CHECK(refusal("local t = {}\nfor i = 1, 1e9 do t[i] = { i } end\nreturn t").find("x.plugin.lua:2: ") != std::string::npos);
}

TEST_CASE("Lua components: what `new` returns is checked, key by key") {
  const auto failure = [](const std::string& inside) -> std::string {
    const OneComponent component("similarity", "x", inside);
    try {
      component->create<Similarity>("x");
    } catch (const PluginError& problem) {
      return problem.what();
    }
    return "";
  };
  CHECK(failure("return 3").ends_with("x.plugin.lua:3: 'new' must return a table, got number"));
  CHECK(failure("return {\n comparre = function() return 1 end }").ends_with("x.plugin.lua:5: similarity 'x': unknown key 'comparre'; did you mean 'compare'?"));
  CHECK(failure("return { scale = { farthest = 0, nearest = 1 } }").ends_with("x.plugin.lua:4: similarity 'x': it needs one of the functions 'compare' and 'component', and only one"));
  CHECK(failure("return { compare = 4, scale = {} }").find("x.plugin.lua:4: similarity 'x': 'compare' must be a function, got number 4") != std::string::npos);
  CHECK(failure("return { compare = function() return 1 end }").find("'scale' is missing; give { farthest = 0, nearest = 1 }") != std::string::npos);
  CHECK(failure("return { compare = function() end, scale = { furthest = 0, nearest = 1 } }").find("similarity 'x', scale: unknown key 'furthest'; did you mean 'farthest'?") != std::string::npos);
  CHECK(failure("return { compare = function() end, scale = { farthest = 1, nearest = 1 } }").ends_with("similarity 'x': 'scale' has no length"));
  CHECK(failure("error('the sharpness is odd')").ends_with("x.plugin.lua:4: the sharpness is odd"));
}

TEST_SUITE_END();
