// What readers of pictures have in common: numbers out of bytes, and streams of zlib.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <cover/error.hpp>
#include <cover/result.hpp>

#include "io/images/raster.hpp"

namespace cover {

/// The number in `bytes` bytes at `at`.
/// REQUIRES: they are there; bytes <= 8
std::uint64_t number_at(std::string_view data, std::size_t at, std::size_t bytes, bool big_endian);

/// Unpacks a stream of zlib or gzip to `size` bytes; fewer where it ends before, none if it is
/// none.
std::string inflate_stream(std::string_view data, std::size_t size);

/// Nothing if a file of so many bytes may have so many pixels.
std::optional<Error> check_pixels(std::uint64_t width, std::uint64_t height, std::size_t bytes,
                                  const std::string& source);

/// Eight bits of each as Raster has them.
constexpr std::uint64_t colour_of(std::uint64_t red, std::uint64_t green, std::uint64_t blue) {
  return (red * 257) << 32U | (green * 257) << 16U | (blue * 257);
}

}  // namespace cover
