// Pictures are written here by other code than reads them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <random>
#include <string>

#include <zlib.h>

#include <cover/input.hpp>
#include <cover/read_input.hpp>

#include "io/images/raster.hpp"

namespace cover {
namespace {

using Numbers = std::vector<std::uint64_t>;

std::string bytes_of(std::uint64_t value, std::size_t bytes, bool big_endian) {
  std::string out;
  for (std::size_t k = 0; k < bytes; ++k)
    out += static_cast<char>(value >> 8 * (big_endian ? bytes - 1 - k : k) & 0xff);
  return out;
}

std::string deflated(const std::string& data) {
  uLongf size = compressBound(data.size());
  std::string out(size, '\0');
  compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
           data.size());
  out.resize(size);
  return out;
}

/// Rows from above; `channels` numbers of `depth` bits for each pixel.
struct Picture {
  std::size_t width = 0, height = 0, channels = 1, depth = 8;
  Numbers numbers;
  [[nodiscard]] std::uint64_t at(std::size_t x, std::size_t y, std::size_t c) const {
    return numbers[(y * width + x) * channels + c];
  }
};

Picture random_picture(std::size_t width, std::size_t height, std::size_t channels,
                       std::size_t depth, unsigned seed) {
  std::mt19937_64 random(seed);
  Picture p{width, height, channels, depth, {}};
  const std::uint64_t mask = depth == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << depth) - 1;
  // Some repeat, for compressors.
  for (std::size_t k = 0; k < width * height * channels; ++k)
    p.numbers.push_back(k >= 6 && random() % 2 == 0 ? p.numbers[k - 6] : random() & mask);
  return p;
}

std::string chunk(const std::string& type, const std::string& content) {
  const std::string checked = type + content;
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
  return bytes_of(content.size(), 4, true) + checked + bytes_of(sum, 4, true);
}

/// Rows of every `step`-th pixel, each with another filter.
std::string png_rows(const Picture& p, std::array<std::size_t, 4> pass, unsigned& filter) {
  const auto [x0, y0, dx, dy] = pass;
  std::string out, before;
  for (std::size_t y = y0; y < p.height && x0 < p.width; y += dy) {
    std::string line;
    std::size_t bits = 0;
    std::uint64_t partial = 0;
    for (std::size_t x = x0; x < p.width; x += dx) {
      for (std::size_t c = 0; c < p.channels; ++c) {
        if (p.depth >= 8) {
          line += bytes_of(p.at(x, y, c), p.depth / 8, true);
          continue;
        }
        partial = partial << p.depth | p.at(x, y, c);
        bits += p.depth;
        if (bits % 8 == 0) line += static_cast<char>(partial & 0xff);
      }
    }
    if (bits % 8 != 0) line += static_cast<char>(partial << (8 - bits % 8) & 0xff);
    before.resize(line.size());
    const std::size_t step = std::max<std::size_t>(1, p.channels * p.depth / 8);
    const unsigned kind = filter++ % 5;
    out += static_cast<char>(kind);
    for (std::size_t k = 0; k < line.size(); ++k) {
      const auto byte = [](char c) { return static_cast<int>(static_cast<unsigned char>(c)); };
      const int a = k >= step ? byte(line[k - step]) : 0, b = byte(before[k]);
      const int c = k >= step ? byte(before[k - step]) : 0;
      int guess = 0;
      if (kind == 1) guess = a;
      if (kind == 2) guess = b;
      if (kind == 3) guess = (a + b) / 2;
      if (kind == 4) {
        const int e = a + b - c, ea = std::abs(e - a), eb = std::abs(e - b), ec = std::abs(e - c);
        guess = ea <= eb && ea <= ec ? a : eb <= ec ? b : c;
      }
      out += static_cast<char>(byte(line[k]) - guess);
    }
    before = line;
  }
  return out;
}

