// Tested by tests/unit/io/images/decode_test.cpp.
#include "io/images/image_data.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <limits>

#include "io/text/limits.hpp"

namespace cover {

std::uint64_t number_at(std::string_view data, std::size_t at, std::size_t bytes, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < bytes; ++k) {
    const std::size_t place = big_endian ? at + k : at + bytes - 1 - k;
    value = value << 8U | static_cast<unsigned char>(data[place]);
  }
  return value;
}

std::string inflate_stream(std::string_view data, std::size_t size) {
  constexpr int kZlibOrGzip = 15 + 32;
  z_stream stream{};
  if (inflateInit2(&stream, kZlibOrGzip) != Z_OK) return {};
  std::string out(size, '\0');
  std::size_t read = 0, written = 0;
  int status = Z_OK;
  // zlib counts with 32 bits.
  constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
  while (status == Z_OK && written < size) {
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data() + read));
    stream.avail_in = static_cast<uInt>(std::min(kMost, data.size() - read));
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + written);
    stream.avail_out = static_cast<uInt>(std::min(kMost, size - written));
    const std::size_t in = stream.avail_in, room = stream.avail_out;
    status = inflate(&stream, Z_NO_FLUSH);
    read += in - stream.avail_in;
    written += room - stream.avail_out;
    if (in == stream.avail_in && room == stream.avail_out) break;
  }
  inflateEnd(&stream);
  out.resize(status == Z_OK || status == Z_STREAM_END || status == Z_BUF_ERROR ? written : 0);
  return out;
}

std::optional<Error> check_pixels(std::uint64_t width, std::uint64_t height, std::size_t bytes,
                                  const std::string& source) {
  const std::uint64_t most = kImagePixels + kImageUnfolding * bytes;
  if (width == 0 || height == 0)
    return Error{ErrorCode::syntax, fmt::format("{}: the picture has no pixels", source), {}, {}};
  if (width <= most && height <= most / width) return std::nullopt;
  return Error{ErrorCode::syntax,
               fmt::format("{}: {} x {} pixels are announced, but {} bytes hold {} at most", source,
                           width, height, bytes, most),
               {},
               {}};
}

}  // namespace cover
