// Checks the promises on any mesh, from plain arrays, by no code that makes or changes triangles.
#pragma once

#include <string>
#include <vector>

#include <cover/angle.hpp>
#include <cover/limits.hpp>
#include <cover/options.hpp>
#include <cover/point.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>
#include <cover/triangle_soup.hpp>

namespace cover {

/// What to ask of a mesh.
struct VerifyOptions {
  bool bound = true;                      ///< promise 3, unless allow_split
  bool allow_split = false;               ///< segments may be split by vertices on them
  bool hull = false;                      ///< the domain is the convex hull
  Angle max_angle = Angle::degrees(100);  ///< targets, beside which limits are looked for
  Angle min_angle = Angle::degrees(20);
  bool materials = true;  ///< every triangle has the material of its region
  /// False: materials of the mesh may have other numbers than in the input, as where a file has
  /// groups instead; but no number stands for two materials.
  bool material_numbers = true;
  bool box_method = false;  ///< list negative couplings; they are no violations
  unsigned threads = 0;     ///< 0: all cores. What is found does not depend on it
};

/// A broken promise.
struct Violation {
  int promise = 0;      ///< as numbered in the README
  std::string message;  ///< what is broken, with ids and coordinates
  std::vector<Point> where;
};

/// What was found.
struct Verification {
  std::vector<Violation> violations;  ///< empty: every promise asked for holds
  std::size_t violation_count = 0;    ///< may exceed what is listed
  std::size_t segments_whole = 0;
  std::size_t points_missing = 0;  ///< of the input in or beside regions, that are no vertices
  std::size_t in_void = 0;         ///< sides beside which a triangle lies in the void
  std::size_t other_ids = 0;       ///< triangles whose RegionId is not that of their region
  std::size_t regions = 0;
  std::size_t within_rounding = 0;  ///< regions that meet the bound up to coordinate rounding
  /// By RegionId - 1: what no mesh can have better. Empty where segments or hull sides may be
  /// split, or a promise is broken.
  std::vector<RegionLimits> limits;
  std::vector<std::string> unchecked;  ///< what `options`, or what the mesh lacks, left out
  /// By triangle: the region of the input that it lies in, kVoid if none is known. Empty where the
  /// input is no clean planar straight-line graph.
  std::vector<RegionId> triangle_regions;
  /// With VerifyOptions::box_method: every edge with a negative coupling in its region, by exact
  /// signs, inner edges first. A side is encroached if a point of the PSLG encroaches it.
  std::vector<NegativeCoupling> negative_couplings;
  std::size_t obtuse = 0;  ///< with box_method: triangles, as Quality::obtuse counts them
  std::size_t obtuse_by_rounding = 0;  ///< as Quality::obtuse_by_rounding
};

/// Checks `mesh` against the PSLG and its regions.
///
/// Any arrays will do: indices out of range, coordinates that are not finite, triangles that
/// overlap are found and named, never trusted. At most ten violations of a kind are listed.
///
/// Materials are compared where the mesh has them; where the input has region seeds it must.
/// RegionIds may be numbered in any way that gives each region one of its own.
/// Promise 3 is not asked of meshes whose segments may be split.
///
/// EXACT: coordinates, orientation, conformity, and with them that the triangles cover each region
///        once: triangles that are all counter-clockwise cover a point as often as the sum of their
///        edges winds around it, and that sum is compared with the boundary of the region. Where
///        segments or hull sides may be split, vertices on them may be off by a few units in the
///        last place.
/// Cost:  O(n log n).
Verification verify_cover(const Pslg& pslg, const RegionTable& table, const TriangleSoup& mesh,
                          const VerifyOptions& options = {});

/// Whether the lines that `rule` names are images of each other, and by how many pairs of points.
/// For a mesh whose segments are cut, adopt_cuts() makes `pslg` and `table` its own.
///
/// Errors: bad_option: unknown names, lines that share segments, or, with places, points or
///         segments without a partner
/// Cost:   O(n log n)
Result<std::size_t> verify_periodic_sides(const Pslg& pslg, const RegionTable& table,
                                          const PeriodicRule& rule);

}  // namespace cover
