// NRRD and MetaImage (.mha): a header in text, then the numbers. Of three dimensions one may be 1.
// y points upwards, the place of a pixel is its middle.
// Tested by tests/unit/io/images/decode_test.cpp.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "base/words/characters.hpp"
#include "io/images/image_data.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// What both headers say.
struct RawLayout {
  std::vector<std::uint64_t> sizes;
  std::vector<double> spacing, origin;
  std::vector<bool> mirrored;  ///< axes along which places become less; empty: none
  std::size_t bytes = 0;       ///< of a number
  bool is_signed = false;
  bool is_real = false;
  bool big_endian = false;
  bool is_text = false;
  bool is_compressed = false;
};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(" \t\r(),"); at != std::string_view::npos;) {
    const std::size_t end = text.find_first_of(" \t\r(),", at);
    words.push_back(text.substr(at, end == std::string_view::npos ? end : end - at));
    at = end == std::string_view::npos ? end : text.find_first_not_of(" \t\r(),", end);
  }
  return words;
}

std::vector<double> reals_of(std::string_view text) {
  std::vector<double> out;
  for (const std::string_view word : words_of(text))
    out.push_back(parse_double(word).value_or(NAN));
  return out;
}

class RawDecoder {
 public:
  RawDecoder(std::string_view data, const std::string& source) : data_(data), source_(source) {}

  Result<Raster> nrrd() {
    if (!data_.starts_with("NRRD")) fail(ErrorCode::syntax, "this is no NRRD");
    read_lines(':');
    const std::string encoding = lower(key("encoding"));
    layout_.is_text = encoding == "ascii" || encoding == "txt" || encoding == "text";
    layout_.is_compressed = encoding == "gzip" || encoding == "gz";
    if (!layout_.is_text && !layout_.is_compressed && encoding != "raw")
      fail(ErrorCode::unsupported_format,
           fmt::format("NRRD with the encoding '{}'", legible(encoding)));
    if (!key("data file").empty() || !key("datafile").empty())
      fail(ErrorCode::unsupported_format, "NRRD whose numbers are in another file");
    set_type(key("type"));
    layout_.big_endian = lower(key("endian")) == "big";
    set_sizes(key("sizes"));
    layout_.spacing = reals_of(key("spacings"));
    layout_.origin = reals_of(key("space origin"));
    for (const double along : diagonal_of(key("space directions")))
      layout_.spacing.push_back(std::abs(along));
    return decode();
  }

  Result<Raster> mha() {
    read_lines('=');
    if (key("ndims").empty()) fail(ErrorCode::syntax, "this is no MetaImage");
    if (const std::string channels = key("elementnumberofchannels");
        !channels.empty() && channels != "1")
      fail(ErrorCode::unsupported_format, "MetaImage with several numbers for a pixel");
    if (key("elementdatafile") != "LOCAL")
      fail(ErrorCode::unsupported_format, "MetaImage whose numbers are in another file");
    set_type(key("elementtype"));
    layout_.is_compressed = lower(key("compresseddata")) == "true";
    layout_.big_endian = lower(key("binarydatabyteordermsb")) == "true" ||
                         lower(key("elementbyteordermsb")) == "true";
    set_sizes(key("dimsize"));
    layout_.spacing = reals_of(key("elementspacing"));
    layout_.origin = reals_of(key("offset"));
    if (layout_.origin.empty()) layout_.origin = reals_of(key("position"));
    // Three names of one thing, of which the first is today's.
    for (const char* name : {"transformmatrix", "rotation", "orientation"})
      if (!key(name).empty()) diagonal_of(key(name));
    return decode();
  }

 private:
  void fail(ErrorCode code, const std::string& what) {
    if (!error_) error_ = Error{code, fmt::format("{}: {}", source_, what), {}, {}};
  }

  /// The header, up to an empty line or the line that says that numbers follow.
  void read_lines(char separator) {
    constexpr std::size_t kMostLines = 1000;
    for (std::size_t lines = 0; lines < kMostLines && at_ < data_.size(); ++lines) {
      const std::size_t end = data_.find('\n', at_);
      if (end == std::string_view::npos) break;
      const std::string_view line = data_.substr(at_, end - at_);
      at_ = end + 1;
      if (trimmed(line).empty()) return;
      const std::size_t cut = line.find(separator);
      if (cut == std::string_view::npos) continue;
      const std::string name = lower(trimmed(line.substr(0, cut)));
      keys_[name] = trimmed(line.substr(cut + 1));
      if (name == "elementdatafile") return;
    }
    fail(ErrorCode::truncated, "the header does not end");
  }