std::string png(const Picture& p, int type, bool interlaced, const std::string& more = "") {
  unsigned filter = 0;
  std::string rows;
  if (interlaced) {
    for (const auto& pass : {std::array<std::size_t, 4>{0, 0, 8, 8},
                             {4, 0, 8, 8},
                             {0, 4, 4, 8},
                             {2, 0, 4, 4},
                             {0, 2, 2, 4},
                             {1, 0, 2, 2},
                             {0, 1, 1, 2}})
      rows += png_rows(p, pass, filter);
  } else {
    rows = png_rows(p, {0, 0, 1, 1}, filter);
  }
  const std::string stream = deflated(rows);
  const std::string header = bytes_of(p.width, 4, true) + bytes_of(p.height, 4, true) +
                             bytes_of(p.depth, 1, true) +
                             bytes_of(static_cast<unsigned>(type), 1, true) + std::string(2, '\0') +
                             (interlaced ? '\1' : '\0');
  return std::string("\x89PNG\r\n\x1a\n", 8) + chunk("IHDR", header) + more +
         chunk("IDAT", stream.substr(0, stream.size() / 2)) + chunk("tEXt", "ignored") +
         chunk("IDAT", stream.substr(stream.size() / 2)) + chunk("IEND", "");
}

/// What a raster has, from above.
Numbers pixels_of(const Raster& raster) {
  Numbers out;
  for (std::size_t y = raster.height; y-- > 0;)
    out.insert(out.end(), raster.pixels.begin() + static_cast<std::ptrdiff_t>(y * raster.width),
               raster.pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * raster.width));
  return out;
}

Numbers decoded(Result<Raster> raster, const Picture& p) {
  EXPECT_TRUE(raster) << raster.error().message;
  if (!raster) return {};
  EXPECT_EQ(raster->width, p.width);
  EXPECT_EQ(raster->height, p.height);
  return pixels_of(*raster);
}

/// The colours of the first three channels, or the grey values.
Numbers expected(const Picture& p, bool colour, bool alpha) {
  Numbers out;
  for (std::size_t y = 0; y < p.height; ++y) {
    for (std::size_t x = 0; x < p.width; ++x) {
      const std::uint64_t wide = p.depth == 8 ? 257 : 1;
      std::uint64_t value = p.at(x, y, 0);
      if (colour) value = value * wide << 32U | p.at(x, y, 1) * wide << 16U | p.at(x, y, 2) * wide;
      if (alpha && p.at(x, y, p.channels - 1) == 0) value = kNoPixel;
      out.push_back(value);
    }
  }
  return out;
}

TEST(DecodePng, AllKinds) {
  for (const bool interlaced : {false, true}) {
    for (const std::size_t width : {1U, 3U, 9U, 33U}) {
      for (const std::size_t depth : {1U, 2U, 4U, 8U, 16U}) {
        const Picture grey = random_picture(width, 11, 1, depth, 1);
        EXPECT_EQ(decoded(decode_png(png(grey, 0, interlaced), "p"), grey), grey.numbers) << depth;
        if (depth < 8) continue;
        for (const auto& [type, channels] : {std::pair(2, 3), std::pair(4, 2), std::pair(6, 4)}) {
          Picture p = random_picture(width, 11, static_cast<std::size_t>(channels), depth, 2);
          if (type >= 4) p.numbers[p.channels - 1] = 0;  // one is transparent
          EXPECT_EQ(decoded(decode_png(png(p, type, interlaced), "p"), p),
                    expected(p, type != 4, type >= 4));
        }
      }
      for (const std::size_t depth : {1U, 2U, 4U, 8U}) {
        const Picture index = random_picture(width, 7, 1, depth, 3);
        std::string palette, alpha;
        for (unsigned k = 0; k < 1U << depth; ++k) {
          for (const unsigned c : {k, 2 * k, 255 - k}) palette += static_cast<char>(c & 0xffU);
          alpha += k == 1 ? '\0' : '\x80';
        }
        Numbers colours;
        for (const std::uint64_t k : index.numbers)
          colours.push_back(
              k == 1 ? kNoPixel : k * 257 << 32U | (2 * k & 0xff) * 257 << 16U | (255 - k) * 257);
        const std::string more = chunk("PLTE", palette) + chunk("tRNS", alpha);
        EXPECT_EQ(decoded(decode_png(png(index, 3, interlaced, more), "p"), index), colours);
      }
    }
  }
}

TEST(DecodePng, AColourMayStandForNothing) {
  const Picture p{2, 1, 3, 8, {1, 2, 3, 1, 2, 4}};
  const std::string key =
      chunk("tRNS", bytes_of(1, 2, true) + bytes_of(2, 2, true) + bytes_of(3, 2, true));
  EXPECT_EQ(decoded(decode_png(png(p, 2, false, key), "p"), p)[0], kNoPixel);
  EXPECT_NE(decoded(decode_png(png(p, 2, false, key), "p"), p)[1], kNoPixel);
}

