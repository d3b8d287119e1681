// What a file should hold where its format leaves a choice.
#pragma once

#include <stop_token>
#include <string>

#include <cover/result.hpp>

namespace cover {

/// What a file should hold where its format leaves a choice.
struct WriteOptions {
  int order = 1;              ///< 2: second-order triangles, a node in the middle of each edge
  bool inner_lines = true;    ///< false: leave out lines that have a triangle on both sides
  bool lines = false;         ///< .vtk: line cells after the triangles
  std::string msh = "2.2";    ///< .msh: version, 2.2 or 4.1
  std::string xdmf = "text";  ///< .xdmf: numbers as text inside, or `hdf5`: in X.h5 beside it
  /// The numbers that solvers know triangles by: `region`: RegionId; `material`; `name`: of the
  /// group of equal name and material. Empty: the group in .msh, the material elsewhere. The array
  /// `material` is the material always. See the formats; not in .vtu, .vtm, .pvtu, and of .vtkhdf
  /// only the order of edges on lines, which stand by group, follows from it.
  std::string ids = {};
  std::string inp_element = "S";  ///< .inp: S, CPS, CPE or CAX; the number of nodes is appended
  int parts = 1;              ///< .pvtu, .msh 4.1 (at most 500): into how many the mesh is divided
  std::stop_token stop = {};  ///< ends the writing with `cancelled`; all is as it was then
};

/// Are all options in their legal ranges? Whether a format has what they ask for is told by
/// can_write().
///
/// Errors: bad_option; the message names the option, its value and the legal range
Status check_write_options(const WriteOptions& options);

}  // namespace cover
