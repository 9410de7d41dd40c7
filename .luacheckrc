-- Lua sources of preshape: modules, scenarios, studies, hands, objects, components.
std = "lua54"
read_globals = { "preshape" }
max_line_length = 110
exclude_files = { "build" }
