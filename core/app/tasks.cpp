#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/grasp/task_space.h"
#include "preshape/io/table.h"

namespace preshape::app {

void add_tasks(CLI::App& root, Application&) {
  auto signs = std::make_shared<bool>(false);
  CLI::App* verb = root.add_subcommand("tasks", "List the task space and the named manipulations");
  verb->add_flag("--signs", *signs, "every sign variant");
  verb->footer("Example:\n  preshape tasks --signs");
  verb->callback([signs] {
    Table table;
    table.columns = {"task", "Tx", "Ty", "Tz", "Rx", "Ry", "Rz"};
    for (const auto& task : *signs ? signed_task_space() : task_space()) {
      std::vector<Value> row = {task.name};
      for (const double x : task.screw) row.push_back(x);
      table.rows.push_back(std::move(row));
    }
    fmt::print("{}\nCategories, over the axis pairs (approach, opposition) 1 XZ, 2 XY, 3 YX, 4 YZ, 5 ZX, 6 ZY:\n", table_text(table));
    for (const auto& kind : task_categories()) fmt::print("  {}  {}\n", kind.name, kind.text);
    fmt::print("\nManipulations, as task = {{ manipulation = \"pivot\", approach = \"X\", opposition = \"Z\" }}:\n");
    for (const auto& kind : manipulations()) fmt::print("  {:<20}{}\n", kind.name, kind.text);
  });
}

}  // namespace preshape::app
