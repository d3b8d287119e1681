// cover render: a picture of a mesh, without a display.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/files.hpp>
#include <cover/picture.hpp>
#include <cover/read_mesh.hpp>
#include <cover/text.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "files/mesh_file.hpp"
#include "files/writers.hpp"
#include "png/draw_png.hpp"
#include "terminal/console.hpp"
#include "terminal/interrupt.hpp"

namespace cover::app {

namespace {

/// The number of each triangle, by its corners in rising order.
std::map<std::array<std::uint32_t, 3>, std::size_t> triangles_by_corners(
    const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::map<std::array<std::uint32_t, 3>, std::size_t> numbers;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners = triangles[t];
    std::sort(corners.begin(), corners.end());
    numbers.emplace(corners, t);
  }
  return numbers;
}

/// Gives triangles the regions and materials that `known` has for the same ones; false, and nothing
/// is changed, if these are not the same. Many formats hold groups alone, and regions are made out
/// of them; so names are by the numbers of `known`.
bool take_regions(const TriangleSoup& known, TriangleSoup& soup) {
  if (known.points != soup.points || known.triangles.size() != soup.triangles.size()) return false;
  const auto numbers = triangles_by_corners(known.triangles);
  std::vector<std::int64_t> region, material;
  for (std::array<std::uint32_t, 3> corners : soup.triangles) {
    std::sort(corners.begin(), corners.end());
    const auto found = numbers.find(corners);
    if (found == numbers.end()) return false;
    region.push_back(known.region[found->second]);
    material.push_back(known.material[found->second]);
  }
  soup.region = std::move(region);
  soup.material = std::move(material);
  return true;
}

/// What regions of `known` have at points, for the arrays of the same names in `mesh`.
RegionValues values_of_regions(const PictureMesh& known, const MeshFile& mesh) {
  RegionValues values(mesh.point_arrays.size());
  for (std::size_t k = 0; k < known.region_values.size(); ++k) {
    const auto has_name = [&name = known.mesh.point_arrays[k].name](
                              const PlaneField::Array& array) { return array.name == name; };
    const auto at = std::find_if(mesh.point_arrays.begin(), mesh.point_arrays.end(), has_name);
    if (at != mesh.point_arrays.end())
      values[static_cast<std::size_t>(at - mesh.point_arrays.begin())] = known.region_values[k];
  }
  return values;
}

/// With regions, names and contacts as read_output() has them; of what it refuses, with the numbers
/// of the file.
Result<PictureMesh> read_picture(const std::string& path) {
  const bool blocks = extension_of(path) == ".vtm";
  const Result<Output> known = read_output(path);
  if (blocks) return known ? Result<PictureMesh>(picture_of(*known)) : known.error();
  Result<MeshFile> mesh = read_mesh(path);
  if (!mesh) return std::move(mesh).error();
  PictureMesh picture;
  if (known) picture = picture_of(*known);
  // Lines are by vertex: they hold only where both readers count alike.
  if (!take_regions(picture.mesh.soup, mesh->soup)) picture = {};
  picture.region_values = values_of_regions(picture, *mesh);
  picture.mesh = *std::move(mesh);
  return picture;
}

/// Warns of a window that shows nothing of the mesh.
void check_window(const PictureOptions& options, const std::vector<Point>& points,
                  spdlog::logger& log) {
  if (!options.window || points.empty()) return;
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x; });
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(), [](Point a, Point b) { return a.y < b.y; });
  const auto& [from, to] = *options.window;
  if (from.x <= right->x && to.x >= left->x && from.y <= high->y && to.y >= low->y) return;
  log.warn("the window shows nothing: the mesh lies between {} and {}",
           describe(Point{left->x, low->y}), describe(Point{right->x, high->y}));
}

/// What the command line says.
struct Asked {
  std::string path, format = "svg";
  std::vector<std::string> outputs;
  std::vector<double> window, range;
  PictureOptions options;
  Verbosity verbosity;
  bool no_edges = false;

  [[nodiscard]] PictureOptions picture_options() const {
    PictureOptions all = options;
    all.edges = !no_edges;
    if (!window.empty()) all.window = {{window[0], window[1]}, {window[2], window[3]}};
    if (!range.empty()) all.range = {range[0], range[1]};
    return all;
  }
};

