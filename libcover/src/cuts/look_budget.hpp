// How much of a drawing may be looked at to find out how often it would be cut.
#pragma once

#include <cstddef>
#include <limits>

namespace cover {

/// Points that may still be looked at, each once for every time.
class LookBudget {
 public:
  explicit LookBudget(std::size_t looks = std::numeric_limits<std::size_t>::max()) : left_(looks) {}

  /// Takes so many looks, or all that are left.
  void spend(std::size_t looks) { left_ = looks < left_ ? left_ - looks : 0; }
  [[nodiscard]] bool is_spent() const { return left_ == 0; }

 private:
  std::size_t left_;
};

}  // namespace cover
