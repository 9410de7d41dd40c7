#include "preshape/workbench/lua_meta.h"

#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"

namespace preshape::app {

void add_lua_meta(CLI::App& root, Application& application) {
  auto file = std::make_shared<std::string>();
  CLI::App* verb = root.add_subcommand("lua-meta", "Write annotations of scenarios for editors that know the Lua language server");
  verb->add_option("file", *file, "file to write; standard output without one")->type_name("FILE");
  verb->footer("Examples:\n  preshape lua-meta preshape_meta.lua\n  preshape --plugin-path build lua-meta preshape_meta.lua");
  verb->callback([file, &application] {
    const std::string text = lua_annotations(application.registry(), application.catalogue());
    if (file->empty()) fmt::print("{}", text);
    else write_file(*file, text);
  });
}

}  // namespace preshape::app