TEST(DecodePng, Mistakes) {
  const Picture grey = random_picture(9, 9, 1, 8, 1);
  const std::string good = png(grey, 0, false);
  const auto refusal = [](const std::string& data) {
    const Result<Raster> raster = decode_png(data, "p");
    EXPECT_FALSE(raster);
    return raster ? "" : raster.error().message;
  };
  EXPECT_EQ(refusal(""), "p: this is no PNG");
  EXPECT_EQ(refusal(good.substr(0, 8)), "p: the file ends in the middle of the picture");
  EXPECT_EQ(refusal(good.substr(0, good.size() - 13)),
            "p: the file ends in the middle of the picture");
  std::string damaged = good;
  damaged[45] = static_cast<char>(damaged[45] ^ 1);
  EXPECT_NE(refusal(damaged).find("checksum"), std::string::npos);
  EXPECT_EQ(refusal(png(grey, 5, false)), "p: PNG has no pictures of kind 5 with 8 bits");
  Picture lying = grey;
  lying.width = lying.height = 1'000'000'000;
  std::string header = bytes_of(lying.width, 4, true) + bytes_of(lying.height, 4, true) +
                       std::string("\x08\0\0\0\0", 5);
  EXPECT_NE(refusal(good.substr(0, 8) + chunk("IHDR", header))
                .find("1000000000 x 1000000000 pixels are announced"),
            std::string::npos);
  header = bytes_of(900, 4, true) + bytes_of(900, 4, true) + std::string("\x08\0\0\0\0", 5);
  EXPECT_NE(refusal(good.substr(0, 8) + chunk("IHDR", header) + chunk("IDAT", deflated("abc")) +
                    chunk("IEND", ""))
                .find("fewer pixels than it announces"),
            std::string::npos);
  EXPECT_NE(refusal(png(random_picture(3, 3, 1, 8, 1), 3, false)).find("in the palette"),
            std::string::npos);
}

/// Codes of 9 to 12 bits, as TIFF has them.
std::string lzw(const std::string& data) {
  std::map<std::string, unsigned> codes;
  unsigned next = 258;
  std::string out, word;
  std::uint64_t bits = 0;
  unsigned filled = 0;
  const auto put = [&](unsigned code) {
    const unsigned width = next < 512 ? 9 : next < 1024 ? 10 : next < 2048 ? 11 : 12;
    bits = bits << width | code;
    for (filled += width; filled >= 8; filled -= 8)
      out += static_cast<char>(bits >> (filled - 8) & 0xff);
  };
  const auto code_of = [&](const std::string& w) {
    return w.size() == 1 ? static_cast<unsigned>(static_cast<unsigned char>(w[0])) : codes.at(w);
  };
  put(256);
  for (const char c : data) {
    if (word.empty() || codes.contains(word + c)) {
      word += c;
      continue;
    }
    put(code_of(word));
    codes[word + c] = next++;
    if (next == 4094) {
      put(256);
      codes.clear();
      next = 258;
    }
    word = c;
  }
  if (!word.empty()) put(code_of(word));
  ++next;
  put(257);
  if (filled > 0) out += static_cast<char>(bits << (8 - filled) & 0xff);
  return out;
}

std::string packed_bits(const std::string& data) {
  std::string out;
  for (std::size_t k = 0; k < data.size();) {
    std::size_t n = 1;
    while (k + n < data.size() && n < 128 && data[k + n] == data[k]) ++n;
    if (n > 1) {
      out += static_cast<char>(257 - n);
      out += data[k];
    } else {
      out += '\0';
      out += data[k];
    }
    k += n;
  }
  return out;
}

struct TiffKind {
  unsigned photometric = 1, compression = 1, format = 1;
  std::size_t rows = 4;
  bool big_endian = false, differences = false;
};

/// An entry of a directory with the type of its values, which are in `list`.
struct TiffEntry {
  unsigned tag, type;
  std::uint64_t count;
  std::string list;
};

std::string doubles(const std::vector<double>& values) {
  std::string list;
  for (const double v : values) list += bytes_of(std::bit_cast<std::uint64_t>(v), 8, false);
  return list;
}

