// How often segments cross, without looking at all of them.
#pragma once

#include <span>

#include "geom/subdivision/sweep_point.hpp"

namespace cover {

/// At how many points segments cross inside of each other, from below: by a sample of pairs, the
/// same for the same segments, less four standard deviations of what it finds. 0 where that is not
/// enough to tell: below some n^2 / 50,000.
///
/// Many pairs at one point count once where the sample meets them twice.
/// Cost: a million pairs at most
double crossings_at_least(std::span<const PlainSegment> segments);

}  // namespace cover
