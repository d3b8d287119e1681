// The input as the mesh cuts it: a piece of a segment is a segment of its own.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <cover/output.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/verify.hpp>

#include "files/mesh_file.hpp"

namespace cover::app {

/// An input that was cut as a mesh is.
struct CutInput {
  Pslg pslg;
  RegionTable table;
  std::size_t points = 0;  ///< that cut it
};

/// A copy of the input, cut.
CutInput cut_as(const Prepared& prepared, const TriangleSoup& mesh);

/// How a mesh cuts segments that is sound otherwise.
struct OwnCuts {
  std::size_t points = 0;
  bool are_on_arcs = false;      ///< some lie on circles, beside their chords
  bool are_meant = false;        ///< cuts are allowed, or the run that made the mesh was to cut
  std::string option;            ///< what made that run cut; empty: nobody knows
  bool are_pieces_sound = true;  ///< no promise is broken on the input with these cuts
};

/// Where the mesh is sound but for materials and cuts of segments, or the run that made it is known
/// to have cut and less is broken with its cuts: how it is cut. If the cuts are meant, `prepared`
/// becomes the input with them, and `found` what is found on it; else `found` becomes each cut
/// segment once, and what is found on the pieces.
///
/// `path` is that of the mesh, beside which its manifest may tell of the run.
std::optional<OwnCuts> take_own_cuts(const std::string& path, const MeshTriangles& mesh,
                                     const VerifyOptions& verify, Prepared& prepared,
                                     Verification& found);

}  // namespace cover::app
