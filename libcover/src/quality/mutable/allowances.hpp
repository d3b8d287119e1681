// The allowances of the sides of a mesh.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "target/goal.hpp"

namespace cover {

/// Allowances by side. Most sides of a region have the same one, which is kept once: a side takes 4
/// bytes then, for 32, and what is looked up waits less for memory.
class Allowances {
 public:
  Allowances() = default;
  /// Allows nothing to that many sides.
  explicit Allowances(std::size_t sides) : which_(sides, 0), different_(1) {}

  [[nodiscard]] std::size_t size() const { return which_.size(); }
  const Allowance& operator[](std::size_t side) const {
    return different_.data()[which_[side]];  // which_ names no others
  }

  void reserve(std::size_t sides) { which_.reserve(sides); }
  void clear() {
    which_.clear();
    different_.clear();
  }
  void push_back(const Allowance& allowance) {
    const auto end = different_.begin() + static_cast<long>(std::min(kTried, different_.size()));
    const auto known = std::find(different_.begin(), end, allowance);
    which_.push_back(static_cast<std::uint32_t>(
        known != end ? known - different_.begin() : static_cast<long>(different_.size())));
    if (known == end) different_.push_back(allowance);
  }

 private:
  static constexpr std::size_t kTried = 8;  ///< a common one is among the first
  std::vector<std::uint32_t> which_;        ///< by side
  std::vector<Allowance> different_;
};

}  // namespace cover
