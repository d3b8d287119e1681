// The one place where a caller's size function is called.
#pragma once

#include <algorithm>
#include <optional>

#include <cover/options.hpp>
#include <cover/point.hpp>

namespace cover {

/// What `field` says at `p`.
///
/// REQUIRES: `field` is not empty
/// Throws:   CallerFault for what `field` throws, except for lack of memory
double ask_size(const SizeFunction& field, Point p);

/// A size that was asked for, or `least` where that is larger; not above zero: none is.
inline double at_least(std::optional<double> least, double size) {
  return size > 0 && least ? std::max(size, *least) : size;
}

}  // namespace cover
