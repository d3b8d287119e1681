// Tested by tests/unit/pipeline/share_out_test.cpp.
#include "tasks/between_processes/region_bytes.hpp"

#include "tasks/between_processes/byte_stream.hpp"

namespace cover {

template <Either<Note> T>
auto members(T& note) {
  auto& [kind, region, message, where] = note;
  return std::tie(kind, region, message, where);
}

template <Either<LayerReport::Short> T>
auto members(T& part) {
  auto& [why, segments, at] = part;
  return std::tie(why, segments, at);
}

template <Either<LayerReport> T>
auto members(T& report) {
  auto& [asked, segments, length, complete, fewest, most, thickness, cut_short] = report;
  return std::tie(asked, segments, length, complete, fewest, most, thickness, cut_short);
}

template <Either<RegionReport> T>
auto members(T& report) {
  auto& [id, method, nu_opt, nu_bound, quality, box, couplings, input_vertices, steiner_vertices,
         forced_above_120, forced_above_150, layers, limits, has_no_room, bound_held, notes,
         seconds] = report;
  return std::tie(id, method, nu_opt, nu_bound, quality, box, couplings, input_vertices,
                  steiner_vertices, forced_above_120, forced_above_150, layers, limits, has_no_room,
                  bound_held, notes, seconds);
}

template <Either<RegionMesh> T>
auto members(T& mesh) {
  auto& [steiner, triangles, layer_triangles, layer_vertices, report, limits_are_old] = mesh;
  static_cast<void>(limits_are_old);  // whoever meshes a region proves them
  return std::tie(steiner, triangles, layer_triangles, layer_vertices, report);
}

template <Either<KeptMesh> T>
auto members(T& mesh) {
  auto& [report, steiner, triangles, half_edges] = mesh;
  return std::tie(report, steiner, triangles, half_edges);
}

template <Either<RegionBoundary> T>
auto members(T& boundary) {
  auto& [id, points, vertices, sides, segments, size, size_at, size_along, size_expressions,
         size_grid, size_function, layers, is_rest, known_cdt, size_missed] = boundary;
  static_cast<void>(size_function);
  static_cast<void>(known_cdt);    // finding them again is not more than sending them
  static_cast<void>(size_missed);  // of size_function
  return std::tie(id, points, vertices, sides, segments, size, size_at, size_along,
                  size_expressions, size_grid, layers, is_rest);
}

template <Either<SizeRule> T>
auto members(T& rule) {
  auto& [name, size, at, expression] = rule;
  return std::tie(name, size, at, expression);
}

template <Either<Options> T>
auto members(T& options) {
  auto& [method, fill, paper, pieces, hull, max_angle, min_angle, prefer, effort, couplings, sizes,
         input_sizes, size_field, size_field_name, size_field_scale, size_of, size_step, min_size,
         growth, box_method, split_interfaces, layers, periodic, overlap, weld, strict,
         merge_materials, require, threads] = options;
  static_cast<void>(size_field);
  return std::tie(method, fill, paper, pieces, hull, max_angle, min_angle, prefer, effort,
                  couplings, sizes, input_sizes, size_field_name, size_field_scale, size_of,
                  size_step, min_size, growth, box_method, split_interfaces, layers, periodic,
                  overlap, weld, strict, merge_materials, require, threads);
}

Bytes to_bytes(const RegionBoundary& boundary) { return bytes_of(boundary); }
Bytes to_bytes(const Options& options) { return bytes_of(options); }

Bytes to_bytes(const Result<RegionMesh>& mesh) { return bytes_of_result(mesh); }
Bytes to_bytes(const Result<KeptMesh>& mesh) { return bytes_of_result(mesh); }

Result<RegionBoundary> boundary_of_bytes(std::span<const std::byte> bytes) {
  return value_of<RegionBoundary>(bytes);
}

Result<Options> options_of_bytes(std::span<const std::byte> bytes) {
  return value_of<Options>(bytes);
}

Result<RegionMesh> mesh_of_bytes(std::span<const std::byte> bytes) {
  return result_of_bytes<RegionMesh>(bytes);
}

Result<KeptMesh> kept_of_bytes(std::span<const std::byte> bytes) {
  return result_of_bytes<KeptMesh>(bytes);
}

}  // namespace cover
