#include "preshape/base/parameters.h"
#include "run.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/script");

TEST_CASE("Place: a misspelt key is told with the line of the key") {
  const Value v = run_text(R"(
-- a comment with contact = { mue = 1 }
return {
  object = "mug",
  contact = {
    "salisbury_soft_finger",
    mue = 0.8,
  },
})");
  const ParameterSchema schema("contact 'salisbury_soft_finger'",
                               {ParameterDeclaration::number("mu", 1, 0, 10, "1", "friction")});
  const std::vector<std::string> known = {"name"};
  CHECK(schema.check(*v.find("contact"), {}, known).at(0).text() ==
        "scenario.lua:7: contact 'salisbury_soft_finger': unknown key 'mue'; did you mean 'mu'?");
  CHECK(place_of(v, "contact.name") == "scenario.lua:6");
  CHECK(place_of(v, "contact") == "scenario.lua:5");
  CHECK(place_of(v, "") == "scenario.lua:3");
}

TEST_CASE("Place: a value on another line than its key has the line of the key") {
  const Value v = run_text("return {\n  a =\n\n    1,\n  ['b c']\n    = 2 }");
  CHECK(place_of(v, "a") == "scenario.lua:2");
  CHECK(place_of(v, "b c") == "scenario.lua:5");
}

TEST_CASE("Place: items of a list have each their line, whatever separates them") {
  const Value v = run_text("return {\n  1, 2;\n  { 3,\n    4 },\n  1 == nil,\n}");
  CHECK(v.items().size() == 4);
  CHECK(place_of(v, "1") == "scenario.lua:2");
  CHECK(place_of(v, "2") == "scenario.lua:2");
  CHECK(place_of(v, "3") == "scenario.lua:3");
  CHECK(place_of(v, "3.2") == "scenario.lua:4");
  CHECK(place_of(v, "4") == "scenario.lua:5");
}

TEST_CASE("Place: equal keys of different tables on one line or several are kept apart") {
  const Value v = run_text("return { a = { k = 1 }, b = { k = 2 },\n  c = { k = 3,\n  d = { k = 4 } } }");
  CHECK(place_of(v, "a.k") == "scenario.lua:1");
  CHECK(place_of(v, "c.k") == "scenario.lua:2");
  CHECK(place_of(v, "c.d.k") == "scenario.lua:3");
}

TEST_CASE("Place: strings, comments and long brackets that look like tables do not count") {
  const Value v = run_text(R"lua(--[==[ return { k = {
]] { ]==]
local s = "{ k = '\" -- {" .. '\'}' .. [[
{ k =
]] .. [=[ ]] { k = { ]=] --[[ { ]] --{
local t = "a\
b\z
   c{" .. "--[[" -- ]]
local result = { k = s .. t, -- k = 1
  l = "}" }
local other = { k = 1, l = 2 } --[=[ ]] } ]=]
return result
)lua");
  CHECK(v.find("k")->string() == "{ k = '\" -- {'}{ k =\n ]] { k = { a\nbc{--[[");
  CHECK(place_of(v, "k") == "scenario.lua:9");
  CHECK(place_of(v, "l") == "scenario.lua:10");
}

TEST_CASE("Place: line ends of every system count once") {
  const Value v = run_text("return {\r\n  a = 1,\r\n  s = 'x\\\r\ny',\r\n  b = 2,\n\r  c = 3,\r  d = 4 }");
  CHECK(place_of(v, "a") == "scenario.lua:2");
  CHECK(place_of(v, "b") == "scenario.lua:5");
  CHECK(place_of(v, "c") == "scenario.lua:6");
  CHECK(place_of(v, "d") == "scenario.lua:7");
}

TEST_CASE("Place: the first line may be for the shell, the first bytes a mark of the encoding") {
  CHECK(place_of(run_text("\xEF\xBB\xBFreturn {\n  a = 1 }"), "a") == "scenario.lua:2");
  CHECK(place_of(run_text("#!/usr/bin/env preshape\nreturn { a = 1 }"), "a") == "scenario.lua:2");
}

TEST_CASE("Place: functions inside a table do not disturb the keys around them") {
  const Value v = run_text(R"(return {
  on_report = function(r, ...)
    local t, u = { a = 1, b = 2 }, 3
    if r then return t, u elseif u then u = 1 else u = 2 end
    for i = 1, 2 do while i > 3 do repeat local x = { z = 1 } until x end end
    return function() return { c = 3 }, 4 end
  end,
  after = 5,
  (function() return 1, 2 end)() == 1 and "x", after_2 = 6 })");
  CHECK(place_of(v, "on_report") == "scenario.lua:2");
  CHECK(place_of(v, "after") == "scenario.lua:8");
  CHECK(place_of(v, "after_2") == "scenario.lua:9");
  CHECK(place_of(v, "name") == "scenario.lua:9");
}

