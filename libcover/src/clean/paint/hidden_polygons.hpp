// What a crowded drawing need not look at.
#pragma once

#include <vector>

#include <cover/input.hpp>
#include <cover/options.hpp>

namespace cover {

/// By polygon: true for such as lie inside of another one that wins over them (ranks_of), with room
/// between a box around them and its edges. Not all of them: the largest polygons are tried, and
/// none at all where edges cross less than a few times each, as in drawings that are meant, or with
/// Overlap::error.
///
/// EXACT: what is true is hidden
/// Cost:  O(n log n), and a look at two hundred million edges at most
std::vector<bool> hidden_polygons(const Input& input, Overlap overlap);

}  // namespace cover
