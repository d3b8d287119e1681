// The library's main call.
#pragma once

#include <cover/input.hpp>
#include <cover/mesh.hpp>
#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

namespace cover {

/// Cleans the input, finds its regions and their lower bounds; makes no mesh.
///
/// Errors: ErrorCode 100-199; Error::inputs holds the ids at fault.
/// Cost:   O(n log n).
Result<Prepared> prepare(const Input& input, const Options& options = {},
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
/// Units:   coordinates as given, one length unit throughout.
/// Errors:  ErrorCode 100-199 (input), 300 (cancelled), 400 (options), 900 (ours, please report).
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
