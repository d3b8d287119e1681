// What processes tell each other about meshes that stay where they are.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <cover/share_out.hpp>

#include "io/write_mesh/region_columns.hpp"

namespace cover {

/// An offer to keep meshes beside the file that will be written.
struct OfferToKeep {
  std::string beside;      ///< the file, with all its path
  std::string seen;        ///< a file that is there meanwhile, for those who have the same folder
  std::uint64_t word = 0;  ///< what stands in it
  std::uint64_t input_vertices = 0;
  std::uint64_t regions = 0;
};

Bytes to_bytes(const OfferToKeep& offer);
Bytes to_bytes(const ColumnPlan& plan);

/// Nothing where `bytes` are not those of the functions above.
std::optional<OfferToKeep> offer_of_bytes(std::span<const std::byte> bytes);
std::optional<ColumnPlan> plan_of_bytes(std::span<const std::byte> bytes);

}  // namespace cover
