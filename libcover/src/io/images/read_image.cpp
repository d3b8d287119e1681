// PNG and TIFF are decoded by our own readers over zlib, though libpng and libtiff are there:
// labels must come out as they are stored (indices, 16 and 32 bits, keys of transparency), what a
// file announces is weighed against its length before there is memory for it, libpng leaves by
// longjmp over destructors, older versions of libtiff bound no memory, and each would be one more
// thing that a static library asks for. TIFF in tiles, of planes, or with JPEG inside would be
// reasons to change that.
//
// Tested by tests/unit/io/images/read_image_test.cpp.
#include "io/images/read_image.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <unordered_map>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "io/images/image_borders.hpp"
#include "io/images/raster.hpp"
#include "io/images/speckles.hpp"
#include "io/text/limits.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

struct ImageFormat {
  std::string_view extension;
  Result<Raster> (*decode)(std::string_view data, const std::string& source);
};
constexpr std::array kImageFormats{
    ImageFormat{".png", decode_png},   ImageFormat{".bmp", decode_bmp},
    ImageFormat{".tif", decode_tiff},  ImageFormat{".tiff", decode_tiff},
    ImageFormat{".nrrd", decode_nrrd}, ImageFormat{".mha", decode_mha},
};

/// "#ff0000", of 16 bits for each "#ffff00000000"; or the number.
std::string label_of(const Raster& raster, std::uint64_t pixel) {
  if (!raster.is_colour)
    return raster.is_signed ? fmt::format("{}", static_cast<std::int64_t>(pixel))
                            : fmt::format("{}", pixel);
  const std::array<std::uint64_t, 3> rgb{pixel >> 32U & 0xffffU, pixel >> 16U & 0xffffU,
                                         pixel & 0xffffU};
  const bool narrow =
      std::all_of(rgb.begin(), rgb.end(), [](std::uint64_t c) { return c % 257 == 0; });
  if (narrow) return fmt::format("#{:02x}{:02x}{:02x}", rgb[0] / 257, rgb[1] / 257, rgb[2] / 257);
  return fmt::format("#{:04x}{:04x}{:04x}", rgb[0], rgb[1], rgb[2]);
}

using Legend = std::map<std::string, std::string, std::less<>>;

Result<Legend> parse_legend(const ImageOptions& options) {
  Legend legend;
  std::string_view rest = options.legend;
  if (constexpr std::string_view kByteOrder = "\xef\xbb\xbf"; rest.starts_with(kByteOrder))
    rest.remove_prefix(kByteOrder.size());
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = rest.find('\n');
    std::string_view text = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    if (text.empty() || text == "#" || text.starts_with("# ")) continue;
    const std::size_t comma = text.find(',');
    const auto wrong = [&](std::string_view what) {
      return Error{
          ErrorCode::syntax, fmt::format("{}:{}: {}", options.legend_source, line, what), {}, {}};
    };
    if (comma == std::string_view::npos || comma == 0 || comma + 1 == text.size())
      return wrong("expected a label and a name, as #ff0000,copper or 7,grain");
    if (!legend.emplace(lower(text.substr(0, comma)), text.substr(comma + 1)).second)
      return wrong(
          fmt::format("the label '{}' stands there a second time", legible(text.substr(0, comma))));
  }
  return legend;
}

/// Numbers the labels in the order in which they first appear, from above.
LabelImage labelled(const Raster& raster, const Legend& legend) {
  LabelImage image;
  image.width = raster.width;
  image.height = raster.height;
  image.labels.resize(raster.pixels.size());
  std::unordered_map<std::uint64_t, std::uint32_t> index;
  for (std::size_t y = raster.height; y-- > 0;) {
    for (std::size_t p = y * raster.width; p < (y + 1) * raster.width; ++p) {
      const auto [at, is_new] =
          index.emplace(raster.pixels[p], static_cast<std::uint32_t>(index.size()));
      image.labels[p] = at->second;
      if (!is_new) continue;
      LabelImage::Label label{"void", true};
      if (raster.pixels[p] != kNoPixel) {
        label.name = label_of(raster, raster.pixels[p]);
        const auto named = legend.find(label.name);
        if (named != legend.end()) label.name = named->second;
        label.is_void = named != legend.end() && named->second == "void";
      }
      image.names.push_back(std::move(label));
    }
  }
  return image;
}