std::string tiff(const Picture& p, const TiffKind& kind, const Numbers& colour_map = {},
                 const std::vector<TiffEntry>& more = {}) {
  const bool big = kind.big_endian;
  std::string out =
      (big ? std::string("MM\0*", 4) : std::string("II*\0", 4)) + std::string(4, '\0');
  Numbers offsets, lengths;
  for (std::size_t first = 0; first < p.height; first += kind.rows) {
    std::string strip;
    for (std::size_t y = first; y < std::min(first + kind.rows, p.height); ++y) {
      for (std::size_t x = 0; x < p.width; ++x) {
        for (std::size_t c = 0; c < p.channels; ++c) {
          std::uint64_t value = p.at(x, y, c);
          if (kind.differences && x > 0) value -= p.at(x - 1, y, c);
          strip += bytes_of(value, p.depth / 8, big);
        }
      }
    }
    if (kind.compression == 5) strip = lzw(strip);
    if (kind.compression == 8) strip = deflated(strip);
    if (kind.compression == 32773) strip = packed_bits(strip);
    offsets.push_back(out.size());
    lengths.push_back(strip.size());
    out += strip;
  }
  std::string entries;
  unsigned count = 0;
  const auto add = [&](const TiffEntry& e) {
    std::string list = e.list;
    entries += bytes_of(e.tag, 2, big) + bytes_of(e.type, 2, big) + bytes_of(e.count, 4, big);
    if (list.size() > 4) {
      entries += bytes_of(out.size(), 4, big);
      out += list;
    } else {
      list.resize(4);
      entries += list;
    }
    ++count;
  };
  const auto entry = [&](unsigned tag, unsigned bytes, const Numbers& values) {
    std::string list;
    for (const std::uint64_t v : values) list += bytes_of(v, bytes, big);
    add({tag, bytes == 2 ? 3U : 4U, values.size(), list});
  };
  entry(256, 2, {p.width});
  entry(257, 4, {p.height});
  entry(258, 2, Numbers(p.channels, p.depth));
  entry(259, 2, {kind.compression});
  entry(262, 2, {kind.photometric});
  entry(273, 4, offsets);
  entry(277, 2, {p.channels});
  entry(278, 2, {kind.rows});
  entry(279, 4, lengths);
  if (kind.differences) entry(317, 2, {2});
  if (!colour_map.empty()) entry(320, 2, colour_map);
  entry(339, 2, {kind.format});
  for (const TiffEntry& e : more) add(e);
  const std::string directory = bytes_of(out.size(), 4, big);
  out += bytes_of(count, 2, big) + entries + std::string(4, '\0');
  return out.replace(4, 4, directory);
}

TEST(DecodeTiff, AllKinds) {
  for (const bool big : {false, true}) {
    for (const unsigned compression : {1U, 5U, 8U, 32773U}) {
      for (const bool differences : {false, true}) {
        for (const std::size_t depth : {8U, 16U, 32U}) {
          // Large enough for codes of 12 bits, and for the table to be full.
          const Picture grey = random_picture(83, 90, 1, depth, 1);
          const TiffKind kind{1, compression, 1, 45, big, differences};
          EXPECT_EQ(decoded(decode_tiff(tiff(grey, kind), "t"), grey), grey.numbers)
              << compression << " " << depth << " " << big << " " << differences;
        }
        const Picture rgb = random_picture(13, 11, 3, 8, 2);
        const TiffKind kind{2, compression, 1, 4, big, differences};
        EXPECT_EQ(decoded(decode_tiff(tiff(rgb, kind), "t"), rgb), expected(rgb, true, false));
      }
    }
  }
  const Picture index{2, 2, 1, 8, {0, 1, 1, 0}};
  Numbers map(768, 0);
  map[1] = 257, map[256 + 1] = 514, map[512 + 1] = 771;
  EXPECT_EQ(decoded(decode_tiff(tiff(index, {3, 1, 1, 4, false, false}, map), "t"), index)[1],
            257ULL << 32U | 514ULL << 16U | 771);
  // Of 8 bits in 16, as most programs write them.
  map[1] = 255 * 256, map[256 + 1] = 256, map[512 + 1] = 0;
  EXPECT_EQ(decoded(decode_tiff(tiff(index, {3, 1, 1, 4, false, false}, map), "t"), index)[1],
            0xffffULL << 32U | 257ULL << 16U);
  const Picture minus{2, 1, 1, 16, {0xffff, 5}};
  const Result<Raster> raster = decode_tiff(tiff(minus, {1, 1, 2, 4, false, false}), "t");
  ASSERT_TRUE(raster);
  EXPECT_EQ(static_cast<std::int64_t>(raster->pixels[0]), -1);
}

