// BMP without compression: palettes of 1, 4 and 8 bits, colours of 24 and 32. Grey pictures have a
// palette in which every number is the grey of that number: they are numbers here.
// Tested by tests/unit/io/images/decode_test.cpp.
#include <fmt/core.h>

#include "io/images/image_data.hpp"

namespace cover {
namespace {

/// Whether the palette of 256 colours from `palette` to `end` is that of a grey picture.
bool is_grey(std::string_view data, std::uint64_t palette, std::uint64_t bits, std::uint64_t end) {
  constexpr std::uint64_t kColours = 256, kBytes = 4;
  if (bits != 8 || end > data.size() || palette + kColours * kBytes > end) return false;
  for (std::uint64_t k = 0; k < kColours; ++k)
    for (std::uint64_t c = 0; c < 3; ++c)
      if (number_at(data, palette + kBytes * k + c, 1, false) != k) return false;
  return true;
}

}  // namespace

Result<Raster> decode_bmp(std::string_view data, const std::string& source) {
  const auto wrong = [&](ErrorCode code, const std::string& what) {
    return Error{code, fmt::format("{}: {}", source, what), {}, {}};
  };
  constexpr std::size_t kHeaders = 54;
  if (!data.starts_with("BM")) return wrong(ErrorCode::syntax, "this is no BMP");
  if (data.size() < kHeaders) return wrong(ErrorCode::truncated, "the file ends in its header");
  const auto number = [&](std::size_t at, std::size_t bytes) {
    return number_at(data, at, bytes, false);
  };
  const std::uint64_t first = number(10, 4), header = number(14, 4), bits = number(28, 2);
  const auto height = static_cast<std::int32_t>(number(22, 4));
  const std::uint64_t width = number(18, 4), compression = number(30, 4);
  const auto rows = static_cast<std::uint64_t>(height < 0 ? -std::int64_t{height} : height);
  if (header < 40 || (bits != 1 && bits != 4 && bits != 8 && bits != 24 && bits != 32))
    return wrong(
        ErrorCode::unsupported_format,
        fmt::format("BMP with {} bits for a pixel and a header of {} bytes", bits, header));
  if (compression != 0 && !(compression == 3 && bits == 32))
    return wrong(ErrorCode::unsupported_format, "compressed BMP; convert it to PNG");
  if (const auto error = check_pixels(width, rows, data.size(), source)) return *error;
  const std::uint64_t row_bytes = (width * bits + 31) / 32 * 4;
  if (first > data.size() || row_bytes * rows > data.size() - first)
    return wrong(ErrorCode::truncated, "the picture has fewer pixels than it announces");
  const std::uint64_t palette = 14 + header;
  Raster raster;
  raster.width = width;
  raster.height = rows;
  raster.is_colour = !is_grey(data, palette, bits, first);
  raster.pixels.resize(width * rows);
  for (std::uint64_t y = 0; y < rows; ++y) {
    const std::uint64_t line = first + (height < 0 ? rows - 1 - y : y) * row_bytes;
    for (std::uint64_t x = 0; x < width; ++x) {
      std::uint64_t at = line + x * bits / 8;
      if (bits <= 8) {
        const std::uint64_t index = number(at, 1) >> (8 - bits - x * bits % 8) & ((1U << bits) - 1);
        at = palette + 4 * index;
        if (at + 4 > first)
          return wrong(ErrorCode::syntax,
                       fmt::format("there is no colour {} in the palette", index));
        if (!raster.is_colour) {
          raster.pixels[y * width + x] = index;
          continue;
        }
      }
      raster.pixels[y * width + x] = colour_of(number(at + 2, 1), number(at + 1, 1), number(at, 1));
    }
  }
  return raster;
}

}  // namespace cover
