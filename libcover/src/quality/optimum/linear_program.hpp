// The lowest point of the maximum of linear functions within a box, in a few dimensions.
#pragma once

#include <cstddef>
#include <vector>

namespace cover {

/// Linear functions of `dimension` variables: row k is value, then slopes.
struct LinearFunctions {
  std::size_t dimension = 0;
  std::vector<double> rows;

  [[nodiscard]] std::size_t count() const { return rows.size() / (dimension + 1); }
};

/// Looks for the lowest largest value with all variables between -1 and 1.
///
/// ENSURES: returns what the functions let expect there, no more than the largest at 0; `step` is
///          the place. Stops before the lowest point after a number of pivots that is rarely
///          needed.
/// Cost:    O(count * dimension) per pivot, of which there are some dozens
/// Ref:     G. B. Dantzig, Maximization of a linear function of variables subject to linear
///          inequalities (1951): the simplex method on a full tableau
double lowest_in_box(const LinearFunctions& functions, std::vector<double>& step);

}  // namespace cover
