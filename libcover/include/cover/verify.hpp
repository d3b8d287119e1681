// Checks the promises on any mesh, from plain arrays: shares no code with the mesher.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <cover/angle.hpp>
#include <cover/mesh.hpp>
#include <cover/point.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>

namespace cover {

/// A triangle mesh as a file gives it.
struct TriangleSoup {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int64_t> region;     ///< per triangle; empty: the file has none
  std::vector<std::int64_t> material;   ///< per triangle; empty: the file has none
};

/// What to ask of a mesh.
struct VerifyOptions {
  bool bound = true;          ///< promise 3
  bool allow_split = false;   ///< segments may be split by vertices on them
  bool hull = false;          ///< the domain is the convex hull
};

/// A broken promise.
struct Violation {
  int promise = 0;            ///< 1 to 3 of the README; 4 is materials
  std::string message;        ///< what is broken, with ids and coordinates
  std::vector<Point> where;
};

/// What was found.
struct Verification {
  std::vector<Violation> violations;   ///< empty: every promise asked for holds
  std::size_t violation_count = 0;     ///< may exceed what is listed
  std::size_t segments_whole = 0;
  std::size_t regions = 0;
  std::size_t within_rounding = 0;     ///< regions that meet the bound up to coordinate rounding
};

/// The mesh of a run as plain arrays.
TriangleSoup triangle_soup(const Mesh& mesh);

/// Checks `mesh` against the PSLG and its regions.
///
/// EXACT: orientation, conformity and identity of coordinates; area up to rounding of the sum.
/// Cost:  O(n log n).
Verification verify_cover(const Pslg& pslg, const RegionTable& table, const TriangleSoup& mesh,
                          const VerifyOptions& options = {});

}  // namespace cover
