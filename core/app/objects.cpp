#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/base/error.h"
#include "preshape/io/object_reader.h"
#include "preshape/io/table.h"

namespace preshape::app {

namespace {

struct ObjectOptions {
  std::vector<std::string> meshes;
  double unit_length_m = 0.03;
};

void add_row(const Object& object, const std::string& name, double unit_length_m, Table& table, std::vector<std::string>& notes) {
  const Eigen::Vector3d extents = object.box_O.extents();
  table.rows.push_back({name, extents.x() / unit_length_m, extents.y() / unit_length_m, extents.z() / unit_length_m,
                        extents.x() * 1e3, extents.y() * 1e3, extents.z() * 1e3,
                        static_cast<std::int64_t>(object.mesh_O.triangles.size()), object.topology.watertight() ? "yes" : "no"});
  for (const auto& warning : object.warnings) notes.push_back(fmt::format("{}: {}", name, warning));
}

}  // namespace

void add_objects(CLI::App& root, Application& application) {
  auto options = std::make_shared<ObjectOptions>();
  CLI::App* verb = root.add_subcommand("objects", "List the shipped objects, or look at mesh files");
  verb->add_option("mesh", options->meshes, "mesh files or names; all shipped objects when none is given");
  verb->add_option("--unit-length", options->unit_length_m, "the hand's U in metres, for sizes in U")->check(CLI::PositiveNumber)->capture_default_str();
  verb->footer("Examples:\n  preshape objects\n  preshape objects scan.obj part.stl");
  verb->callback([options, &application] {
    Table table;
    table.columns = {"object", "width_U", "height_U", "depth_U", "width_mm", "height_mm", "depth_mm", "triangles", "closed"};
    std::vector<std::string> notes;
    const auto names = options->meshes.empty() ? application.catalogue().objects() : options->meshes;
    for (const auto& name : names) {
      const ObjectChoice choice = object_from_value(Value(name), {}, application.catalogue());
      RawObject raw = read_object(choice.mesh, choice.weld);
      raw.name = choice.name;
      add_row(place_object(std::move(raw), choice.placement, options->unit_length_m), choice.name, options->unit_length_m, table, notes);
    }
    fmt::print("{}", table_text(table));
    for (const auto& note : notes) fmt::print("note: {}\n", note);
  });
}

}  // namespace preshape::app
