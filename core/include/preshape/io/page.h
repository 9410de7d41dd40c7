#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "preshape/io/run_record.h"

namespace preshape {

/// Reads the bundled page (core/page), whose places for a run are still empty.
/// @throws InputError when it cannot be read or lacks a place
PRESHAPE_API std::string read_page_template(const std::filesystem::path& file);

/// A run as one HTML file that needs nothing else: its report as JSON, byte for byte what `report_json` gives
/// but with `<` written as `\u003c`, the scene, and a drawing of the fuzzy sets.
/// @param page template with its places; @param glb scene (gltf.h)
PRESHAPE_API std::string page_html(std::string_view page, const RunRecord& record, std::string_view glb);

}  // namespace preshape
