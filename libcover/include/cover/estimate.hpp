// What a mesh will take, before it is made.
#pragma once

#include <string>
#include <vector>

#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

namespace cover {

/// How much of a mesh is in memory at a time: all of it, or what is made of one region by
/// stream_mesh().
enum class Held { all, one_region };

/// About what a run takes.
struct Estimate {
  double triangles = 0;   ///< by the sizes wished, and at least what the segments take without any
  double bytes = 0;       ///< of memory, at its most
  double available = 0;   ///< bytes that this process can have; infinite where that is not known
  bool by_disks = false;  ///< disks are packed: lines close to each other need far more of them
  std::vector<Note> notes{};  ///< warnings of sizes that segments do not allow
};

/// Figures for `prepared`, which prepare() made with these options; layers that the input asks for
/// (Input::layers) count where they stand before Options::layers. Measured for the quality method;
/// triangles are right up to a third where sizes are wished that segments allow, else up to a
/// factor of two; layers count as if none gave way. Of disks they are no estimate: what lines far
/// from each other take.
///
/// Errors: those of check_options(), of sizes and of layers (bad_option)
/// Cost:   O(n log n)
Result<Estimate> estimate(const Prepared& prepared, const Options& options = {});

/// What is known before there is a mesh, with what it will take.
std::string report_json(const Prepared& prepared, const Estimate& estimate);

}  // namespace cover
