// A triangulation of one region that may become its mesh, and how such are compared.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "base/containers/shared.hpp"
#include "quality/fault/merit.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// A triangulation of the region, in the frame, and what it has reached.
struct Candidate {
  Shared<MutableMesh> mesh;
  Merit merit;  ///< by the goal that was aimed at when it was made
  std::string method;
};

/// Which of two candidates is taken: by an order, and by a ceiling of the largest angle. A
/// candidate above the ceiling never replaces one below it.
class Ranking {
 public:
  [[nodiscard]] const Order& order() const { return order_; }
  void set_order(const Order& order) { order_ = order; }
  [[nodiscard]] bool is_within_bound(const Candidate& c) const {
    return order_.is_within_bound(c.merit);
  }

  /// As -cot.
  [[nodiscard]] double ceiling() const { return ceiling_; }
  void lower_ceiling(double large) { ceiling_ = std::min(ceiling_, large); }
  void lift_ceiling() { ceiling_ = kInverted; }

  void take_if_better(Candidate& best, Candidate other) const {
    const bool fits = !is_smaller_cot(ceiling_, other.merit.large);
    const bool best_fits = !is_smaller_cot(ceiling_, best.merit.large);
    if (fits == best_fits ? order_.is_better(other.merit, best.merit) : fits)
      best = std::move(other);
  }

 private:
  Order order_;
  double ceiling_ = kInverted;
};

}  // namespace cover
