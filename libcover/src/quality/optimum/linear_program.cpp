// With z the largest value at 0, and each variable as a difference p - q of two that are not
// negative: maximise y so that y + slope (p - q) <= z - value for all functions, and p + q <= 1.
// All zero is feasible, so that one phase is enough.
// Tested by tests/unit/quality/optimum/linear_program_test.cpp.
#include "quality/optimum/linear_program.hpp"

#include <algorithm>
#include <utility>

namespace cover {
namespace {

constexpr int kPivots = 80;
constexpr double kZero = 1e-11;  ///< a reduced cost or pivot that is rounding; slopes are near 1

/// Inequalities as rows, right-hand sides last; the objective below them.
class Tableau {
 public:
  explicit Tableau(const LinearFunctions& f)
      : n_(f.dimension),
        rows_(f.count() + n_),
        columns_(2 * n_ + 2),
        at_((rows_ + 1) * columns_, 0.0),
        basic_(rows_, kSlack) {
    const std::size_t count = f.count();
    for (std::size_t k = 0; k < count; ++k)
      highest_ = std::max(k == 0 ? f.rows[0] : highest_, f.rows[k * (n_ + 1)]);
    for (std::size_t k = 0; k < count; ++k) {
      const double* row = &f.rows[k * (n_ + 1)];
      at(k, 0) = 1;
      for (std::size_t j = 0; j < n_; ++j) {
        at(k, 1 + j) = row[1 + j];
        at(k, 1 + n_ + j) = -row[1 + j];
      }
      at(k, columns_ - 1) = highest_ - row[0];
    }
    for (std::size_t j = 0; j < n_; ++j) {
      at(count + j, 1 + j) = at(count + j, 1 + n_ + j) = at(count + j, columns_ - 1) = 1;
    }
    at(rows_, 0) = -1;
    for (std::size_t c = 0; c + 1 < columns_; ++c) nonbasic_.push_back(c);
  }

  double solve(std::vector<double>& step) {
    for (int k = 0; k < kPivots && pivot(); ++k) {
    }
    step.assign(n_, 0.0);
    double gained = 0;
    for (std::size_t r = 0; r < rows_; ++r) {
      const double value = at(r, columns_ - 1);
      if (basic_[r] == 0) gained = value;
      if (basic_[r] == kSlack || basic_[r] == 0) continue;
      if (basic_[r] <= n_)
        step[basic_[r] - 1] += value;
      else
        step[basic_[r] - 1 - n_] -= value;
    }
    return highest_ - gained;
  }

 private:
  static constexpr std::size_t kSlack = static_cast<std::size_t>(-1);

  double& at(std::size_t row, std::size_t column) { return at_[row * columns_ + column]; }

  /// Exchanges a variable with a slack or another one. Columns of slacks are not kept apart: a
  /// slack that becomes free takes the column of the one that it makes room for.
  bool pivot() {
    std::size_t enters = 0;
    for (std::size_t c = 1; c + 1 < columns_; ++c) {
      if (at(rows_, c) < at(rows_, enters)) enters = c;
    }
    if (!(at(rows_, enters) < -kZero)) return false;
    std::size_t leaves = rows_;
    for (std::size_t r = 0; r < rows_; ++r) {
      if (!(at(r, enters) > kZero)) continue;
      if (leaves == rows_ ||
          at(r, columns_ - 1) * at(leaves, enters) < at(leaves, columns_ - 1) * at(r, enters)) {
        leaves = r;
      }
    }
    if (leaves == rows_) return false;
    exchange(leaves, enters);
    return true;
  }

  void exchange(std::size_t leaves, std::size_t enters) {
    const double p = 1 / at(leaves, enters);
    for (std::size_t c = 0; c < columns_; ++c) at(leaves, c) *= p;
    at(leaves, enters) = p;
    for (std::size_t r = 0; r <= rows_; ++r) {
      if (r == leaves) continue;
      const double factor = at(r, enters);
      if (factor == 0) continue;
      for (std::size_t c = 0; c < columns_; ++c) at(r, c) -= factor * at(leaves, c);
      at(r, enters) = -factor * p;
    }
    std::swap(basic_[leaves], nonbasic_[enters]);
  }

  std::size_t n_, rows_, columns_;
  double highest_ = 0;
  std::vector<double> at_;
  std::vector<std::size_t> basic_;     ///< by row: which variable; kSlack for any slack
  std::vector<std::size_t> nonbasic_;  ///< by column
};

}  // namespace

double lowest_in_box(const LinearFunctions& functions, std::vector<double>& step) {
  return Tableau(functions).solve(step);
}

}  // namespace cover