TEST(DecodeTiff, FurtherPicturesAreCounted) {
  const Picture p = random_picture(9, 9, 1, 8, 1);
  const std::string one = tiff(p, {});
  EXPECT_EQ(decode_tiff(one, "t")->pictures, 1U);
  // The next directory is empty, a picture of a width, a smaller copy of one, the first itself.
  const auto with_next = [&](const std::string& directory) {
    std::string data = one;
    data.replace(data.size() - 4, 4, bytes_of(data.size(), 4, false));
    return decode_tiff(data + directory + std::string(4, '\0'), "t");
  };
  const auto entry = [](unsigned tag, unsigned value) {
    return bytes_of(1, 2, false) + bytes_of(tag, 2, false) + bytes_of(4, 2, false) +
           bytes_of(1, 4, false) + bytes_of(value, 4, false);
  };
  EXPECT_EQ(with_next(bytes_of(0, 2, false))->pictures, 1U);
  EXPECT_EQ(with_next(entry(256, 9))->pictures, 2U);
  EXPECT_EQ(with_next(entry(254, 1))->pictures, 1U);
  EXPECT_EQ(with_next(entry(254, 2))->pictures, 2U);
  // Directories that overlap, more than there is room for: the rest is not looked at.
  EXPECT_EQ(with_next(bytes_of(60000, 2, false))->pictures, 1U);
  std::string circle = one;
  circle.replace(circle.size() - 4, 4, one.substr(4, 4));
  EXPECT_EQ(decode_tiff(circle, "t")->pictures, 1U);
  const Result<Input> input =
      parse_input(std::string(one).replace(one.size() - 4, 4, bytes_of(one.size(), 4, false)) +
                      entry(256, 9) + std::string(4, '\0'),
                  ".tif", "t");
  ASSERT_TRUE(input);
  EXPECT_NE(std::find(input->warnings.begin(), input->warnings.end(),
                      "the file has 2 pictures: the first is taken"),
            input->warnings.end());
}

/// Tags of GeoTIFF: 20 by 10 a pixel, of EPSG:25832.
std::vector<TiffEntry> place_on_map(const std::vector<double>& tie_point) {
  const Numbers keys{1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 25832};
  std::string list;
  for (const std::uint64_t key : keys) list += bytes_of(key, 2, false);
  return {{33550, 12, 3, doubles({20, 10, 0})},
          {33922, 12, tie_point.size(), doubles(tie_point)},
          {34735, 3, keys.size(), list}};
}

TEST(DecodeTiff, ThePlaceOnAMapIsTold) {
  const Picture p = random_picture(9, 9, 1, 8, 1);
  const std::string data = tiff(p, {}, {}, place_on_map({2, 1, 0, 500040, 4999990, 0}));
  const Result<Raster> raster = decode_tiff(data, "t");
  ASSERT_TRUE(raster && raster->place);
  EXPECT_EQ(pixels_of(*raster), p.numbers);
  EXPECT_EQ(raster->place->system, "EPSG:25832");
  EXPECT_EQ(raster->place->first, Point(500000, 5000000));
  EXPECT_EQ(raster->place->pixel_width, 20);
  EXPECT_EQ(raster->place->pixel_height, 10);
  EXPECT_EQ(raster->corner, Point(0, 0));
  const Result<Input> input = parse_input(data, ".tif", "t.tif");
  ASSERT_TRUE(input);
  EXPECT_TRUE(input->is_picture);
  EXPECT_EQ(input->warnings.back(),
            "the picture has a place on a map, which is left out: its first pixel is at (500000, "
            "5000000) of EPSG:25832, a pixel 20 by 10, and here it is a unit square; "
            "'gdal_polygonize.py t.tif -f GeoJSON OUT.geojson' makes a map of it, and "
            "--material-field DN takes its numbers");
  const std::string turned = tiff(
      p, {}, {}, {{34264, 12, 16, doubles({0, 4, 0, 7, -3, 0, 0, 8, 0, 0, 0, 0, 0, 0, 0, 1})}});
  const Result<Raster> by_matrix = decode_tiff(turned, "t");
  ASSERT_TRUE(by_matrix && by_matrix->place);
  EXPECT_EQ(by_matrix->place->first, Point(7, 8));
  EXPECT_EQ(by_matrix->place->pixel_width, 3);
  EXPECT_EQ(by_matrix->place->pixel_height, 4);
  EXPECT_EQ(by_matrix->place->system, "");

  // No picture is damaged by what is damaged of its place.
  EXPECT_FALSE(decode_tiff(tiff(p, {}), "t")->place);
  EXPECT_FALSE(decode_tiff(tiff(p, {}, {}, place_on_map({0, 0, 0, 5})), "t")->place);
  const Result<Raster> cut = decode_tiff(
      tiff(p, {}, {}, {{33550, 12, 1U << 30U, doubles({1, 1, 0})}, {33922, 4, 6, "beyond"}}), "t");
  ASSERT_TRUE(cut);
  EXPECT_FALSE(cut->place);
}