/// Rows of the legend that name no pixel: a misspelt colour would stay unnamed.
void warn(const Legend& legend, const Raster& raster, std::vector<std::string>& warnings) {
  constexpr std::size_t kMost = 5;  // of each kind that are listed
  if (legend.empty()) return;
  std::set<std::string> labels;
  for (const std::uint64_t pixel : std::set(raster.pixels.begin(), raster.pixels.end()))
    if (pixel != kNoPixel) labels.insert(label_of(raster, pixel));
  std::vector<std::string> unused;
  for (const auto& [label, name] : legend)
    if (!labels.contains(label)) unused.push_back(label);
  if (unused.empty()) return;
  const auto some = [](const auto& all) {
    std::string text;
    std::size_t count = 0;
    for (const std::string& label : all) {
      if (++count > kMost) return text + ", ...";
      text += fmt::format("{}'{}'", text.empty() ? "" : ", ", legible(label));
    }
    return text;
  };
  warnings.push_back(fmt::format("{} of the legend {} of no pixel: {}; the picture has {}",
                                 counted(unused.size(), "label"), unused.size() == 1 ? "is" : "are",
                                 some(unused), labels.empty() ? "none" : some(labels)));
}

void warn(const ImageBorders& borders, std::vector<std::string>& warnings) {
  if (borders.tiny > 0)
    warnings.push_back(
        fmt::format("{} of fewer than 4 pixels: is the picture a photograph, or were its edges "
                    "softened? --speckle N makes those of fewer than N part of what is around",
                    counted(borders.tiny, "region")));
  if (borders.less_smoothed > 0)
    warnings.push_back(fmt::format("{} of {} smoothed less, where others are near",
                                   counted(borders.less_smoothed, "border"), borders.smoothed));
}

/// What the file says and pictures do not take.
void warn(const Raster& raster, const Legend& legend, const std::string& source,
          std::vector<std::string>& warnings) {
  if (const auto& place = raster.place)
    warnings.push_back(fmt::format(
        "the picture has a place on a map, which is left out: its first pixel is at ({}, {}){}{}, "
        "a pixel {} by {}, and here it is a unit square; 'gdal_polygonize.py {} -f GeoJSON "
        "OUT.geojson' makes a map of it, and --material-field DN takes its numbers",
        place->first.x, place->first.y, place->system.empty() ? "" : " of ", place->system,
        place->pixel_width, place->pixel_height, source));
  if (!raster.no_data) return;
  const std::string label = label_of(raster, *raster.no_data);
  if (!legend.contains(label))
    warnings.push_back(
        fmt::format("pixels of {} hold no data, as the file says, and count as a material here: a "
                    "line '{},void' in the file of --legend makes them void",
                    label, label));
}

}  // namespace

Result<Input> parse_image(std::string_view data, std::string_view extension,
                          const std::string& source, const ImageOptions& options) {
  const auto* const format =
      std::find_if(kImageFormats.begin(), kImageFormats.end(),
                   [&](const ImageFormat& f) { return f.extension == extension; });
  if (format == kImageFormats.end())
    return Error{ErrorCode::unsupported_format,
                 fmt::format("{}: no reader for pictures named '*{}'", source, extension),
                 {},
                 {}};
  const Result<Raster> raster = format->decode(data, source);
  if (!raster) return raster.error();
  return input_of(*raster, source, options);
}

Result<Input> input_of(const Raster& raster, const std::string& source,
                       const ImageOptions& options) {
  const Result<Legend> legend = parse_legend(options);
  if (!legend) return legend.error();
  LabelImage image = labelled(raster, *legend);
  const std::size_t taken = options.speckle > 1 ? take_in_speckles(image, options.speckle) : 0;
  Result<ImageBorders> borders = borders_of(image, options.smooth, source);
  if (!borders) return std::move(borders).error();
  Input input;
  input.source = source;
  input.is_picture = true;
  input.polygons = std::move(borders->polygons);
  if (taken > 0)
    input.warnings.push_back(fmt::format("{} of fewer than {} pixels became part of what is around",
                                         counted(taken, "set"), options.speckle));
  if (raster.pictures > 1)
    input.warnings.push_back(
        fmt::format("the file has {} pictures: the first is taken", raster.pictures));
  if (input.polygons.empty())
    input.warnings.emplace_back("all pixels are transparent, or void by the legend");
  warn(*borders, input.warnings);
  warn(*legend, raster, input.warnings);
  warn(raster, *legend, source, input.warnings);
  for (InputPolygon& polygon : input.polygons) {
    for (std::vector<Point>& ring : polygon.rings)
      for (Point& p : ring)
        p = {raster.corner.x + p.x * raster.pixel_width,
             raster.corner.y + p.y * raster.pixel_height};
  }
  return input;
}

}  // namespace cover
