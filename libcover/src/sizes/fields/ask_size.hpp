// The one place where a caller's size function is called.
#pragma once

#include <cover/options.hpp>
#include <cover/point.hpp>

namespace cover {

/// What `field` says at `p`.
///
/// REQUIRES: `field` is not empty
/// Throws:   CallerFault for what `field` throws, except for lack of memory
double ask_size(const SizeFunction& field, Point p);

}  // namespace cover
