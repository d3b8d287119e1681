// VTK's XML format for one unstructured grid, as bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/team.hpp"
#include "io/files/byte_sink.hpp"
#include "io/vtk_files/arrays/number_array.hpp"
#include "io/write_mesh/array_writer.hpp"

namespace cover {

/// One array of a grid: what it is, and its values when they are wanted.
struct VtuArray {
  NumberType type = NumberType::float64;
  std::string name;
  std::size_t components = 1;
  std::string more;  ///< further attributes in XML, with a blank in front
  std::uint64_t bytes = 0;
  ArrayWriter write;
};

/// The array of `value(0)`, ..., `value(size - 1)`, each a T.
template <class T, class Value>
VtuArray vtu_array(std::string_view name, std::size_t size, Value value) {
  return {number_type<T>(),
          std::string(name),
          1,
          {},
          size * sizeof(T),
          array_of_values<T>(size, std::move(value))};
}

/// A grid whose cells are all of one type.
struct VtuGrid {
  std::size_t points = 0;
  std::size_t cells = 0;
  std::size_t cut_vertices = 0;  ///< field data CutVertices, unless zero
  std::string point_attributes;  ///< of the point data: which of them is what
  std::vector<VtuArray> point_data;
  std::string cell_attributes;
  std::vector<VtuArray> cell_data;
  VtuArray coordinates;
  std::vector<VtuArray> connectivity;  ///< connectivity, offsets, types
};

/// The text of a .pvtu whose pieces, in `files`, have the arrays of `piece` and one layer of
/// ghosts.
std::string pvtu_text(const VtuGrid& piece, std::span<const std::string> files);

/// Writes a .vtu file: raw appended data, 64-bit sizes, not compressed, as VTK's own writer does
/// it but for the ranges of the arrays. A thread of the team writes bytes while others make more.
void write_vtu_bytes(const VtuGrid& grid, const ByteSink& sink, const Team& team = {});

}  // namespace cover
