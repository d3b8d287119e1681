// Whether an Input that a program filled agrees with itself.
#pragma once

#include <optional>

#include <cover/error.hpp>
#include <cover/input.hpp>

namespace cover {

/// What in `input` contradicts itself, before anything of it is looked up: arrays by point that are
/// not as long as the points, features without attributes, words and triangles that point at
/// nothing, and sizes, priorities, scales and units that are no such numbers or names.
///
/// Cost: O(n)
std::optional<Error> find_contradiction(const Input& input);

}  // namespace cover
