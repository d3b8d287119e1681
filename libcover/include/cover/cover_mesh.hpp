// The library's main call.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <cover/estimate.hpp>
#include <cover/input.hpp>
#include <cover/mesh.hpp>
#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

namespace cover {

/// What it takes to be without negative couplings in the box method, found without a mesh.
struct BoxCosts {
  std::size_t sides = 0;             ///< of all regions
  std::size_t encroached_sides = 0;  ///< each forces one negative coupling, until it is cut
  std::size_t encroached_segments = 0;
  std::size_t least_cuts = 0;  ///< proven: no fewer cuts on straight segments will do
  /// Points that Options::box_method puts on segments before meshing; nothing where cuts of one
  /// segment cut the next for so long that they are not counted.
  std::optional<std::size_t> cuts{};
  std::size_t uncut = 0;  ///< segments left encroached, as doubles have no room for more cuts
  /// As Options::split_interfaces = 90 degrees puts; nothing as above.
  std::optional<std::size_t> cuts_for_right_angles{};
  std::vector<NegativeCoupling> encroached;  ///< by region, then side
};

/// Cleans the input, finds its regions and their lower bounds; makes no mesh. `held`: of a mesh
/// that is to be made of it, which decides whether memory will do.
///
/// Errors: those of cover_mesh(); Error::inputs holds the ids at fault.
/// Cost:   O(n log n).
Result<Prepared> prepare(const Input& input, const Options& options = {},
                         const Callbacks& callbacks = {}, Held held = Held::all);

/// What the box method costs on a prepared input, before any mesh is made.
///
/// Errors: cancelled, bad_option
/// Cost:   O(n log n): cuts that take more than 1,000,000 and 64 n looks at points are not counted
Result<BoxCosts> box_costs(const Prepared& prepared, const Options& options = {},
                           const Callbacks& callbacks = {});

/// Triangulates every region of `input` and returns one mesh whose regions share
/// their boundary vertices and edges.
///
/// ENSURES, checked by verify_cover():
///  (1) every input point in or on a region is a mesh vertex, bit for bit; every segment of the
///      PSLG with a region on at least one side is one mesh edge; no vertex lies inside one;
///  (2) every triangle is counter-clockwise and belongs to exactly one region; the mesh conforms;
///  (3) per region, pi - gamma >= min((pi - gamma_opt) / 2, pi / 6), up to what rounding the
///      coordinates can change; exceptions are named in the report.
/// Options::require is not judged here: unmet_requirements() tells what the mesh misses.
/// Units:   coordinates as given, one length unit throughout.
/// Errors:  ErrorCode 100-199 (input), 300 (cancelled), 303 (out of memory), 400 (options; also
///          what Options::size_field threw), 900 (ours, please report).
/// Threads: safe to call from several threads; uses options.threads workers. The result is
///          bit-identical for every number of threads.
/// Cost:    O(n log n) and the fill's.
/// Ref:     mitchell_1993_covering
Result<Output> cover_mesh(const Input& input, const Options& options = {},
                          const Callbacks& callbacks = {});
/// The same; `input` is gone as soon as it is no longer needed, which leaves room for the mesh.
Result<Output> cover_mesh(Input&& input, const Options& options = {},
                          const Callbacks& callbacks = {});

}  // namespace cover
