// Tested by tests/unit/io/vtk_files/arrays/array_reader_test.cpp.
#include "io/vtk_files/arrays/byte_order.hpp"

#include <cstdint>
#include <cstring>

namespace cover {
namespace {

std::uint16_t swapped(std::uint16_t bits) { return __builtin_bswap16(bits); }
std::uint32_t swapped(std::uint32_t bits) { return __builtin_bswap32(bits); }
std::uint64_t swapped(std::uint64_t bits) { return __builtin_bswap64(bits); }

template <class Bits>
void swap_all(char* numbers, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    Bits bits;
    std::memcpy(&bits, numbers + k * sizeof bits, sizeof bits);
    bits = swapped(bits);
    std::memcpy(numbers + k * sizeof bits, &bits, sizeof bits);
  }
}

}  // namespace

void swap_bytes(char* numbers, std::size_t count, std::size_t size) {
  if (size == 2) swap_all<std::uint16_t>(numbers, count);
  if (size == 4) swap_all<std::uint32_t>(numbers, count);
  if (size == 8) swap_all<std::uint64_t>(numbers, count);
}

std::unique_ptr<char[]> unpack_bits(std::string_view bits, std::size_t count) {
  auto bytes = std::make_unique_for_overwrite<char[]>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto eight = static_cast<unsigned char>(bits[k / 8]);
    bytes[k] = static_cast<char>((eight >> (7 - k % 8)) & 1U);
  }
  return bytes;
}

}  // namespace cover
