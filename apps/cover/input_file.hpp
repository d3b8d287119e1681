// Reading the geometry that a subcommand is given.
#pragma once

#include <string>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover::app {

/// Reads `path`; `-` is stdin, which must hold Triangle's .poly with its points.
Result<Input> read_geometry(const std::string& path);

}  // namespace cover::app
