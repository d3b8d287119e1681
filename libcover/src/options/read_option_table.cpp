// Tested by tests/unit/options/read_option_table_test.cpp.
#include <cover/read_option_table.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "options/option_kinds.hpp"

namespace cover {
namespace {

using option_kinds::flag;
using option_kinds::named;
using option_kinds::number;
using option_kinds::parse;
using option_kinds::text;
using option_kinds::texts;
using option_kinds::whole;

/// An extension, with or without its dot.
constexpr ReadOptionEntry format_name(ReadOptionEntry row) {
  row = text<&ReadOptions::format>(row);
  row.set = [](const ReadOptionEntry&, std::string_view value, ReadOptions& options) -> Status {
    if (value.empty() || value == ".") return bad_option("an extension is needed, as gds");
    options.format = value.front() == '.' ? std::string(value) : "." + std::string(value);
    return ok();
  };
  return row;
}

bool is_window(const Window& w) {
  return w.low.x < w.high.x && w.low.y < w.high.y && std::isfinite(w.low.x) &&
         std::isfinite(w.low.y) && std::isfinite(w.high.x) && std::isfinite(w.high.y);
}

/// Four numbers with commas between them.
constexpr ReadOptionEntry window(ReadOptionEntry row) {
  row.kind = OptionKind::text;
  row.set = [](const ReadOptionEntry&, std::string_view value, ReadOptions& options) -> Status {
    std::array<double, 4> numbers{};
    std::string_view rest = value;
    bool good = true;
    for (double& n : numbers) {
      const std::size_t comma = &n == &numbers.back() ? rest.size() : rest.find(',');
      const std::optional<double> parsed = parse<double>(rest.substr(0, comma));
      good &= parsed.has_value() && comma != std::string_view::npos;
      if (!good) break;
      n = *parsed;
      rest.remove_prefix(std::min(rest.size(), comma + 1));
    }
    const Window made{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
    if (!good || !is_window(made))
      return bad_option(
          fmt::format("'{}' is not x0,y0,x1,y1 with x0 below x1 and y0 below y1", value));
    options.window = made;
    return ok();
  };
  row.get = [](const ReadOptionEntry&, const ReadOptions& options) {
    if (!options.window) return std::vector<std::string>();
    const auto& [low, high] = *options.window;
    return std::vector{fmt::format("{},{},{},{}", low.x, low.y, high.x, high.y)};
  };
  row.check = [](const ReadOptionEntry&, const ReadOptions& options) -> Status {
    if (!options.window || is_window(*options.window)) return ok();
    return bad_option(
        "window is not two finite corners, the first below and to the left of the second");
  };
  return row;
}

template <class... Extensions>
bool is_format(const ReadOptions& options, Extensions... extensions) {
  return ((options.format == extensions) || ...);
}
bool is_layout(const ReadOptions& o) {
  return is_format(o, ".gds", ".gds2", ".gdsii", ".oas", ".oasis");
}
/// GeoJSON has no curves.
bool is_map_with_curves(const ReadOptions& o) {
  return is_format(o, ".shp", ".gpkg", ".fgb", ".gml", ".kml");
}
bool is_map(const ReadOptions& o) { return is_map_with_curves(o) || is_format(o, ".geojson"); }
/// GeoJSON is often named .json; what is no map after all is told by its reader.
bool is_maybe_map(const ReadOptions& o) { return is_map(o) || is_format(o, ".json"); }
bool is_drawing(const ReadOptions& o) { return is_format(o, ".dxf"); }
/// Commands of the Sentaurus Structure Editor, which has circles.
bool is_deck(const ReadOptions& o) { return is_format(o, ".cmd", ".scm"); }
bool is_picture(const ReadOptions& o) {
  return is_format(o, ".png", ".bmp", ".tif", ".tiff", ".nrrd", ".mha", ".vti", ".vtk");
}

// clang-format off
constexpr ReadOptionEntry kReadTable[] = {
    named<&ReadOptions::unit>({
        .name = "unit", .placeholder = "UNIT",
        .word_list = {"nm", "um", "mm", "cm", "m"},
        .help = "What the coordinates mean, for reports: nm, um, mm, cm, m"}),
    number<&ReadOptions::scale>({
        .name = "scale", .placeholder = "F",
        .range = ranges::kScale,
        .help = "Multiply all lengths by F first, say 1e-9, or 25.4 for inches to mm; told where "
                "it rounds"}),
    format_name({
        .name = "input-format", .placeholder = "EXT",
        .help = "Format of the input, whatever its name; also for '-' and pipes"}),
    texts<&ReadOptions::layers>({
        .name = "layer", .placeholder = "NAME",
        .help = "Read this layer only, several if repeated: a name, or 68/20 in a layout",
        .counts_with = "drawings, layouts and maps",
        .counts = [](const ReadOptions& o) { return is_layout(o) || is_drawing(o) || is_map(o); }}),
    texts<&ReadOptions::layer_map>({
        .name = "layer-map", .placeholder = "MAP",
        .help = "Layers of a layout by name: 68/20=met1, or a file of such lines; the last lies on "
                "top, and what is not there is left out",
        .counts_with = "layouts",
        .counts = is_layout}),
    text<&ReadOptions::label_layer>({
        .name = "label-layer", .placeholder = "NAME",
        .help = "Texts on this layer name the regions in which they stand: MATERIAL, "
                "MATERIAL/REGION or void in a drawing, REGION in a layout",
        .counts_with = "drawings and layouts",
        .counts = [](const ReadOptions& o) { return is_layout(o) || is_drawing(o); }}),
    text<&ReadOptions::cell>({
        .name = "cell", .placeholder = "NAME",
        .help = "Cell of a layout; its top cell unless given",
        .counts_with = "layouts",
        .counts = is_layout}),
    window({
        .name = "window", .placeholder = "X0,Y0,X1,Y1",
        .help = "Part of a layout; what is outside is cut off",
        .counts_with = "layouts",
        .counts = is_layout}),
    number<&ReadOptions::chord_error>({
        .name = "chord-error", .placeholder = "E",
        .range = ranges::kChordError,
        .help = "How far a chord may be from the curve of a drawing, as a length in the file's unit",
        .counts_with = "drawings and layouts",
        .counts = [](const ReadOptions& o) { return is_layout(o) || is_drawing(o) || is_deck(o); }}),
    number<&ReadOptions::chord_angle>({
        .name = "chord-angle", .placeholder = "DEG",
        .range = ranges::kChordAngle,
        .help = "What a chord may turn by along a curve of a drawing; 5 degrees unless given",
        .counts_with = "drawings, layouts and maps with curves",
        .counts = [](const ReadOptions& o) {
          return is_layout(o) || is_drawing(o) || is_deck(o) || is_map_with_curves(o);
        }}),
    text<&ReadOptions::material_field>({
        .name = "material-field", .placeholder = "NAME",
        .help = "Attribute of a map that is the material; 'material' unless given, else 'name'",
        .counts_with = "maps",
        .counts = is_maybe_map}),
    text<&ReadOptions::name_field>({
        .name = "name-field", .placeholder = "NAME",
        .help = "Attribute of a map that is the name of the region or contact; 'name' unless given",
        .counts_with = "maps",
        .counts = is_maybe_map}),
    text<&ReadOptions::priority_field>({
        .name = "priority-field", .placeholder = "NAME",
        .help = "Attribute of a map of which the higher wins where polygons overlap; 'priority' unless "
                "given",
        .counts_with = "maps",
        .counts = is_maybe_map}),
    texts<&ReadOptions::keep_fields>({
        .name = "keep-field", .placeholder = "NAME",
        .help = "Attribute of a map that the triangles keep, several if repeated: an array of numbers, "
                "or of words by number; 'fid' is the number of the feature",
        .counts_with = "maps",
        .counts = is_maybe_map}),
    text<&ReadOptions::crs>({
        .name = "crs", .placeholder = "CRS",
        .help = "Project a map to these coordinates, as EPSG:25832",
        .counts_with = "maps",
        .counts = is_map}),
    whole<&ReadOptions::speckle>({
        .name = "speckle", .placeholder = "N",
        .range = ranges::kSpeckle,
        .help = "Sets of fewer than N pixels of a picture become part of what is around them",
        .more = "For noise, and for edges that were softened.",
        .counts_with = "pictures",
        .counts = is_picture}),
    flag<&ReadOptions::smooth, false>({
        .name = "no-smooth",
        .help = "Borders of a picture are the sides of its pixels, not curves along them",
        .counts_with = "pictures",
        .counts = is_picture}),
    text<&ReadOptions::legend>({
        .name = "legend", .placeholder = "FILE",
        .help = "Names of the labels of a picture: lines #ff0000,copper or 7,grain; void is no "
                "material",
        .counts_with = "pictures",
        .counts = is_picture}),
};
// clang-format on

}  // namespace

std::span<const ReadOptionEntry> read_option_table() { return kReadTable; }

const ReadOptionEntry* find_read_option(std::string_view name) {
  return option_kinds::find_in<ReadOptions>(kReadTable, name);
}

std::string default_text(const ReadOptionEntry& entry) { return option_kinds::default_of(entry); }

std::vector<Provenance::Setting> describe_read_options(const ReadOptions& options) {
  std::vector<Provenance::Setting> settings;
  for (const ReadOptionEntry& entry : kReadTable) {
    if (entry.name == "unit" || entry.name == "scale") continue;
    std::vector<std::string> values = entry.get(entry, options);
    if (values == entry.get(entry, ReadOptions())) continue;
    for (std::string& value : values) settings.push_back({std::string(entry.name), value});
  }
  return settings;
}

Status check_read_options(const ReadOptions& options) {
  return option_kinds::check_all<ReadOptions>(kReadTable, options);
}

}  // namespace cover
