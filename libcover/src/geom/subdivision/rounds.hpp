// An order for insertions one by one that no input makes slow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cover {

/// The numbers below n in rounds, each about eight times as long as the one before; within a round
/// they ascend. What comes first is spread over all, so that what comes later changes little;
/// neighbours stay together all the same. The numbers are mixed by a fixed function: same n, same
/// order.
///
/// Cost: O(n)
/// Ref:  amenta_2003_brio
std::vector<std::uint32_t> rounds(std::size_t n);

}  // namespace cover