TEST(DecodeTiff, PixelsThatHoldNoDataAreTold) {
  const auto warned = [](const Picture& p, unsigned format, const std::string& no_data) {
    const std::string data =
        tiff(p, {1, 1, format}, {}, {{42113, 2, no_data.size() + 1, no_data + '\0'}});
    const Result<Input> input = parse_input(data, ".tif", "t.tif");
    EXPECT_TRUE(input);
    if (!input) return std::string();
    const auto told =
        std::find_if(input->warnings.begin(), input->warnings.end(),
                     [](const std::string& w) { return w.find("no data") != std::string::npos; });
    return told == input->warnings.end() ? "" : *told;
  };
  EXPECT_EQ(warned({2, 1, 1, 8, {255, 5}}, 1, "255"),
            "pixels of 255 hold no data, as the file says, and count as a material here: a line "
            "'255,void' in the file of --legend makes them void");
  EXPECT_EQ(warned({2, 1, 1, 16, {0xffff, 5}}, 2, "-1").find("pixels of -1 hold"), 0U);
  EXPECT_EQ(warned({2, 1, 1, 16, {0xffff, 5}}, 1, "-1"), "");
  EXPECT_EQ(warned({2, 1, 1, 8, {255, 5}}, 1, "0"), "");
  EXPECT_EQ(warned({2, 1, 1, 8, {255, 5}}, 1, "nan"), "");
}

TEST(DecodeTiff, Mistakes) {
  const std::string good = tiff(random_picture(9, 9, 1, 8, 1), {});
  const auto refusal = [](const std::string& data) {
    const Result<Raster> raster = decode_tiff(data, "t");
    EXPECT_FALSE(raster);
    return raster ? "" : raster.error().message;
  };
  EXPECT_EQ(refusal("II"), "t: this is no TIFF");
  for (std::size_t size = 4; size < good.size() - 8; ++size) refusal(good.substr(0, size));
  EXPECT_NE(refusal(tiff(random_picture(9, 9, 1, 8, 1), {1, 7, 1, 4, false, false}))
                .find("compression 7"),
            std::string::npos);
  EXPECT_EQ(
      refusal(tiff(random_picture(9, 9, 1, 32, 1), {1, 1, 3})),
      "t: TIFF of other than whole numbers: those of a picture are labels of materials; for a "
      "field of sizes, 'gdal_translate -of XYZ FILE OUT.csv' makes points that --size-field "
      "takes");
  std::string lying = good;  // the width
  lying.replace(lying.find(bytes_of(256, 2, false) + bytes_of(3, 2, false)) + 8, 2, "\xff\xff");
  EXPECT_NE(refusal(lying).find("fewer pixels"), std::string::npos);
}

std::string bmp(const Picture& p, std::size_t bits, const std::string& palette, bool from_above) {
  std::string rows;
  for (std::size_t k = 0; k < p.height; ++k) {
    const std::size_t y = from_above ? k : p.height - 1 - k;
    std::string line;
    std::uint64_t partial = 0;
    for (std::size_t x = 0; x < p.width; ++x) {
      if (bits >= 24) {
        for (const std::size_t c : {2U, 1U, 0U}) line += bytes_of(p.at(x, y, c), 1, false);
        if (bits == 32) line += '\0';
        continue;
      }
      partial = partial << bits | p.at(x, y, 0);
      const std::size_t filled = (x + 1) * bits;
      if (filled % 8 == 0 || x + 1 == p.width)
        line += static_cast<char>(partial << (8 - filled % 8) % 8 & 0xff);
    }
    line.resize((line.size() + 3) / 4 * 4);
    rows += line;
  }
  const std::uint64_t height = from_above ? (std::uint64_t{1} << 32U) - p.height : p.height;
  return "BM" + bytes_of(0, 8, false) + bytes_of(54 + palette.size(), 4, false) +
         bytes_of(40, 4, false) + bytes_of(p.width, 4, false) + bytes_of(height, 4, false) +
         bytes_of(1, 2, false) + bytes_of(bits, 2, false) + std::string(24, '\0') + palette + rows;
}

