// Tested by tests/unit/io/input/meshes/read_size_field_test.cpp.
#include <cover/read_size_field.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include <cover/option_table.hpp>
#include <cover/text.hpp>

#include "base/expression.hpp"
#include "base/faults/errors.hpp"
#include "base/faults/out_of_memory.hpp"
#include "base/numbers.hpp"
#include "geom/box.hpp"
#include "geom/vector.hpp"
#include "io/input/meshes/plane_fields.hpp"

namespace cover {
namespace {

/// Edges come out up to this much longer than asked; measured by tests/cli.
constexpr double kLongestEdge = 1.5;

std::vector<std::string> array_names(const PlaneField& field) {
  std::vector<std::string> names;
  for (const PlaneField::Array& array : field.arrays) names.push_back(array.name);
  return names;
}

/// The edge lengths by point, or what there is instead.
Result<PlaneField::Array*> find_sizes(PlaneField& field, const std::string& path) {
  for (const char* name : {"size", "h"}) {
    for (PlaneField::Array& array : field.arrays)
      if (array.name == name) return &array;
  }
  if (field.arrays.size() == 1) return field.arrays.data();
  if (field.arrays.empty())
    return wrong_file(path, "no point array with one component, of edge lengths");
  return wrong_file(path,
                    fmt::format("which point array has the edge lengths? None of {} is called size "
                                "or h; values that are no lengths need --size-of",
                                listed(array_names(field))));
}

/// Edge lengths, and the name of their array.
struct LengthsOfFile {
  SizeSamples samples;
  std::string array;
};

Result<LengthsOfFile> read_lengths(const std::string& path) {
  Result<PlaneField> field = read_plane_field(path);
  if (!field) return std::move(field).error();
  const Result<PlaneField::Array*> sizes = find_sizes(*field, path);
  if (!sizes) return sizes.error();
  return LengthsOfFile{
      {std::move(field->points), std::move(field->triangles), std::move((*sizes)->values)},
      std::move((*sizes)->name)};
}

/// The values by point of what sizes shall follow. A warning tells of points without a number, but
/// for those where the file has none.
///
/// Errors: bad_option where no point has one
Result<std::vector<double>> values_of(const PlaneField& field, const std::string& of,
                                      const std::string& path, std::vector<std::string>& warnings) {
  std::vector<std::string> names = array_names(field);
  std::string text = of;
  if (is_function_name(of)) {
    if (names.size() != 1)
      return wrong_file(path, fmt::format("{} of which point array? Of {}, as {}({})", of,
                                          names.empty() ? "none" : listed(names), of,
                                          names.empty() ? "name" : names.front()));
    text = fmt::format("{}('{}')", of, names.front());
  }
  names.insert(names.end(), {"x", "y"});
  const Result<Expression> formula = Expression::parse(text, names);
  if (!formula)
    return bad_option(
        fmt::format("size-of, of the values in {}: {}", path, formula.error().message));
  std::vector<double> out, row(names.size());
  out.reserve(field.points.size());
  std::size_t numbers = 0, missed = 0;
  std::optional<std::size_t> first_missed;
  for (std::size_t p = 0; p < field.points.size(); ++p) {
    for (std::size_t k = 0; k < field.arrays.size(); ++k) row[k] = field.arrays[k].values[p];
    row[names.size() - 2] = field.points[p].x;
    row[names.size() - 1] = field.points[p].y;
    out.push_back((*formula)(row));
    if (std::isfinite(out.back())) {
      ++numbers;
      continue;
    }
    bool is_gap = false;
    for (std::size_t k = 0; k < row.size(); ++k)
      is_gap = is_gap || (formula->uses(k) && !std::isfinite(row[k]));
    if (is_gap) continue;
    ++missed;
    if (!first_missed) first_missed = p;
  }
  if (numbers == 0 && !out.empty())
    return bad_option(fmt::format("size-of '{}' is a number at no point of {}", of, path));
  if (first_missed)
    warnings.push_back(fmt::format(
        "size-of '{}' is no number at {} of {} points of {}, first at {}: triangles there ask for "
        "no size",
        of, missed, out.size(), path, describe(field.points[*first_missed])));
  return out;
}

/// How much a value that is linear in a triangle changes along a unit of length; 0 where the
/// triangle is flat or has corners without a value.
double slope_in(const std::array<Point, 3>& corners, const std::array<double, 3>& values) {
  const Vector u = corners[1] - corners[0], v = corners[2] - corners[0];
  const double area = cross(u, v);
  const double of_u = values[1] - values[0], of_v = values[2] - values[0];
  const Vector gradient{(of_u * v.y - of_v * u.y) / area, (of_v * u.x - of_u * v.x) / area};
  const double slope = length(gradient);
  return area != 0 && std::isfinite(slope) ? slope : 0;
}

/// Sizes along which what the file's values say changes by no more than a step.
Result<SizeSamples> sizes_by_change(const std::string& path, const std::string& of, double step,
                                    std::vector<std::string>& warnings) {
  Result<PlaneField> field = read_plane_field(path);
  if (!field) return std::move(field).error();
  const Result<std::vector<double>> values = values_of(*field, of, path, warnings);
  if (!values) return values.error();
  if (field->triangles.empty())
    return wrong_file(path, "no triangles between the points, along which values could change");
  for (const Point& p : field->points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      return wrong_file(path, "the coordinates of a point are not finite");
  }
  std::vector<double> slopes(field->points.size(), 0);
  for (const auto& [a, b, c] : field->triangles) {
    const double slope = slope_in({field->points[a], field->points[b], field->points[c]},
                                  {(*values)[a], (*values)[b], (*values)[c]});
    for (const std::uint32_t v : {a, b, c}) slopes[v] = std::max(slopes[v], slope);
  }
  const double longest_edge = cover::box_of(field->points).diagonal();
  std::vector<double> sizes;
  for (const double slope : slopes)
    sizes.push_back(std::min(step / slope / kLongestEdge, longest_edge));
  return SizeSamples{std::move(field->points), std::move(field->triangles), std::move(sizes)};
}

/// What options say of the sizes in a file; a warning tells where nothing says that they are any.
Result<SizeSamples> read_samples(const Options& options, std::vector<std::string>& warnings) {
  const std::string& path = options.size_field_name;
  if (!options.size_of.empty())
    return sizes_by_change(path, options.size_of, options.size_step, warnings);
  Result<LengthsOfFile> lengths = read_lengths(path);
  if (!lengths) return std::move(lengths).error();
  if (lengths->array != "size" && lengths->array != "h")
    warnings.push_back(fmt::format(
        "{}: the only array, '{}', is taken for edge lengths; values that are no lengths need "
        "--size-of",
        path, lengths->array));
  return std::move(lengths->samples);
}

Box box_of(const Input& input) {
  Box box = cover::box_of(input.points);
  for (const InputPolygon& polygon : input.polygons)
    for (const std::vector<Point>& ring : polygon.rings) box.include(cover::box_of(ring));
  for (const InputLine& line : input.lines) box.include(cover::box_of(line.points));
  return box;
}

std::string corners_of(const Box& box) {
  return fmt::format("from {} to {}", describe(box.low), describe(box.high));
}

/// Whether no more than a hundredth of the smaller one along an axis is in both, or one is like a
/// point for the other. A field at a single point or line is no smaller than it should be.
bool are_apart(const Box& drawing, const Box& field) {
  constexpr double kHardly = 0.01, kMuchLarger = 1000;
  const auto hardly_meet = [&](double low_a, double high_a, double low_b, double high_b) {
    const double both = std::min(high_a, high_b) - std::max(low_a, low_b);
    return both < kHardly * std::min(high_a - low_a, high_b - low_b);
  };
  const double a = drawing.diagonal(), b = field.diagonal();
  return hardly_meet(drawing.low.x, drawing.high.x, field.low.x, field.high.x) ||
         hardly_meet(drawing.low.y, drawing.high.y, field.low.y, field.high.y) ||
         b > kMuchLarger * a || (b > 0 && a > kMuchLarger * b);
}

bool is_one_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored);
}

