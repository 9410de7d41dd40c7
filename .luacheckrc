-- Lua sources of preshape: modules, scenarios, studies, hands, objects, components.
std = "lua54"
max_line_length = 120
ignore = { "581" } -- not (x > y) is not x <= y where NaN may come
exclude_files = { "build", "**/build", "scripts/meta" }

-- What a script sees that runs in preshape without --trust.
stds.preshape = {
  read_globals = {
    "_G", "_VERSION", "assert", "collectgarbage", "error", "getmetatable", "ipairs", "load", "next", "pairs",
    "pcall", "print", "rawequal", "rawget", "rawlen", "rawset", "require", "select", "setmetatable", "tonumber",
    "tostring", "type", "xpcall",
    coroutine = {
      fields = { "close", "create", "isyieldable", "resume", "running", "status", "wrap", "yield" },
    },
    math = {
      fields = {
        "abs", "acos", "asin", "atan", "ceil", "cos", "deg", "exp", "floor", "fmod", "huge", "log", "max",
        "maxinteger", "min", "mininteger", "modf", "pi", "rad", "random", "randomseed", "sin", "sqrt", "tan",
        "tointeger", "type", "ult",
      },
    },
    preshape = { other_fields = true },
    string = {
      fields = {
        "byte", "char", "find", "format", "gmatch", "gsub", "len", "lower", "match", "pack", "packsize", "rep",
        "reverse", "sub", "unpack", "upper",
      },
    },
    table = { fields = { "concat", "insert", "move", "pack", "remove", "sort", "unpack" } },
    utf8 = { fields = { "char", "charpattern", "codepoint", "codes", "len", "offset" } },
  },
}

files["scripts"] = { std = "preshape" }
files["hands/*/hand.lua"] = { std = "preshape" }
files["objects/*/object.lua"] = { std = "preshape" }
