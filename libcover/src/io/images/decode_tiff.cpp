// TIFF 6.0: the first picture of a file, in strips, grey, colour or with a palette; without
// compression or with PackBits, LZW or deflate. Tested by tests/unit/io/images/decode_test.cpp.
#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "io/images/image_data.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// At most `size` bytes.
std::string unpack_bits(std::string_view data, std::size_t size) {
  std::string out;
  for (std::size_t at = 0; at + 1 < data.size() && out.size() < size;) {
    const auto n = static_cast<signed char>(data[at]);
    if (n >= 0) {
      out += data.substr(at + 1, static_cast<std::size_t>(n) + 1);
      at += static_cast<std::size_t>(n) + 2;
    } else {
      if (n != -128) out.append(static_cast<std::size_t>(1 - n), data[at + 1]);
      at += 2;
    }
  }
  out.resize(std::min(out.size(), size));
  return out;
}

/// At most `size` bytes; ends where the codes make no sense.
std::string unpack_lzw(std::string_view data, std::size_t size) {
  constexpr std::size_t kClear = 256, kEnd = 257, kFirst = 258, kMost = 4096;
  struct Entry {
    std::size_t before;
    std::size_t length;
    char last;
  };
  std::vector<Entry> table;
  const auto reset = [&] {
    table.resize(kFirst);
    for (std::size_t k = 0; k < kFirst; ++k) table[k] = {kMost, 1, static_cast<char>(k)};
  };
  std::string out;
  const auto append = [&](std::size_t code) {
    const std::size_t length = table[code].length;
    out.resize(out.size() + length);
    for (std::size_t k = out.size(); code != kMost; code = table[code].before)
      out[--k] = table[code].last;
    return out[out.size() - length];
  };
  reset();
  std::size_t before = kMost, bit = 0;
  while (out.size() < size) {
    const std::size_t n = table.size();
    const std::size_t width = n < 511 ? 9 : n < 1023 ? 10 : n < 2047 ? 11 : 12;
    if (bit + width > 8 * data.size()) break;
    std::size_t code = 0;
    for (std::size_t k = 0; k < width; ++k, ++bit)
      code = code << 1U | (static_cast<unsigned char>(data[bit / 8]) >> (7 - bit % 8) & 1U);
    if (code == kEnd) break;
    if (code == kClear) {
      reset();
      before = kMost;
      continue;
    }
    if (before == kMost) {
      if (code >= kClear) break;
      append(code);
    } else {
      if (code > table.size() || table.size() >= kMost) break;
      const bool is_new = code == table.size();
      const std::size_t old_size = out.size();
      const char first = append(is_new ? before : code);
      if (is_new) out += out[old_size];
      table.push_back({before, table[before].length + 1, first});
    }
    before = code;
  }
  out.resize(std::min(out.size(), size));
  return out;
}

class TiffDecoder {
 public:
  TiffDecoder(std::string_view data, const std::string& source)
      : data_(data), source_(source), big_endian_(data.starts_with("MM")) {}

  Result<Raster> decode() {
    read_directory();
    if (!error_) read_layout();
    if (!error_) read_strips();
    if (error_) return *error_;
    return std::move(raster_);
  }

 private:
  using Tag = std::uint64_t;
  static constexpr Tag kWidth = 256, kHeight = 257, kBits = 258, kCompression = 259,
                       kPhotometric = 262, kStripOffsets = 273, kSamples = 277, kRowsPerStrip = 278,
                       kStripBytes = 279, kPlanar = 284, kPredictor = 317, kColourMap = 320,
                       kTileWidth = 322, kSampleFormat = 339;
  // Of GeoTIFF and of GDAL.
  static constexpr Tag kPixelScale = 33550, kTiePoint = 33922, kTransformation = 34264,
                       kGeoKeys = 34735, kNoData = 42113;
  static constexpr std::uint64_t kText = 2, kDouble = 12;  ///< types of values

  void fail(ErrorCode code, const std::string& what) {
    if (!error_) error_ = Error{code, fmt::format("{}: {}", source_, what), {}, {}};
  }

  static bool is_looked_at(std::uint64_t name) {
    return (name >= kWidth && name <= kPhotometric) || name == kStripOffsets || name == kSamples ||
           name == kRowsPerStrip || name == kStripBytes || name == kPlanar || name == kPredictor ||
           name == kColourMap || name == kTileWidth || name == kSampleFormat;
  }