TEST_CASE("Place: a table keeps its lines through variables, helpers, loops and calls") {
  const Value v = run_text(R"(
local function soft(mu)
  return { "soft",
    mu = mu }
end
local tasks = {}
for i = 1, 2 do
  tasks[#tasks + 1] = {
    fit = i }
end
local shared = { k = 1 }
return setmetatable({
  contact = soft(0.5), tasks = tasks,
  shared = shared,
}, {}))");
  CHECK(place_of(v, "contact") == "scenario.lua:13");
  CHECK(place_of(v, "contact.mu") == "scenario.lua:4");
  CHECK(place_of(v, "tasks.2") == "scenario.lua:8");
  CHECK(place_of(v, "tasks.2.fit") == "scenario.lua:9");
  CHECK(place_of(v, "shared.k") == "scenario.lua:11");
}

TEST_CASE("Place: all forms of a call with a table keep its lines and its meaning") {
  const Value v = run_text(R"(
local function id(t) return t end
local function two() return id end
local o = { id = function(_, t) return t end, list = { id } }
return {
  id{ a = 1 }, id({
    a = 2 }), (id){
    a = 3 }, o:id{
    a = 4 }, o.list[1]{
    a = 5 }, id(id){ a = id{
    a = 6 } },
  #{ 1, 2 }, id{}, two"x"{
    a = 7 }, id(function() return { a = 8 } end)(),
})");
  CHECK(v.items().size() == 10);
  CHECK(place_of(v, "1.a") == "scenario.lua:6");
  CHECK(place_of(v, "2.a") == "scenario.lua:7");
  CHECK(place_of(v, "3.a") == "scenario.lua:8");
  CHECK(place_of(v, "4.a") == "scenario.lua:9");
  CHECK(place_of(v, "5.a") == "scenario.lua:10");
  CHECK(place_of(v, "6.a.a") == "scenario.lua:11");
  CHECK(v.items()[6] == Value(2));
  CHECK(place_of(v, "9.a") == "scenario.lua:13");
  CHECK(place_of(v, "10.a") == "scenario.lua:13");
}