  std::string key(const std::string& name) { return keys_[name]; }

  /// What a step along each axis does to its own coordinate; empty where the text does not say.
  /// Below zero the axis is mirrored. A step that does anything else is refused.
  std::vector<double> diagonal_of(const std::string& text) {
    const std::vector<double> steps = reals_of(text);
    const std::size_t n = layout_.sizes.size();
    const bool all_known =
        std::all_of(steps.begin(), steps.end(), [](double x) { return std::isfinite(x); });
    if (n == 0 || steps.empty() || steps.size() % n != 0 || !all_known) return {};
    const std::size_t coordinates = steps.size() / n;
    std::vector<double> diagonal;
    layout_.mirrored.clear();
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const std::size_t axis = k / coordinates, coordinate = k % coordinates;
      if ((steps[k] != 0) != (axis == coordinate))
        fail(ErrorCode::unsupported_format, "images that are turned are not read");
      if (axis != coordinate) continue;
      diagonal.push_back(steps[k]);
      layout_.mirrored.push_back(steps[k] < 0);
    }
    return diagonal;
  }

  void set_type(const std::string& type) {
    struct Type {
      std::string_view name;
      std::size_t bytes;
      bool is_signed, is_real;
    };
    static constexpr Type kTypes[] = {
        {"uchar", 1, false, false},        {"unsigned char", 1, false, false},
        {"uint8", 1, false, false},        {"uint8_t", 1, false, false},
        {"char", 1, true, false},          {"signed char", 1, true, false},
        {"int8", 1, true, false},          {"int8_t", 1, true, false},
        {"ushort", 2, false, false},       {"unsigned short", 2, false, false},
        {"uint16", 2, false, false},       {"uint16_t", 2, false, false},
        {"short", 2, true, false},         {"int16", 2, true, false},
        {"int16_t", 2, true, false},       {"uint", 4, false, false},
        {"unsigned int", 4, false, false}, {"uint32", 4, false, false},
        {"uint32_t", 4, false, false},     {"int", 4, true, false},
        {"int32", 4, true, false},         {"int32_t", 4, true, false},
        {"ulong", 8, false, false},        {"uint64", 8, false, false},
        {"uint64_t", 8, false, false},     {"long", 8, true, false},
        {"int64", 8, true, false},         {"int64_t", 8, true, false},
        {"float", 4, true, true},          {"double", 8, true, true}};
    std::string name = lower(type);
    if (name.starts_with("met_")) name = name.substr(4);
    for (const Type& t : kTypes) {
      if (t.name != name) continue;
      layout_.bytes = t.bytes;
      layout_.is_signed = t.is_signed;
      layout_.is_real = t.is_real;
    }
    if (layout_.bytes == 0)
      fail(ErrorCode::unsupported_format, fmt::format("numbers of the type '{}'", legible(type)));
  }

  void set_sizes(const std::string& text) {
    for (const std::string_view word : words_of(text)) {
      const std::optional<long> size = parse_integer(word);
      layout_.sizes.push_back(size && *size > 0 ? static_cast<std::uint64_t>(*size) : 0);
    }
  }

  Result<Raster> decode() {
    std::vector<std::size_t> axes;  // those of more than one pixel, or the first two
    for (std::size_t k = 0; k < layout_.sizes.size(); ++k)
      if (layout_.sizes[k] != 1) axes.push_back(k);
    for (std::size_t k = 0; k < layout_.sizes.size() && axes.size() < 2; ++k)
      if (layout_.sizes[k] == 1) axes.push_back(k);
    std::sort(axes.begin(), axes.end());
    if (layout_.sizes.size() > 8 || axes.size() != 2)
      fail(ErrorCode::unsupported_format, "a picture has two dimensions");
    if (!error_)
      error_ = check_pixels(layout_.sizes[axes[0]], layout_.sizes[axes[1]], data_.size(), source_);
    if (error_) return *error_;
    raster_.width = layout_.sizes[axes[0]];
    raster_.height = layout_.sizes[axes[1]];
    raster_.is_signed = layout_.is_signed;
    const auto of_axis = [&](const std::vector<double>& values, std::size_t k, double otherwise) {
      return axes[k] < values.size() && std::isfinite(values[axes[k]]) ? values[axes[k]]
                                                                       : otherwise;
    };
    const auto spacing = [&](std::size_t k) {
      const double value = of_axis(layout_.spacing, k, 1);
      return value > 0 ? value : 1;
    };
    raster_.pixel_width = spacing(0);
    raster_.pixel_height = spacing(1);
    const auto is_mirrored = [&](std::size_t k) {
      return axes[k] < layout_.mirrored.size() && layout_.mirrored[axes[k]];
    };
    // The origin is the middle of the first pixel, which is the last one of a mirrored axis.
    const auto corner = [&](std::size_t k, std::size_t pixels) {
      const double first = of_axis(layout_.origin, k, spacing(k) / 2);
      const double before = is_mirrored(k) ? static_cast<double>(pixels) - 0.5 : 0.5;
      return first - before * spacing(k);
    };
    raster_.corner = {corner(0, raster_.width), corner(1, raster_.height)};
    read_numbers();
    if (error_) return *error_;
    const auto row = [&](std::size_t y) {
      return raster_.pixels.begin() + static_cast<std::ptrdiff_t>(y * raster_.width);
    };
    if (is_mirrored(0))
      for (std::size_t y = 0; y < raster_.height; ++y) std::reverse(row(y), row(y + 1));
    if (is_mirrored(1))
      for (std::size_t y = 0; y < raster_.height / 2; ++y)
        std::swap_ranges(row(y), row(y + 1), row(raster_.height - 1 - y));
    return std::move(raster_);
  }

  void read_numbers() {
    const std::size_t count = raster_.width * raster_.height;
    std::string_view bytes = data_.substr(at_);
    if (layout_.is_text) return read_text(bytes, count);
    std::string unpacked;
    if (layout_.is_compressed) bytes = unpacked = inflate_stream(bytes, count * layout_.bytes);
    if (bytes.size() < count * layout_.bytes)
      return fail(ErrorCode::truncated,
                  "the picture has fewer pixels than it announces, or its data are damaged");
    raster_.pixels.reserve(count);
    for (std::size_t k = 0; k < count && !error_; ++k)
      raster_.pixels.push_back(
          whole(number_at(bytes, k * layout_.bytes, layout_.bytes, layout_.big_endian)));
  }

  void read_text(std::string_view text, std::size_t count) {
    LineReader lines(text, source_, '#', Separator::comma);
    while (!error_ && lines.next()) {
      for (const std::string_view field : lines.fields()) {
        const std::optional<long> value = parse_integer(field);
        if (!value)
          return fail(ErrorCode::syntax, fmt::format("'{}' is no integer", legible(field)));
        raster_.pixels.push_back(static_cast<std::uint64_t>(*value));
        if (raster_.pixels.size() == count) return;
      }
    }
    fail(ErrorCode::truncated, "the picture has fewer pixels than it announces");
  }

  /// The 64 bits of a number that has fewer, or is real and whole.
  std::uint64_t whole(std::uint64_t bits) {
    if (layout_.is_real) {
      double value = 0;
      const auto narrow = static_cast<std::uint32_t>(bits);
      float single = 0;
      std::memcpy(&single, &narrow, sizeof single);
      std::memcpy(&value, &bits, sizeof value);
      if (layout_.bytes == 4) value = single;
      if (!(std::abs(value) < 0x1p53) || value != std::floor(value)) {
        fail(ErrorCode::unsupported_format, "a picture of labels has whole numbers");
        return 0;
      }
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
    }
    const std::size_t width = 8 * layout_.bytes;
    if (layout_.is_signed && width < 64 && (bits >> (width - 1)) != 0)
      bits |= ~((std::uint64_t{1} << width) - 1);
    return bits;
  }

  std::string_view data_;
  const std::string& source_;
  std::size_t at_ = 0;
  std::map<std::string, std::string> keys_;
  RawLayout layout_;
  Raster raster_;
  std::optional<Error> error_;
};

}  // namespace

Result<Raster> decode_nrrd(std::string_view data, const std::string& source) {
  return RawDecoder(data, source).nrrd();
}

Result<Raster> decode_mha(std::string_view data, const std::string& source) {
  return RawDecoder(data, source).mha();
}

}  // namespace cover
