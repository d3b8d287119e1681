// Errors are values that say what is wrong, where, and in which input element.
#pragma once

#include <string>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// What went wrong. The numbers are kept for good.
enum class ErrorCode {
  // 100-199: the input is not usable geometry (exit code 3)
  non_finite_coordinate = 100,
  duplicate_point = 101,
  zero_length_segment = 102,
  duplicate_segment = 103,
  crossing_segments = 104,
  overlapping_segments = 105,
  point_on_segment = 106,
  id_out_of_range = 107,
  no_segments = 108,
  nothing_enclosed = 109,
  seed_in_void = 110,
  seed_on_segment = 111,
  conflicting_seeds = 112,
  overlapping_polygons = 113,
  changed_input = 114,
  other_mesh = 115,
  coordinate_out_of_range = 116,
  // 200-299: reading and writing files (exit code 5)
  cannot_open = 200,
  cannot_write = 201,
  syntax = 202,
  truncated = 203,
  unsupported_format = 204,
  // 300-399: the run (exit codes 130, 4, 6, 7)
  cancelled = 300,
  meshing_incomplete = 301,
  requirement_not_met = 302,
  out_of_memory = 303,
  // 400-499: options (exit code 2)
  bad_option = 400,
  // 900: a promise inside the library was broken; please report (exit code 1)
  internal = 900,
};

/// The kind of input element that an error points at.
enum class InputKind { point, segment, polygon, hole, region_seed, line };

/// An element of the input, by the id under which the user's file knows it.
struct InputRef {
  InputKind kind = InputKind::point;
  long id = 0;
};

/// One error. `message` is a whole sentence for the user and already names file, line, ids and
/// coordinates; the other members carry the same facts for programs.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;
  std::vector<Point> where;
  std::vector<InputRef> inputs;
};

}  // namespace cover
