// PNG (ISO 15948) of all kinds, by its own chunks over zlib. Palettes are colours; numbers stay as
// they are, of 16 bits too. Tested by tests/unit/io/images/decode_test.cpp.
#include <zlib.h>

#include <array>
#include <cstdlib>

#include <fmt/core.h>

#include "io/images/image_data.hpp"

namespace cover {
namespace {

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);

struct PngPass {
  std::size_t x, y, dx, dy;
};
constexpr std::array<PngPass, 7> kAdam7{{{0, 0, 8, 8},
                                         {4, 0, 8, 8},
                                         {0, 4, 4, 8},
                                         {2, 0, 4, 4},
                                         {0, 2, 2, 4},
                                         {1, 0, 2, 2},
                                         {0, 1, 1, 2}}};

class PngDecoder {
 public:
  PngDecoder(std::string_view data, const std::string& source) : data_(data), source_(source) {}

  Result<Raster> decode() {
    if (!data_.starts_with(kPngSignature)) fail(ErrorCode::syntax, "this is no PNG");
    std::size_t at = kPngSignature.size();
    while (!error_ && !ended_) at = read_chunk(at);
    if (!error_ && raster_.width == 0) fail(ErrorCode::syntax, "the picture has no header");
    if (!error_) unpack();
    if (error_) return *error_;
    return std::move(raster_);
  }

 private:
  void fail(ErrorCode code, const std::string& what) {
    if (!error_) error_ = Error{code, fmt::format("{}: {}", source_, what), {}, {}};
  }

  /// Where the next one begins.
  std::size_t read_chunk(std::size_t at) {
    constexpr std::size_t kFrame = 12;  // length, type, checksum
    if (data_.size() < kFrame || at > data_.size() - kFrame) {
      fail(ErrorCode::truncated, "the file ends in the middle of the picture");
      return at;
    }
    const std::uint64_t length = number_at(data_, at, 4, true);
    if (length > data_.size() - at - kFrame) {
      fail(ErrorCode::truncated, "the file ends in the middle of the picture");
      return at;
    }
    const std::string_view type = data_.substr(at + 4, 4), content = data_.substr(at + 8, length);
    const auto* const bytes = reinterpret_cast<const Bytef*>(type.data());
    if (crc32(0, bytes, static_cast<uInt>(length + 4)) !=
        number_at(data_, at + 8 + length, 4, true))
      fail(ErrorCode::syntax, fmt::format("the checksum at byte {} is wrong", at + 8 + length));
    else if (type == "IHDR")
      read_header(content);
    else if (raster_.width == 0)
      fail(ErrorCode::syntax, "the picture has no header");
    else if (type == "PLTE")
      palette_ = content;
    else if (type == "tRNS")
      transparent_ = content;
    else if (type == "IDAT")
      stream_ += content;
    else if (type == "IEND")
      ended_ = true;
    return at + kFrame + length;
  }

  void read_header(std::string_view content) {
    if (content.size() != 13 || raster_.width > 0)
      return fail(ErrorCode::syntax, "the header of the picture is wrong");
    const std::uint64_t width = number_at(content, 0, 4, true),
                        height = number_at(content, 4, 4, true);
    depth_ = number_at(content, 8, 1, true);
    type_ = number_at(content, 9, 1, true);
    interlaced_ = content[12] == 1;
    const bool known_depth =
        depth_ == 1 || depth_ == 2 || depth_ == 4 || depth_ == 8 || depth_ == 16;
    const bool known = type_ == 0 ? known_depth
                       : type_ == 3
                           ? known_depth && depth_ <= 8
                           : (type_ == 2 || type_ == 4 || type_ == 6) && known_depth && depth_ >= 8;
    if (!known || content[10] != 0 || content[11] != 0 || (content[12] != 0 && content[12] != 1))
      return fail(ErrorCode::unsupported_format,
                  fmt::format("PNG has no pictures of kind {} with {} bits", type_, depth_));
    if ((error_ = check_pixels(width, height, data_.size(), source_))) return;
    raster_.width = width;
    raster_.height = height;
    raster_.is_colour = type_ == 2 || type_ == 3 || type_ == 6;
    channels_ = type_ == 2 ? 3 : type_ == 4 ? 2 : type_ == 6 ? 4 : 1;
  }

  [[nodiscard]] std::size_t row_bytes(std::size_t width) const {
    return (width * channels_ * depth_ + 7) / 8;
  }

