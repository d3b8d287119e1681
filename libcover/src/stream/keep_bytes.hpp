// What processes tell each other about meshes that stay where they are.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include "io/write_mesh/region_columns.hpp"
#include "tasks/between_processes/byte_stream.hpp"

namespace cover {

/// An offer to keep meshes beside the file that will be written.
struct OfferToKeep {
  std::string beside;      ///< the file, with all its path
  std::string seen;        ///< a file that is there meanwhile, for those who have the same folder
  std::uint64_t word = 0;  ///< what stands in it
  std::uint64_t input_vertices = 0;
  std::uint64_t regions = 0;
};

template <Either<OfferToKeep> T>
auto members(T& offer) {
  auto& [beside, seen, word, input_vertices, regions] = offer;
  return std::tie(beside, seen, word, input_vertices, regions);
}

template <Either<ColumnPlan> T>
auto members(T& plan) {
  auto& [path, shown, input_vertices, columns, regions] = plan;
  return std::tie(path, shown, input_vertices, columns, regions);
}

}  // namespace cover
