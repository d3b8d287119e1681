// Tested by tests/unit/tasks/input_bytes_test.cpp.
#include <cover/read_elsewhere.hpp>

#include "tasks/between_processes/byte_stream.hpp"

namespace cover {

template <Either<InputSegment> T>
auto members(T& segment) {
  auto& [a, b, marker, id, line, name, circle, file] = segment;
  return std::tie(a, b, marker, id, line, name, circle, file);
}

template <Either<RegionSeed> T>
auto members(T& seed) {
  auto& [at, material, region, size, id, line, feature, label_layer] = seed;
  return std::tie(at, material, region, size, id, line, feature, label_layer);
}

template <Either<HoleSeed> T>
auto members(T& hole) {
  auto& [at, id, line, label_layer] = hole;
  return std::tie(at, id, line, label_layer);
}

template <Either<InputPolygon> T>
auto members(T& polygon) {
  auto& [rings, material, region, priority, id, size, circles, feature, file] = polygon;
  return std::tie(rings, material, region, priority, id, size, circles, feature, file);
}

template <Either<InputLine> T>
auto members(T& line) {
  auto& [name, points, id, circles, file] = line;
  return std::tie(name, points, id, circles, file);
}

template <Either<Attribute> T>
auto members(T& attribute) {
  auto& [name, is_text, words, values] = attribute;
  return std::tie(name, is_text, words, values);
}

template <Either<PlaneField::Array> T>
auto members(T& array) {
  auto& [name, values] = array;
  return std::tie(name, values);
}

template <Either<PlaneField> T>
auto members(T& field) {
  auto& [points, triangles, material, arrays] = field;
  return std::tie(points, triangles, material, arrays);
}

template <Either<Change> T>
auto members(T& change) {
  auto& [kind, message, where, inputs] = change;
  return std::tie(kind, message, where, inputs);
}

template <Either<AskedName> T>
auto members(T& asked) {
  auto& [option, name, is_there, missing] = asked;
  return std::tie(option, name, is_there, missing);
}

template <Either<PointName> T>
auto members(T& name) {
  auto& [point, words] = name;
  return std::tie(point, words);
}

template <Either<Input> T>
auto members(T& input) {
  auto& [source, unit, scale, warnings, points, point_ids, point_lines, point_markers, segments,
         holes, seeds, void_rule, polygons, lines, field, attributes, circles, periodic, layers,
         changes, system, asked, point_names, seeds_may_miss, other_unit, is_picture, fields,
         files] = input;
  return std::tie(source, unit, scale, warnings, points, point_ids, point_lines, point_markers,
                  segments, holes, seeds, void_rule, polygons, lines, field, attributes, circles,
                  periodic, layers, changes, system, asked, point_names, seeds_may_miss, other_unit,
                  is_picture, fields, files);
}

template <Either<ReadOptions> T>
auto members(T& options) {
  auto& [format, unit, scale, threads, layers, layer_map, label_layer, cell, window, chord_error,
         chord_angle, material_field, name_field, priority_field, keep_fields, crs, speckle, smooth,
         legend, is_one_of_several] = options;
  return std::tie(format, unit, scale, threads, layers, layer_map, label_layer, cell, window,
                  chord_error, chord_angle, material_field, name_field, priority_field, keep_fields,
                  crs, speckle, smooth, legend, is_one_of_several);
}

template <Either<FilesToRead> T>
auto members(T& files) {
  auto& [paths, options] = files;
  return std::tie(paths, options);
}

Bytes bytes_of_files(const FilesToRead& files) { return bytes_of(files); }
Bytes bytes_of_input(const Result<Input>& input) { return bytes_of_result(input); }

Result<FilesToRead> files_of_bytes(std::span<const std::byte> bytes) {
  return value_of<FilesToRead>(bytes);
}

Result<Input> input_of_bytes(std::span<const std::byte> bytes) {
  return result_of_bytes<Input>(bytes);
}

}  // namespace cover
