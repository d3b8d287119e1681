// Geometry files of every format that this build reads, for the program and the Python module.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>

namespace cover::reading {

/// "Triangle's .poly, our .json, ...", for help.
std::string known_formats();

/// Reads a file, with the components that are built in; `stop` ends programs that read it.
///
/// Errors: those of read_input(), read_geo(), read_dxf(), read_gdal() and read_oasis()
Result<Input> read_geometry(const std::string& path, const ReadOptions& options,
                            const std::stop_token& stop = {});

/// Reads geometry from memory; `source` is what messages call it.
/// REQUIRES: a format in the options
///
/// Errors: those of parse_input(), read_geo() and parse_dxf()
Result<Input> parse_geometry(std::string_view text, const std::string& source,
                             const ReadOptions& options);

}  // namespace cover::reading
