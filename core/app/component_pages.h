#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "preshape/plugin/registry.h"

namespace preshape::app {

/// A component's declaration as data; the schema stands in docs/command.md, "plugins".
nlohmann::ordered_json component_json(const ComponentRecord& record);

/// Everything that was found: schema, components and libraries, also what cannot be used, with its reasons.
nlohmann::ordered_json listing_json(const Registry& registry);

/// A component as a section of a Markdown page: summary, promises, table of parameters.
std::string component_markdown(const ComponentRecord& record);

/// The reference page of every component that can be used: a table of the kinds, then a section each.
std::string reference_markdown(const Registry& registry);

}  // namespace preshape::app
