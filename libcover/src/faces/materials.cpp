// See materials.hpp.
#include "faces/materials.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "base/words/parse_number.hpp"

namespace cover {
namespace {

constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();

/// The number that a material is spelled as, none if it is a name.
std::optional<double> as_number(const std::string& material) {
  const std::string_view text = material;
  return parse_number<double>(text.starts_with('+') ? text.substr(1) : text);
}

/// The number if it can be kept.
std::optional<std::int32_t> as_kept(const std::string& material) {
  const auto value = as_number(material);
  if (!value || !(*value >= 1 && *value <= kLargest)) return {};
  const auto integer = static_cast<std::int32_t>(*value);
  if (integer != *value) return {};
  return integer;
}

/// Whether a positive integer, not its form, is what cannot be kept.
bool is_too_large(const std::string& material) {
  const auto value = as_number(material);
  return value && *value > kLargest && std::floor(*value) == *value;
}

/// Hands out the smallest positive numbers that are not taken.
class FreeNumbers {
 public:
  explicit FreeNumbers(std::set<std::int32_t> taken) : taken_(std::move(taken)) {}
  std::int32_t next() {
    while (taken_.contains(candidate_)) ++candidate_;
    return candidate_++;
  }

 private:
  std::set<std::int32_t> taken_;
  std::int32_t candidate_ = 1;
};

}  // namespace

Materials number_materials(std::span<const RegionSeed> seeds, std::vector<Note>& notes) {
  std::set<std::int32_t> kept;
  for (const RegionSeed& seed : seeds) {
    if (const auto number = as_kept(seed.material)) kept.insert(*number);
  }
  FreeNumbers free(kept);
  std::map<std::string, std::int32_t> given;
  Materials out;
  for (const RegionSeed& seed : seeds) {
    const bool nameless = seed.material.empty() || as_number(seed.material).has_value();
    std::int32_t number = 0;
    if (const auto same = as_kept(seed.material)) {
      number = *same;
    } else if (seed.material.empty()) {
      number = free.next();
    } else if (const auto known = given.find(seed.material); known != given.end()) {
      number = known->second;
    } else {
      number = given[seed.material] = free.next();
      if (nameless) {
        const std::string why = is_too_large(seed.material)
                                    ? fmt::format("larger than {}", kLargest)
                                    : "no positive integer";
        notes.push_back(
            {Note::Kind::warning,
             kVoid,
             fmt::format("material {} is {}: it becomes number {}", seed.material, why, number),
             {seed.at}});
      }
    }
    out.numbers.push_back(number);
    const bool renumbered = nameless && !seed.material.empty() && !as_kept(seed.material);
    out.names.push_back(!nameless    ? seed.material
                        : renumbered ? fmt::format("material_{}", seed.material)
                                     : fmt::format("material_{}", number));
  }
  if (!out.numbers.empty()) {
    const std::int32_t largest = *std::max_element(out.numbers.begin(), out.numbers.end());
    out.unnamed = largest < kLargest ? largest + 1 : free.next();
  }
  return out;
}

}  // namespace cover