  /// What pixels do without: it damages no picture.
  static bool is_beside(std::uint64_t name, std::uint64_t type) {
    if (name == kPixelScale || name == kTiePoint || name == kTransformation) return type == kDouble;
    return name == kGeoKeys ? type == 3 : name == kNoData && type == kText;
  }

  static std::uint64_t bytes_of_type(std::uint64_t type) {
    return type == kDouble ? 8 : type == 3 ? 2 : type == 4 ? 4 : 1;
  }

  /// Pictures from the one on whose directory is at `at`, up to one that is damaged. Smaller copies
  /// of others do not count. Directories may overlap in a damaged file: entries are looked at as
  /// many as it has room for.
  std::size_t count_pictures(std::uint64_t at) const {
    constexpr std::size_t kKind = 254, kEntry = 12;
    const auto number = [&](std::uint64_t from, std::size_t bytes) {
      return from <= data_.size() && bytes <= data_.size() - from
                 ? number_at(data_, from, bytes, big_endian_)
                 : 0;
    };
    std::set<std::uint64_t> seen;
    std::size_t count = 0, room = data_.size() / kEntry;
    for (; at != 0 && seen.insert(at).second; at = number(at + 2 + number(at, 2) * kEntry, 4)) {
      const std::uint64_t entries = number(at, 2);
      if (entries > room) break;
      room -= entries;
      bool is_copy = false;
      for (std::uint64_t k = 0; k < entries; ++k)
        if (const std::uint64_t entry = at + 2 + k * kEntry; number(entry, 2) == kKind)
          is_copy = number(entry + 8, number(entry + 2, 2) == 3 ? 2 : 4) % 2 == 1;
      if (entries > 0 && !is_copy) ++count;
    }
    return count;
  }

  /// 0, and an error, where the file ends.
  std::uint64_t number(std::size_t at, std::size_t bytes) {
    if (at <= data_.size() && bytes <= data_.size() - at)
      return number_at(data_, at, bytes, big_endian_);
    fail(ErrorCode::truncated, "the file ends before what its directory names");
    return 0;
  }

  void read_directory() {
    if (!is_tiff(data_)) return fail(ErrorCode::syntax, "this is no TIFF");
    const std::uint64_t at = number(4, 4), count = number(at, 2);
    constexpr std::size_t kEntry = 12;
    for (std::uint64_t k = 0; k < count && !error_; ++k) {
      const std::uint64_t entry = at + 2 + k * kEntry, type = number(entry + 2, 2);
      const std::uint64_t values = number(entry + 4, 4), bytes = bytes_of_type(type);
      const std::uint64_t name = number(entry, 2);
      const bool beside = is_beside(name, type);
      // What is not looked at may be of any length.
      if (((type != 1 && type != 3 && type != 4) || !is_looked_at(name)) && !beside) continue;
      if (tags_.contains(name)) continue;
      const std::uint64_t first = values * bytes <= 4 ? entry + 8 : number(entry + 8, 4);
      if (beside && (first > data_.size() || values > (data_.size() - first) / bytes)) continue;
      if (first > data_.size() || values > (data_.size() - first) / bytes)
        return fail(ErrorCode::truncated, "the file ends before what its directory names");
      std::vector<std::uint64_t>& list = tags_[name];
      for (std::uint64_t v = 0; v < values; ++v) list.push_back(number(first + v * bytes, bytes));
    }
  }

  [[nodiscard]] std::uint64_t tag(Tag name, std::uint64_t otherwise) const {
    const auto found = tags_.find(name);
    return found != tags_.end() && !found->second.empty() ? found->second[0] : otherwise;
  }

