// The allowances of the sides of a mesh.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/team.hpp"
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
  /// of(s) for every side s below `sides`. `of` runs in several threads at a time.
  template <class Of>
  void assign(std::size_t sides, const Of& of, const Team& team) {
    which_.clear();
    different_.clear();
    const std::size_t first_ones = std::min(sides, kFewAtATime);
    which_.reserve(sides);
    for (std::size_t s = 0; s < first_ones; ++s) push_back(of(s));
    if (first_ones == sides) return;
    const std::vector<Allowance> common(different_.cbegin(), common_end());
    const std::size_t rest = sides - first_ones;
    std::vector<std::vector<Allowance>> others(Team::ranges(rest, kFewAtATime));
    which_.resize(sides);
    team.each_range(rest, kFewAtATime, [&](std::size_t first, std::size_t last) {
      std::vector<Allowance>& own = others[first / kFewAtATime];
      for (std::size_t s = first_ones + first; s < first_ones + last; ++s) {
        const Allowance allowance = of(s);
        const auto known = std::find(common.begin(), common.end(), allowance);
        which_[s] = static_cast<std::uint32_t>(known - common.begin());
        if (known != common.end()) continue;
        which_[s] += static_cast<std::uint32_t>(own.size());
        own.push_back(allowance);
      }
    });
    add_others(others, common.size(), team);
  }
  void push_back(const Allowance& allowance) {
    const auto end = common_end();
    const auto known = std::find(different_.cbegin(), end, allowance);
    which_.push_back(static_cast<std::uint32_t>(
        known != end ? known - different_.cbegin() : static_cast<long>(different_.size())));
    if (known == end) different_.push_back(allowance);
  }

 private:
  [[nodiscard]] std::vector<Allowance>::const_iterator common_end() const {
    return different_.cbegin() + static_cast<long>(std::min(kTried, different_.size()));
  }
  /// Adds what ranges of the sides behind the first ones have for themselves; which_ counts from
  /// `common` on in each.
  void add_others(const std::vector<std::vector<Allowance>>& others, std::size_t common,
                  const Team& team) {
    std::vector<std::size_t> begin;
    for (std::size_t sum = different_.size(); const std::vector<Allowance>& own : others) {
      begin.push_back(sum);
      sum += own.size();
      different_.resize(sum);
    }
    team.each(others.size(), [&](std::size_t k) {
      std::copy(others[k].begin(), others[k].end(),
                different_.begin() + static_cast<long>(begin[k]));
      const std::size_t first = (k + 1) * kFewAtATime,
                        last = std::min(which_.size(), first + kFewAtATime);
      for (std::size_t s = first; s < last; ++s) {
        if (which_[s] >= common) which_[s] += static_cast<std::uint32_t>(begin[k] - common);
      }
    });
  }

  static constexpr std::size_t kTried = 8;  ///< a common one is among the first
  std::vector<std::uint32_t> which_;        ///< by side
  std::vector<Allowance> different_;
};

}  // namespace cover
