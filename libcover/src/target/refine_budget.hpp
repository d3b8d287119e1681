// How long refinement goes on at the most.
#pragma once

#include <cstddef>

namespace cover {

/// How many insertions are tried for a domain of `vertices` vertices: a hundred times what is
/// usual, so that what does not end by itself ends.
constexpr std::size_t refine_budget(std::size_t vertices) { return 20 * vertices + 1000; }

}  // namespace cover
