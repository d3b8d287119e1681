// Limits in words.
#pragma once

#include <string>

#include <cover/limits.hpp>

namespace cover::app {

/// How many regions meet their targets, are optimal, near, coupled or open, as one line: "largest
/// angle 2 met, 1 optimal; smallest angle 3 met". Empty where no limit was looked for.
std::string limits_text(const LimitCounts& counts);

}  // namespace cover::app