/// Whether all options are legal once the file is read.
Status check_but_for_file(Options options) {
  options.size_field = [](Point) { return kNoNumber; };
  return check_options(options);
}

void scale(SizeSamples& samples, double factor) {
  if (factor == 1) return;
  for (Point& p : samples.points) p = {p.x * factor, p.y * factor};
  for (double& size : samples.sizes) size *= factor;
}

}  // namespace

Result<SizeSamples> read_size_field(const std::string& path) {
  Result<LengthsOfFile> lengths = read_lengths(path);
  if (!lengths) return std::move(lengths).error();
  return std::move(lengths->samples);
}

Result<SizeSamples> read_size_field(const std::string& path, const std::string& of, double step) {
  std::vector<std::string> unheard;
  return sizes_by_change(path, of, step, unheard);
}

Status load_size_field(Options& options) {
  Input nothing;
  return load_size_field(options, nothing);
}

Status load_size_field(Options& options, Input& input) {
  return memory_as_value(options.size_field_name, [&]() -> Status {
    if (options.size_field || options.size_field_name.empty()) return ok();
    if (Status status = check_but_for_file(options); !status) return status;
    const std::string& path = options.size_field_name;
    Result<SizeSamples> samples = read_samples(options, input.warnings);
    if (!samples) return samples.error();
    if (is_one_file(path, input.source)) options.size_field_scale = input.scale;
    scale(*samples, options.size_field_scale);
    Result<SizeFunction> sizes = size_function(*samples, options.growth.value_or(Options::kGrowth));
    if (!sizes) {
      Error error = std::move(sizes).error();
      error.message = fmt::format("{}: {}", path, error.message);
      return error;
    }
    options.size_field = *std::move(sizes);
    const Box drawing = box_of(input), field = cover::box_of(samples->points);
    const std::string alone = input.scale == options.size_field_scale
                                  ? ""
                                  : fmt::format(
                                        "the drawing alone was multiplied by {}, not places "
                                        "and lengths of the size field {}",
                                        input.scale, path);
    if (!drawing.is_empty() && !field.is_empty() && are_apart(drawing, field)) {
      input.warnings.push_back(fmt::format(
          "the size field {} lies {}, and the drawing {}: {}{}{}", path, corners_of(field),
          corners_of(drawing),
          drawing.meets(field)
              ? "few of its sizes count, outside of it those of the nearest place"
              : "the whole drawing is outside of it, where the size of the nearest place on its "
                "border counts",
          alone.empty() ? "" : "; ", alone));
    } else if (!alone.empty()) {
      input.warnings.push_back(alone);
    }
    return ok();
  });
}

}  // namespace cover
