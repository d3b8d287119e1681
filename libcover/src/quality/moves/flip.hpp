// Another diagonal of two triangles.
// Mends: a large angle opposite to an inner edge, and small angles at the ends of that edge.
#pragma once

#include "quality/moves/workplace.hpp"

namespace cover {

/// Flips the edge of `t` where that wins most.
///
///        c             c
///       /|\           / \         .
///      / | \         /   \        .
///     a t|u d  ->   a-----d
///      \ | /         \   /
///       \|/           \ /
///        b             b
bool try_flip(Workplace& work, std::uint32_t t);

}  // namespace cover