  void read_layout() {
    const std::uint64_t width = tag(kWidth, 0), height = tag(kHeight, 0);
    bits_ = tag(kBits, 1);
    samples_ = tag(kSamples, 1);
    photometric_ = tag(kPhotometric, 1);
    compression_ = tag(kCompression, 1);
    const auto unsupported = [&](const std::string& what) {
      fail(ErrorCode::unsupported_format, "TIFF " + what + "; convert it to PNG");
    };
    if (tags_.contains(kTileWidth)) return unsupported("in tiles");
    if (bits_ != 1 && bits_ != 8 && bits_ != 16 && bits_ != 32)
      return unsupported(fmt::format("with {} bits for a number", bits_));
    if (bits_ < 8 && samples_ != 1) return unsupported("of colours with one bit");
    if (samples_ == 0 || samples_ > 8 || (samples_ > 1 && tag(kPlanar, 1) != 1))
      return unsupported(fmt::format("with {} planes", samples_));
    if (photometric_ > 3) return unsupported(fmt::format("of the colours {}", photometric_));
    if (photometric_ == 2 && samples_ < 3)
      return unsupported("of colours with fewer than 3 numbers");
    if (tag(kSampleFormat, 1) > 2)
      return fail(ErrorCode::unsupported_format,
                  "TIFF of other than whole numbers: those of a picture are labels of materials; "
                  "for a field of sizes, 'gdal_translate -of XYZ FILE OUT.csv' makes points that "
                  "--size-field takes");
    if (compression_ != 1 && compression_ != 5 && compression_ != 8 && compression_ != 32773 &&
        compression_ != 32946)
      return unsupported(fmt::format("with compression {}", compression_));
    if ((error_ = check_pixels(width, height, data_.size(), source_))) return;
    raster_.width = width;
    raster_.height = height;
    raster_.is_colour = photometric_ >= 2;
    raster_.is_signed = tag(kSampleFormat, 1) == 2;
    raster_.pictures = std::max<std::size_t>(count_pictures(number(4, 4)), 1);
    const auto& palette = tags_[kColourMap];
    narrow_palette_ = std::all_of(palette.begin(), palette.end(),
                                  [](std::uint64_t colour) { return colour % 256 == 0; });
    raster_.pixels.resize(width * height);
    raster_.place = read_place();
    no_data_ = read_no_data();
  }

  /// Numbers of a tag, as many as are there.
  std::vector<double> numbers_of(Tag name) const {
    std::vector<double> numbers;
    if (const auto found = tags_.find(name); found != tags_.end())
      for (const std::uint64_t bits : found->second) numbers.push_back(std::bit_cast<double>(bits));
    return numbers;
  }

  std::optional<PlaceOnMap> read_place() const {
    const std::vector<double> scale = numbers_of(kPixelScale), tie = numbers_of(kTiePoint),
                              matrix = numbers_of(kTransformation);
    PlaceOnMap place;
    if (scale.size() >= 2 && tie.size() >= 6) {
      place.pixel_width = scale[0];
      place.pixel_height = scale[1];
      place.first = {tie[3] - tie[0] * scale[0], tie[4] + tie[1] * scale[1]};
    } else if (matrix.size() >= 8) {
      place.pixel_width = std::hypot(matrix[0], matrix[4]);
      place.pixel_height = std::hypot(matrix[1], matrix[5]);
      place.first = {matrix[3], matrix[7]};
    } else {
      return std::nullopt;
    }
    if (!std::isfinite(place.first.x) || !std::isfinite(place.first.y) ||
        !(place.pixel_width > 0) || !(place.pixel_height > 0))
      return std::nullopt;
    place.system = read_system();
    return place;
  }

  std::string read_system() const {
    constexpr std::uint64_t kGeographic = 2048, kProjected = 3072;  // keys of GeoTIFF
    constexpr std::uint64_t kUndefined = 0, kOfUser = 32767;
    constexpr std::size_t kKey = 4;  // a key, where its value is, how many, the value
    const auto found = tags_.find(kGeoKeys);
    std::string system;
    if (found == tags_.end()) return system;
    const std::vector<std::uint64_t>& keys = found->second;
    for (std::size_t k = kKey; k + kKey <= keys.size(); k += kKey) {
      const std::uint64_t code = keys[k + 3];
      if (keys[k + 1] != 0 || code == kUndefined || code >= kOfUser) continue;
      if (keys[k] == kProjected || (keys[k] == kGeographic && system.empty()))
        system = fmt::format("EPSG:{}", code);
    }
    return system;
  }

  /// As numbers of pixels are stored.
  std::optional<std::uint64_t> read_no_data() const {
    const auto found = tags_.find(kNoData);
    if (found == tags_.end() || samples_ != 1) return std::nullopt;
    std::string text(found->second.begin(), found->second.end());
    text.resize(std::min(text.find('\0'), text.size()));
    const std::optional<long> value = parse_integer(text);
    if (!value) return std::nullopt;
    const std::uint64_t mask = (std::uint64_t{1} << bits_) - 1;
    const auto stored = static_cast<std::uint64_t>(*value);
    const bool is_held = raster_.is_signed ? (stored + (mask + 1) / 2) <= mask : stored <= mask;
    return is_held ? std::optional(stored & mask) : std::nullopt;
  }

