// The groups of a DXF file, looked through before dxflib gets them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <cover/result.hpp>

namespace cover {

/// A layer that is switched off, or frozen: then so is what is inserted on it.
struct HiddenLayer {
  std::string name;
  bool frozen = false;
};

/// What is left of a drawing for dxflib.
struct CheckedDxf {
  std::string text;                             ///< blocks and entities that are read, in DXF
  int unit = 0;                                 ///< $INSUNITS; 0: not said
  std::map<std::string, std::size_t> left_out;  ///< number of entities by their kind
  std::size_t invisible = 0;                    ///< entities that say so: left out
  std::size_t in_paper_space = 0;               ///< entities of printed sheets: left out
  std::map<std::string, HiddenLayer> hidden;    ///< by names in small letters
  std::vector<bool> wide;  ///< by polyline of `text`: whether it has a width, which dxflib drops
};

/// Drops sections, entities and groups that are not read, and makes sure that numbers are finite
/// numbers and that counts (which dxflib believes) are what is there.
///
/// Errors: syntax, truncated, non_finite_coordinate, unsupported_format; with the line
/// Cost:   O(n)
Result<CheckedDxf> check_dxf(std::string_view text, const std::string& source);

}  // namespace cover
