// Bytes of a file into numbers of this machine.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

namespace cover {

/// Turns the bytes of each of `count` numbers of `size` bytes round, in place.
void swap_bytes(char* numbers, std::size_t count, std::size_t size);

/// The first `count` bits as one byte each, 0 or 1; the highest bit of a byte comes first.
///
/// REQUIRES: bits.size() >= (count + 7) / 8
std::unique_ptr<char[]> unpack_bits(std::string_view bits, std::size_t count);

}  // namespace cover