void add_options(CLI::App& app, Asked& asked) {
  app.add_option("mesh", asked.path,
                 fmt::format("Mesh to draw: {}; names from the .vtm or .json beside it; {}",
                             listed(mesh_formats()), kMeshStreamHelp))
      ->type_name("")
      ->required();
  app.add_option("-o,--output", asked.outputs, "Picture to write (.svg, .png); '-' is stdout")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->required();
  app.add_option("--format", asked.format, "Format of '-o -': svg or png")
      ->check(one_of({"svg", "png"}))
      ->type_name("EXT")
      ->capture_default_str();
  app.add_option("--color", asked.options.color,
                 "Colour by this array of triangles or points, say max_angle, or by an expression "
                 "of arrays as --size-of has them, say \"asinh(Net/1e17)\"")
      ->type_name("ARRAY");
  app.add_option("--range", asked.range,
                 "Values at both ends of the colours: LOW,HIGH (default: found)")
      ->type_name("LOW,HIGH")
      ->delimiter(',')
      ->expected(2);
  app.add_option("--window", asked.window, "Draw only this part: X0,Y0,X1,Y1")
      ->type_name("BOX")
      ->delimiter(',')
      ->expected(4);
  app.add_option("--width", asked.options.width, "Width in pixels")
      ->check(number_in({200, 20000}))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--worst", asked.options.worst, "Mark so many of the largest angles")
      ->check(number_in({0, 100}))
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("--no-edges", asked.no_edges, "Leave out the edges inside regions");
  app.add_flag("--y-down", asked.options.y_down,
               "Draw y downwards, as devices of .tif and .str have it: the surface on top");
  app.add_option("--title", asked.options.title,
                 "First line (default: name and number of triangles)")
      ->type_name("TEXT");
  add_verbosity(app, asked.verbosity);
}

Status draw(const PictureMesh& picture, const PictureOptions& options, const std::string& output,
            const std::string& extension) {
  return write_to(output, extension, [&](const std::string& target) {
    return extension == ".svg" ? write_svg(picture, options, target)
                               : draw_png(picture, options, target);
  });
}

}  // namespace

int run_render(Arguments arguments) {
  CLI::App app("Draw a mesh; needs no display", "cover render");
  app.set_help_flag("-h,--help", "Show this help");
  app.footer(R"(Examples:
  cover render device.vtm -o device.svg
  cover render device.vtm -o device.png --color max_angle
  cover render device.vtm -o oxide.png --window -60,-10,60,10
)");
  Asked asked;
  add_options(app, asked);
  if (const auto code = parse(app, std::move(arguments))) return *code;

  std::vector<NamedFile> written{log_file(asked.verbosity)};
  for (const std::string& output : asked.outputs) {
    const std::string extension = extension_of_output(output, asked.format);
    if (extension != ".svg" && extension != ".png")
      return usage_error(app, fmt::format("cannot draw '{}': possible are .svg, .png", output));
    written.push_back({"-o", output});
  }
  if (const Status files = check_files({{"", asked.path}}, written); !files)
    return usage_error(app, files.error());

  const auto log = make_logger(asked.verbosity);
  const Interrupt interrupt;
  if (!asked.range.empty() && asked.options.color.empty())
    log->warn("--range does nothing: it counts with --color only");
  const Result<MeshSource> source = MeshSource::open(asked.path);
  if (!source) return fail(*log, source.error());
  const Result<PictureMesh> picture = read_picture(source->file());
  if (!picture) return fail(*log, source->named(picture.error()));
  PictureOptions options = asked.picture_options();
  check_window(options, picture->mesh.soup.points, *log);
  if (options.title.empty()) {
    const std::string name = std::filesystem::path(source->name()).filename().string();
    options.title =
        fmt::format("{}: {} triangles", name, grouped(picture->mesh.soup.triangles.size()));
  }
  for (const std::string& output : asked.outputs) {
    const Status drawn = draw(*picture, options, output, extension_of_output(output, asked.format));
    if (!drawn) return fail(*log, drawn.error());
    if (!asked.verbosity.quiet && output != "-") fmt::print("Wrote {}\n", output);
  }
  return exit_ok;
}

}  // namespace cover::app