  void read_strips() {
    const std::uint64_t rows =
        std::clamp<std::uint64_t>(tag(kRowsPerStrip, raster_.height), 1, raster_.height);
    const std::uint64_t row_bytes = (raster_.width * samples_ * bits_ + 7) / 8;
    const auto& offsets = tags_[kStripOffsets];
    const auto& lengths = tags_[kStripBytes];
    const std::uint64_t strips = (raster_.height + rows - 1) / rows;
    if (offsets.size() < strips || lengths.size() < strips)
      return fail(ErrorCode::truncated, "the picture has fewer strips than it announces");
    for (std::uint64_t s = 0; s < strips && !error_; ++s) {
      const std::uint64_t first = s * rows,
                          last = std::min<std::uint64_t>(first + rows, raster_.height);
      if (offsets[s] > data_.size() || lengths[s] > data_.size() - offsets[s])
        return fail(ErrorCode::truncated, "the file ends in the middle of the picture");
      std::string bytes =
          unpacked(data_.substr(offsets[s], lengths[s]), (last - first) * row_bytes);
      if (bytes.size() != (last - first) * row_bytes)
        return fail(ErrorCode::truncated,
                    "the picture has fewer pixels than it announces, or its data are damaged");
      for (std::uint64_t row = first; row < last; ++row)
        read_row(std::string_view(bytes).substr((row - first) * row_bytes, row_bytes),
                 raster_.height - 1 - row);
    }
  }

  [[nodiscard]] std::string unpacked(std::string_view strip, std::size_t size) const {
    if (compression_ == 1) return std::string(strip.substr(0, size));
    if (compression_ == 5) return unpack_lzw(strip, size);
    if (compression_ == 32773) return unpack_bits(strip, size);
    return inflate_stream(strip, size);
  }

  void read_row(std::string_view line, std::size_t y) {
    std::vector<std::uint64_t> left(samples_, 0);
    const std::uint64_t mask = bits_ >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits_) - 1;
    const bool differences = tag(kPredictor, 1) == 2 && bits_ >= 8;
    std::vector<std::uint64_t> value(samples_);
    for (std::size_t x = 0; x < raster_.width; ++x) {
      for (std::size_t c = 0; c < samples_; ++c) {
        value[c] = bits_ == 1
                       ? static_cast<unsigned char>(line[x / 8]) >> (7 - x % 8) & 1U
                       : number_at(line, (x * samples_ + c) * bits_ / 8, bits_ / 8, big_endian_);
        if (differences) value[c] = (value[c] + left[c]) & mask;
        left[c] = value[c];
      }
      const std::uint64_t seen = pixel(value);
      raster_.pixels[y * raster_.width + x] = seen;
      if (no_data_ == value[0]) raster_.no_data = seen;
    }
  }

  std::uint64_t pixel(const std::vector<std::uint64_t>& value) {
    if (photometric_ == 2) {
      if (samples_ > 3 && value[3] == 0) return kNoPixel;
      const auto wide = [&](std::uint64_t v) {
        return bits_ == 8 ? v * 257 : bits_ == 32 ? v >> 16U : v;
      };
      return wide(value[0]) << 32U | wide(value[1]) << 16U | wide(value[2]);
    }
    if (photometric_ == 3) {
      const std::vector<std::uint64_t>& map = tags_[kColourMap];
      const std::size_t n = map.size() / 3;
      if (value[0] < n) {
        const auto wide = [&](std::uint64_t v) { return narrow_palette_ ? v / 256 * 257 : v; };
        return wide(map[value[0]]) << 32U | wide(map[n + value[0]]) << 16U |
               wide(map[2 * n + value[0]]);
      }
      fail(ErrorCode::syntax, fmt::format("there is no colour {} in the palette", value[0]));
      return 0;
    }
    if (raster_.is_signed && bits_ < 64 && (value[0] >> (bits_ - 1)) != 0)
      return value[0] | ~((std::uint64_t{1} << bits_) - 1);
    return value[0];
  }

  std::string_view data_;
  const std::string& source_;
  bool big_endian_;
  std::map<std::uint64_t, std::vector<std::uint64_t>> tags_;
  std::uint64_t bits_ = 8, samples_ = 1, photometric_ = 1, compression_ = 1;
  bool narrow_palette_ = false;           ///< of 8 bits a colour, in 16: the lower ones are 0
  std::optional<std::uint64_t> no_data_;  ///< whether pixels have it or not
  Raster raster_;
  std::optional<Error> error_;
};

}  // namespace

bool is_tiff(std::string_view data) {
  return data.starts_with(std::string_view("II*\0", 4)) ||
         data.starts_with(std::string_view("MM\0*", 4));
}

Result<Raster> decode_tiff(std::string_view data, const std::string& source) {
  return TiffDecoder(data, source).decode();
}

}  // namespace cover