TEST_CASE("Place: a key that an assignment sets has the line of the assignment") {
  const Value v = run_text(R"(
local s = { contact = { mu = 1 }, task = { fit = 0 } }
s.contact.mu = 3
s.contact["ka"] = 4
s.quality = {}
s.quality.weight = 5
local task = s.task
task.fit = 6
function s.on_report() end
function s:on_end() end
local t = setmetatable({ a = --[[ not { here ]] { k = 1 } }, {})
t.a.k = 2
s.t = t
local other = { mu = 0, ka = 0, weight = 0, fit = 0, on_report = 0, on_end = 0, k = 0 }
s.other = other
return s)");
  CHECK(place_of(v, "contact") == "scenario.lua:2");
  CHECK(place_of(v, "contact.mu") == "scenario.lua:3");
  CHECK(place_of(v, "contact.ka") == "scenario.lua:4");
  CHECK(place_of(v, "quality.weight") == "scenario.lua:6");
  CHECK(place_of(v, "task.fit") == "scenario.lua:8");
  CHECK(place_of(v, "on_report") == "scenario.lua:9");
  CHECK(place_of(v, "on_end") == "scenario.lua:10");
  CHECK(place_of(v, "t.a") == "scenario.lua:11");
  CHECK(place_of(v, "t.a.k") == "scenario.lua:12");
  CHECK(place_of(v, "other.k") == "scenario.lua:14");
}

TEST_CASE("Place: an assignment to another variable of the same name leaves the table's lines alone") {
  const Value v = run_text(R"(
local s = { mu = 1, ko = 2, ka = 3 }
local function other(s) s.mu = 3 return s end
do local s = { mu = 4 } s.ko = 5 end
for _, s in ipairs({}) do s.mu = 6 end
s.ka = 7
local t <const> = { mu = 8 }
local u
local a = 1 local b = a < a u = { mu = 9 }
u.mu = 10
return { s = s, t = t, u = u, f = other, mu = 1, ko = 2, ka = 3 })");
  CHECK(place_of(v, "s.mu") == "scenario.lua:2");
  CHECK(place_of(v, "s.ko") == "scenario.lua:2");
  CHECK(place_of(v, "s.ka") == "scenario.lua:6");
  CHECK(place_of(v, "t.mu") == "scenario.lua:7");
  CHECK(place_of(v, "u.mu") == "scenario.lua:10");
}

TEST_CASE(
    "Place: a key that no constructor explains falls back to the last line that writes it, then to what "
    "holds it") {
  const Value v = run_text(R"(
local key = "mu"
local other = { ko = 1 }
local function set(t)
  t.ko = 2
end
local s = {
  contact = {},
}
s.contact[key] = 1
set(s.contact);
(function() return s.contact end)().eta = 2
return s)");
  CHECK(place_of(v, "contact.ko") == "scenario.lua:5");
  CHECK(place_of(v, "contact.mu") == "scenario.lua:8");
  CHECK(place_of(v, "contact.eta") == "scenario.lua:12");
}

TEST_CASE("Place: a table that a module made has the lines of the module's file") {
  const TemporaryDirectory folder;
  write_file(folder / "lib/gentle.lua", "\n\nreturn {\n  contact = { mu = 1,\n    ka = 2 } }");
  write_file(folder / "scenario.lua",
             "local gentle = require('lib.gentle')\nreturn {\n  contact = gentle.contact }");
  const Value v = Script(folder / "scenario.lua").run();
  CHECK(place_of(v, "contact") == (folder / "scenario.lua").string() + ":3");
  CHECK(place_of(v, "contact.ka") == "lib/gentle.lua:5");
}

TEST_CASE("Place: a script with an _ENV of its own runs unmarked and falls back to the names of keys") {
  const Value v = run_text("local _ENV = { f = type }\nreturn {\n  a = f({}) }");
  CHECK(v.find("a")->string() == "table");
  CHECK(place_of(v, "a") == "scenario.lua:3");
}

TEST_CASE("Place: tables nested deeper than marks allow still load") {
  const std::string deep(150, '{'), close(150, '}');
  CHECK(run_text("local t = " + deep + close + "\nreturn { k = #t }").find("k")->integer() == 1);
}

TEST_CASE("Place: what is handed to the host and back keeps its lines") {
  Script script = Script::from_text(
      "local s = preshape.scenario {\n  a = {\n    1,\n    2 } }\ns.b = 3\nreturn s", "s.lua");
  script.add_function("scenario", "(t: table): table", "checks a scenario",
                      [](auto arguments, const auto& caller) {
                        CHECK(caller.text() == "s.lua:1");
                        CHECK(place_of(arguments[0], "a") == "s.lua:2");
                        return arguments[0];
                      });
  const Value v = script.run();
  CHECK(place_of(v, "a.2") == "s.lua:4");
  CHECK(place_of(v, "b") == "s.lua:5");
}

TEST_SUITE_END();
