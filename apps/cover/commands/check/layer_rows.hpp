// Which rows of triangles lie along lines of a mesh.
#pragma once

#include <string>
#include <vector>

#include <cover/options.hpp>
#include <cover/result.hpp>
#include <cover/triangle_soup.hpp>

#include "commands/check/cut_input.hpp"

namespace cover::app {

/// Tells which rows lie along lines; fails where numbers are asked for that they do not have.
/// `known` are the rules of the input.
/// Returns: the exit code
/// Errors:  bad_option, where a text is no rule or names no line
Result<int> print_layers(const CutInput& cut, const std::vector<std::string>& lines,
                         const std::vector<LayerRule>& known, const TriangleSoup& mesh, bool quiet);

}  // namespace cover::app