  void unpack() {
    std::size_t size = 0;
    std::vector<PngPass> passes{{0, 0, 1, 1}};
    if (interlaced_) passes.assign(kAdam7.begin(), kAdam7.end());
    const auto columns = [&](const PngPass& p) { return (raster_.width + p.dx - 1 - p.x) / p.dx; };
    const auto rows = [&](const PngPass& p) { return (raster_.height + p.dy - 1 - p.y) / p.dy; };
    for (const PngPass& p : passes)
      if (columns(p) > 0) size += rows(p) * (1 + row_bytes(columns(p)));
    std::string bytes = inflate_stream(stream_, size);
    if (bytes.size() != size)
      return fail(ErrorCode::truncated,
                  "the picture has fewer pixels than it announces, or its data "
                  "are damaged");
    raster_.pixels.resize(raster_.width * raster_.height);
    std::size_t at = 0;
    for (const PngPass& p : passes) {
      if (columns(p) == 0) continue;
      const std::size_t length = row_bytes(columns(p));
      std::string before(length, '\0');
      for (std::size_t row = 0; row < rows(p); ++row, at += 1 + length) {
        char* const line = bytes.data() + at + 1;
        if (!unfilter(bytes[at], line, before, length))
          return fail(ErrorCode::syntax, "a row of the picture has an unknown filter");
        before.assign(line, length);
        const std::size_t y = raster_.height - 1 - (p.y + row * p.dy);
        for (std::size_t k = 0; k < columns(p); ++k)
          raster_.pixels[y * raster_.width + p.x + k * p.dx] = pixel(before, k);
      }
    }
  }

  bool unfilter(char filter, char* line, const std::string& before, std::size_t length) const {
    const std::size_t step = std::max<std::size_t>(1, channels_ * depth_ / 8);
    const auto byte = [](char c) { return static_cast<int>(static_cast<unsigned char>(c)); };
    if (filter < 0 || filter > 4) return false;
    for (std::size_t k = 0; k < length; ++k) {
      const int left = k >= step ? byte(line[k - step]) : 0, up = byte(before[k]);
      const int corner = k >= step ? byte(before[k - step]) : 0;
      const int estimate = left + up - corner;
      const int to_left = std::abs(estimate - left), to_up = std::abs(estimate - up),
                to_corner = std::abs(estimate - corner);
      const int paeth = to_left <= to_up && to_left <= to_corner ? left
                        : to_up <= to_corner                     ? up
                                                                 : corner;
      const std::array<int, 5> added{0, left, up, (left + up) / 2, paeth};
      line[k] = static_cast<char>(byte(line[k]) + added[static_cast<std::size_t>(filter)]);
    }
    return true;
  }

  /// One number of pixel k.
  [[nodiscard]] std::uint64_t sample(std::string_view line, std::size_t k,
                                     std::size_t channel) const {
    if (depth_ >= 8)
      return number_at(line, (k * channels_ + channel) * depth_ / 8, depth_ / 8, true);
    const std::size_t bit = k * depth_;
    return number_at(line, bit / 8, 1, true) >> (8 - depth_ - bit % 8) & ((1U << depth_) - 1);
  }

  [[nodiscard]] std::uint64_t pixel(std::string_view line, std::size_t k) {
    if (type_ == 3) {
      const std::uint64_t index = sample(line, k, 0);
      if (index < transparent_.size() && transparent_[index] == '\0') return kNoPixel;
      if (3 * index + 2 < palette_.size())
        return colour_of(number_at(palette_, 3 * index, 1, true),
                         number_at(palette_, 3 * index + 1, 1, true),
                         number_at(palette_, 3 * index + 2, 1, true));
      fail(ErrorCode::syntax, fmt::format("there is no colour {} in the palette", index));
      return 0;
    }
    const std::size_t numbers = raster_.is_colour ? 3 : 1;
    if (channels_ > numbers && sample(line, k, numbers) == 0) return kNoPixel;
    std::uint64_t value = 0;
    bool is_key = transparent_.size() == 2 * numbers;
    for (std::size_t c = 0; c < numbers; ++c) {
      const std::uint64_t one = sample(line, k, c);
      is_key = is_key && number_at(transparent_, 2 * c, 2, true) == one;
      value = numbers == 1 ? one : value << 16U | (depth_ == 8 ? one * 257 : one);
    }
    return is_key ? kNoPixel : value;
  }

  std::string_view data_;
  const std::string& source_;
  Raster raster_;
  std::size_t depth_ = 8, type_ = 0, channels_ = 1;
  bool interlaced_ = false, ended_ = false;
  std::string_view palette_, transparent_;
  std::string stream_;
  std::optional<Error> error_;
};

}  // namespace

Result<Raster> decode_png(std::string_view data, const std::string& source) {
  return PngDecoder(data, source).decode();
}

}  // namespace cover
