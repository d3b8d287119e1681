// Reading the geometry that a subcommand is given.
#pragma once

#include <string>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover::app {

/// What a subcommand says of its input file.
inline constexpr const char* kInputHelp =
    "Geometry: Triangle's .poly, our .json, .geojson, gmsh's .msh; '-' is standard input";

/// Reads `path`; `-` is standard input, whose format follows from how it begins.
Result<Input> read_geometry(const std::string& path);

}  // namespace cover::app