TEST(DecodeBmp, AllKinds) {
  for (const bool from_above : {false, true}) {
    for (const std::size_t bits : {24U, 32U}) {
      const Picture p = random_picture(7, 5, 3, 8, 1);
      EXPECT_EQ(decoded(decode_bmp(bmp(p, bits, "", from_above), "b"), p),
                expected(p, true, false));
    }
    for (const std::size_t bits : {1U, 4U, 8U}) {
      const Picture p = random_picture(11, 5, 1, bits, 1);
      std::string palette;
      Numbers colours;
      for (unsigned k = 0; k < 1U << bits; ++k) {
        palette += bytes_of(k << 16U | 3 * k % 256 << 8U | 7, 4, false);
        colours.push_back(std::uint64_t{k} * 257 << 32U | std::uint64_t{3 * k % 256} * 257 << 16U |
                          7 * 257);
      }
      Numbers wanted;
      for (const std::uint64_t k : p.numbers) wanted.push_back(colours[k]);
      EXPECT_EQ(decoded(decode_bmp(bmp(p, bits, palette, from_above), "b"), p), wanted) << bits;
    }
  }
  std::string grey;
  for (unsigned k = 0; k < 256; ++k) grey += bytes_of(k << 16U | k << 8U | k, 4, false);
  const Picture numbers = random_picture(11, 5, 1, 8, 1);
  const Result<Raster> raster = decode_bmp(bmp(numbers, 8, grey, false), "b");
  EXPECT_EQ(decoded(raster, numbers), numbers.numbers);
  EXPECT_FALSE(raster->is_colour);
  const std::string good = bmp(random_picture(7, 5, 3, 8, 1), 24, "", false);
  for (std::size_t size = 0; size < good.size(); size += 7)
    EXPECT_FALSE(decode_bmp(good.substr(0, size), "b"));
  std::string lying = good;
  lying.replace(18, 8, bytes_of(1U << 30U, 4, false) + bytes_of(1U << 30U, 4, false));
  EXPECT_NE(decode_bmp(lying, "b").error().message.find("pixels are announced"), std::string::npos);
}

TEST(DecodeRaw, NrrdAndMetaImage) {
  const std::string numbers = bytes_of(1, 2, false) + bytes_of(2, 2, false) +
                              bytes_of(3, 2, false) + bytes_of(0xffff, 2, false) +
                              bytes_of(5, 2, false) + bytes_of(6, 2, false);
  const auto rows_up = [](const Result<Raster>& raster) {
    EXPECT_TRUE(raster) << raster.error().message;
    return raster ? raster->pixels : Numbers();
  };
  const Numbers wanted{1, 2, 3, ~std::uint64_t{0}, 5, 6};
  const std::string nrrd =
      "NRRD0004\n# by hand\ntype: short\ndimension: 2\nsizes: 3 2\nendian: little\n"
      "spacings: 0.5 2\n";
  EXPECT_EQ(rows_up(decode_nrrd(nrrd + "encoding: raw\n\n" + numbers, "n")), wanted);
  EXPECT_EQ(rows_up(decode_nrrd(nrrd + "encoding: gzip\n\n" + deflated(numbers), "n")), wanted);
  EXPECT_EQ(rows_up(decode_nrrd(nrrd + "encoding: ascii\n\n1 2 3\n-1 5 6\n", "n")), wanted);
  const Result<Raster> placed = decode_nrrd(nrrd + "encoding: raw\n\n" + numbers, "n");
  EXPECT_EQ(placed->pixel_width, 0.5);
  EXPECT_EQ(placed->pixel_height, 2);
  const std::string mha =
      "ObjectType = Image\nNDims = 3\nDimSize = 3 2 1\nElementType = MET_SHORT\n"
      "ElementSpacing = 0.5 2 1\nOffset = 10 20 0\n";
  EXPECT_EQ(rows_up(decode_mha(mha + "ElementDataFile = LOCAL\n" + numbers, "m")), wanted);
  EXPECT_EQ(rows_up(decode_mha(
                mha + "CompressedData = True\nElementDataFile = LOCAL\n" + deflated(numbers), "m")),
            wanted);
  EXPECT_EQ(decode_mha(mha + "ElementDataFile = LOCAL\n" + numbers, "m")->corner,
            (Point{9.75, 19}));
  const std::string reals = "NRRD0004\ntype: float\nsizes: 1 2\nencoding: raw\nendian: little\n\n";
  const float two = 2, half = 0.5;
  const std::string whole(reinterpret_cast<const char*>(&two), 4);
  EXPECT_EQ(rows_up(decode_nrrd(reals + whole + whole, "n")), (Numbers{2, 2}));
  EXPECT_NE(decode_nrrd(reals + whole + std::string(reinterpret_cast<const char*>(&half), 4), "n")
                .error()
                .message.find("whole numbers"),
            std::string::npos);
}

