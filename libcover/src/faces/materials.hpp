// From materials as the input spells them to positive numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <cover/input.hpp>
#include <cover/report.hpp>

namespace cover {

/// The materials of the seeds, by seed.
struct Materials {
  std::vector<std::int32_t> numbers;  ///< positive
  std::vector<std::string> names;     ///< never empty
  std::int32_t unnamed = 1;           ///< for faces without a seed: above the largest given
};

/// Numbers that are positive 32-bit integers are kept; other numbers and names get the smallest
/// free numbers in the order of their first appearance, a seed without material one of its own.
/// A number that had to be changed is told in `notes`.
Materials number_materials(std::span<const RegionSeed> seeds, std::vector<Note>& notes);

}  // namespace cover