TEST(DecodeRaw, AxesMayBeMirroredButNotTurned) {
  const auto nrrd = [](const std::string& directions) {
    return decode_nrrd("NRRD0004\ntype: uint8\nsizes: 3 2\nspace dimension: 2\nspace directions: " +
                           directions + "\nspace origin: (0,10)\nencoding: ascii\n\n1 2 3\n4 5 6\n",
                       "n");
  };
  const auto mha = [](const std::string& matrix) {
    return decode_mha(
        "NDims = 2\nDimSize = 3 2\nElementType = MET_UCHAR\nOffset = 0 10\nTransformMatrix = " +
            matrix + "\nElementDataFile = LOCAL\n\1\2\3\4\5\6",
        "m");
  };
  const auto expect = [](const Result<Raster>& raster, const Numbers& pixels, Point corner) {
    ASSERT_TRUE(raster) << raster.error().message;
    EXPECT_EQ(raster->pixels, pixels);
    EXPECT_EQ(raster->corner, corner);
  };
  for (const Result<Raster>& plain : {nrrd("(1,0) (0,1)"), mha("1 0 0 1"), nrrd("none none")})
    expect(plain, {1, 2, 3, 4, 5, 6}, {-0.5, 9.5});
  // The first row has its middles at y = 10, the second one at 9.
  for (const Result<Raster>& down : {nrrd("(1,0) (0,-1)"), mha("1 0 0 -1")})
    expect(down, {4, 5, 6, 1, 2, 3}, {-0.5, 8.5});
  for (const Result<Raster>& left : {nrrd("(-1,0) (0,1)"), mha("-1 0 0 1")})
    expect(left, {3, 2, 1, 6, 5, 4}, {-2.5, 9.5});
  for (const Result<Raster>& turned :
       {nrrd("(1,1) (-1,1)"), nrrd("(0,1) (-1,0)"), mha("0 1 -1 0"), mha("0.6 0.8 -0.8 0.6")}) {
    ASSERT_FALSE(turned);
    EXPECT_EQ(turned.error().code, ErrorCode::unsupported_format);
    EXPECT_NE(turned.error().message.find("turned"), std::string::npos);
  }
}

TEST(DecodeRaw, Mistakes) {
  const auto refusal = [](const std::string& data) {
    const Result<Raster> raster = decode_nrrd(data, "n");
    EXPECT_FALSE(raster) << data;
    return raster ? "" : raster.error().message;
  };
  EXPECT_EQ(refusal("abc"), "n: this is no NRRD");
  EXPECT_EQ(refusal("NRRD0004\ntype: short"), "n: the header does not end");
  EXPECT_NE(refusal("NRRD0004\ntype: short\nencoding: raw\nsizes: 3 2\n\nabc").find("fewer pixels"),
            std::string::npos);
  EXPECT_NE(refusal("NRRD0004\ntype: block\nencoding: raw\nsizes: 3 2\n\nabc").find("'block'"),
            std::string::npos);
  EXPECT_NE(refusal("NRRD0004\ntype: short\nencoding: bzip2\nsizes: 3 2\n\nabc").find("'bzip2'"),
            std::string::npos);
  EXPECT_NE(
      refusal("NRRD0004\ntype: short\nencoding: raw\nsizes: 3 2 4\n\nabc").find("two dimensions"),
      std::string::npos);
  EXPECT_NE(refusal("NRRD0004\ntype: short\nencoding: raw\nsizes: 999999999 999999999\n\nabc")
                .find("are announced"),
            std::string::npos);
  EXPECT_NE(refusal("NRRD0004\ntype: short\nencoding: raw\nsizes: 3 -2\n\nabc").find("no pixels"),
            std::string::npos);
}

}  // namespace
}  // namespace cover
