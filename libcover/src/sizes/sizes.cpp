// See sizes.hpp.
// Tested by tests/unit/sizes/sizes_test.cpp.
#include "sizes/sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <cover/regions.hpp>
#include <cover/text.hpp>

#include "base/expression.hpp"
#include "base/numbers.hpp"
#include "base/words/meant_or_there.hpp"
#include "base/words/quoted_names.hpp"
#include "geom/box.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "region/lines_between.hpp"
#include "sizes/fields/ask_size.hpp"
#include "sizes/fields/graded_function.hpp"
#include "sizes/segment_sizes.hpp"
#include "sizes/size_field.hpp"

namespace cover {
namespace {

/// Of the extent of all: where expressions are looked at in any case. Some 3,000 places take 3 ms.
constexpr double kGrid = 1.0 / 32;
constexpr double kLeastSpacings = 32;  ///< of coordinates: the shortest edge that can be asked for

/// Zero stands for "none".
void make_smaller(double& size, double wished) {
  size = size == 0 ? wished : std::min(size, wished);
}

/// Adds the size of a rule, or its expression, to those inside a region.
void add_rule(const SizeRule& rule, RegionBoundary& boundary) {
  if (rule.expression.empty()) return make_smaller(boundary.size, rule.size);
  boundary.size_expressions.push_back(rule.expression);
}

/// Sets the sizes inside regions. False if no region has that name.
bool inside(const SizeRule& rule, const RegionTable& table, std::span<RegionBoundary> boundaries) {
  if (rule.name.empty()) {
    for (RegionBoundary& boundary : boundaries) add_rule(rule, boundary);
    return true;
  }
  const std::vector<RegionId> regions = named_regions(table, rule.name);
  for (const RegionId region : regions) add_rule(rule, boundaries[place_of(region)]);
  return !regions.empty();
}

/// What an expression asks for, but no less than `least`: where it is zero, that.
Result<SizeFunction> function_of(const std::string& expression, std::optional<double> least) {
  static const std::array<std::string, 2> place{"x", "y"};
  Result<Expression> formula = Expression::parse(expression, place);
  if (!formula) return std::move(formula).error();
  const auto shared = std::make_shared<const Expression>(*std::move(formula));
  return SizeFunction([shared, least](Point p) {
    const double size = (*shared)(std::array{p.x, p.y});
    return least && size >= 0 ? std::max(size, *least) : size;
  });
}

bool is_in_void(const RegionTable& table, VertexId v) {
  return std::find(table.void_points.begin(), table.void_points.end(), v) !=
         table.void_points.end();
}

/// Why no size can be asked for at points of that name that lie in the void; empty: none do.
std::string points_in_void(const Pslg& pslg, const RegionTable& table, const std::string& name) {
  const auto point = std::find_if(
      pslg.named_points.begin(), pslg.named_points.end(),
      [&](const NamedPoint& p) { return p.name == name && is_in_void(table, p.vertex); });
  if (point == pslg.named_points.end()) return "";
  return fmt::format("the point of that name lies in the void, at {}",
                     describe(pslg.points[point->vertex.index()]));
}

/// Sets the sizes at PSLG points: at all that have the name, else at the point of that number, else
/// along a boundary marker. False if there is none.
bool at_points(const SizeRule& rule, const Pslg& pslg, const RegionTable& table,
               std::vector<double>& size_at, std::vector<double>& size_along) {
  const bool is_line = std::any_of(table.interfaces.begin(), table.interfaces.end(),
                                   [&](const Interface& line) { return line.name == rule.name; });
  bool is_point = false;
  for (const NamedPoint& point : pslg.named_points) {
    if (point.name != rule.name || is_in_void(table, point.vertex)) continue;
    make_smaller(size_at[point.vertex.index()], rule.size);
    is_point = true;
  }
  if (is_point && !is_line) return true;
  for (std::size_t v = 0; v < pslg.points.size() && !is_line; ++v) {
    if (pslg.point_ids[v] < 0 || std::to_string(pslg.point_ids[v]) != rule.name) continue;
    make_smaller(size_at[v], rule.size);
    return true;
  }
  const std::vector<SegmentId> segments = named_segments(pslg, table, rule.name);
  for (const SegmentId s : segments) {
    make_smaller(size_along[s.index()], rule.size);
    make_smaller(size_at[pslg.segments[s.index()].a.index()], rule.size);
    make_smaller(size_at[pslg.segments[s.index()].b.index()], rule.size);
  }
  return !segments.empty();
}

/// The rule with its name out of quotation marks; nothing if there are none. A name that has them
/// itself needs none around it.
std::optional<SizeRule> without_quotes(const SizeRule& rule) {
  std::string_view rest = rule.name;
  std::optional<std::string> name = rest.starts_with('"') ? take_quoted(rest) : std::nullopt;
  if (!name || name->empty() || !rest.empty()) return std::nullopt;
  SizeRule out = rule;
  out.name = *std::move(name);
  return out;
}

Error unknown_name(const SizeRule& rule, const Pslg& pslg, const RegionTable& table) {
  std::vector<std::string> names;
  for (const Interface& line : table.interfaces) names.push_back(line.name);
  if (!rule.at) {
    Error error = no_such_region(table, "size for", rule.name);
    if (std::find(names.begin(), names.end(), rule.name) != names.end())
      error.message += "; an interface or contact has it: ask for a size at that (--size-at)";
    return error;
  }
  for (const NamedPoint& point : pslg.named_points) names.push_back(point.name);
  std::string in_void = line_in_void(pslg, rule.name);
  if (in_void.empty()) in_void = points_in_void(pslg, table, rule.name);
  const std::string between = lines_between(table, rule.name);
  return {ErrorCode::bad_option,
          fmt::format("size for '{}': {}", rule.name,
                      in_void.empty()
                          ? "there is no interface, contact, point or boundary marker of "
                            "that name" +
                                (between.empty() ? meant_or_there(rule.name, names) : between)
                          : in_void),
          {},
          {}};
}

/// The expressions, each once, that are a size at no vertex of the regions they are for.
std::vector<std::string> sizes_of_nothing(std::span<const RegionBoundary> boundaries,
                                          std::optional<double> least) {
  struct Wish {
    Result<SizeFunction> function;
    bool is_heard = false;
  };
  std::map<std::string, Wish> wishes;
  for (const RegionBoundary& boundary : boundaries) {
    for (const std::string& expression : boundary.size_expressions) {
      auto at = wishes.find(expression);
      if (at == wishes.end())
        at = wishes.emplace(expression, Wish{function_of(expression, least)}).first;
      Wish& wish = at->second;
      if (wish.is_heard || !wish.function) continue;
      wish.is_heard = std::any_of(boundary.points.begin(), boundary.points.end(), [&](Point p) {
        const double size = (*wish.function)(p);
        return size > 0 && std::isfinite(size);
      });
    }
  }
  std::vector<std::string> unheard;
  for (const auto& [expression, wish] : wishes) {
    if (!wish.is_heard) unheard.push_back(expression);
  }
  return unheard;
}

/// Sizes that coordinates cannot hold: cut at such lengths, rounded points would coincide.
Status check_spacing(const Pslg& pslg, const RegionTable& table, const Options& options) {
  const double spacing = spacing_of(pslg.points);
  double smallest = kInfinity;
  for (const SizeRule& rule : options.sizes) {
    if (rule.expression.empty()) smallest = std::min(smallest, rule.size);
  }
  for (const Region& region : table.regions) {
    if (options.input_sizes && region.size) smallest = std::min(smallest, *region.size);
  }
  if (!(smallest < kLeastSpacings * spacing)) return ok();
  return Error{
      ErrorCode::bad_option,
      fmt::format("the size {} is too small: coordinates as large as {} are {} apart, and "
                  "edges need {} times that",
                  describe_roughly(smallest), describe_roughly(largest_coordinate(pslg.points)),
                  describe_roughly(spacing), kLeastSpacings),
      {},
      {}};
}

}  // namespace

Status read_expressions(RegionBoundary& boundary, const Options& options) {
  if (boundary.size_expressions.empty()) return ok();
  std::string names;
  for (const std::string& expression : boundary.size_expressions) {
    Result<SizeFunction> function = function_of(expression, options.min_size);
    if (!function) return std::move(function).error();
    boundary.size_function = smaller_of(boundary.size_function, *std::move(function));
    names += (names.empty() ? "" : "', '") + expression;
  }
  Result<GradedFunction> graded =
      graded_function(std::move(boundary.size_function), names, boundary,
                      options.growth.value_or(Options::kGrowth) - 1, options.min_size);
  if (!graded) return std::move(graded).error();
  boundary.size_function = std::move(graded->sizes);
  boundary.size_missed = graded->missed;
  return ok();
}

Status resolve_sizes(const Pslg& pslg, const RegionTable& table, const Options& options,
                     std::span<RegionBoundary> boundaries) {
  for (std::size_t r = 0; r < boundaries.size(); ++r) {
    boundaries[r].size = options.input_sizes ? table.regions[r].size.value_or(0) : 0;
    boundaries[r].size_expressions.clear();
    boundaries[r].size_function = {};
  }
  if (Status status = check_spacing(pslg, table, options); !status) return status;
  if (options.sizes.empty()) return ok();
  std::vector<double> size_at(pslg.points.size(), 0), size_along(pslg.segments.size(), 0);
  for (const SizeRule& rule : options.sizes) {
    const auto find = [&](const SizeRule& named) {
      return named.at ? at_points(named, pslg, table, size_at, size_along)
                      : inside(named, table, boundaries);
    };
    if (find(rule)) continue;
    const std::optional<SizeRule> without = without_quotes(rule);
    if (without && find(*without)) continue;
    Error error = unknown_name(rule, pslg, table);
    if (options.merge_materials)
      error.message +=
          "; with --merge-materials touching regions of one material, and their lines, have the "
          "name of the first of them";
    return error;
  }
  const double grid = kGrid * box_of(pslg.points).diagonal();
  for (RegionBoundary& boundary : boundaries) {
    boundary.size_grid = grid;
    if (Status status = read_expressions(boundary, options); !status) return status;
    boundary.size_at.clear();
    for (const VertexId v : boundary.vertices) boundary.size_at.push_back(size_at[v.index()]);
    boundary.size_along.clear();
    for (const SegmentId s : boundary.segments)
      boundary.size_along.push_back(s == kHullSide ? 0 : size_along[s.index()]);
    for (std::vector<double>* const sizes : {&boundary.size_at, &boundary.size_along}) {
      if (std::all_of(sizes->begin(), sizes->end(), [](double size) { return size == 0; }))
        sizes->clear();
    }
  }
  return ok();
}

void share_sizes(const Pslg& pslg, std::span<RegionBoundary> boundaries) {
  std::vector<double> finest(pslg.points.size(), 0);
  for (const RegionBoundary& boundary : boundaries) {
    if (!(boundary.size > 0)) continue;
    for (const VertexId v : boundary.vertices) make_smaller(finest[v.index()], boundary.size);
  }
  for (RegionBoundary& boundary : boundaries) {
    for (std::size_t v = 0; v < boundary.vertices.size(); ++v) {
      const double size = finest[boundary.vertices[v].index()];
      if (size == 0 || (boundary.size > 0 && size >= boundary.size)) continue;
      boundary.size_at.resize(boundary.vertices.size(), 0);
      make_smaller(boundary.size_at[v], size);
    }
  }
}

namespace {

/// Whether the caller's sizes are a number above zero at some vertex.
bool asks_for_something(const SizeFunction& field, std::span<const RegionBoundary> boundaries) {
  return std::any_of(boundaries.begin(), boundaries.end(), [&](const RegionBoundary& boundary) {
    return std::any_of(boundary.points.begin(), boundary.points.end(), [&](Point p) {
      const double size = ask_size(field, p);
      return size > 0 && std::isfinite(size);
    });
  });
}

/// Tells where no size counts for being larger than the whole drawing, as one in metres does where
/// coordinates are degrees.
void warn_of_vast_sizes(const Pslg& pslg, const Options& options,
                        std::span<const RegionBoundary> boundaries, std::vector<Note>& notes) {
  double smallest = kInfinity;
  for (const SizeRule& rule : options.sizes) {
    if (!rule.expression.empty()) return;
    smallest = std::min(smallest, rule.size);
  }
  for (const RegionBoundary& boundary : boundaries)
    if (boundary.size > 0) smallest = std::min(smallest, boundary.size);
  const double across = box_of(pslg.points).diagonal();
  if (options.size_field || !std::isfinite(smallest) || !(smallest > across)) return;
  notes.push_back({Note::Kind::warning,
                   kVoid,
                   fmt::format("every size that is asked for is larger than the whole drawing: the "
                               "smallest is {}, and all points are within {}",
                               describe_roughly(smallest), describe_roughly(across)),
                   {}});
}

/// Tells which expressions, and whether the caller's sizes, are a number above zero nowhere.
void warn_of_sizes_of_nothing(const Options& options, std::span<const RegionBoundary> boundaries,
                              std::vector<Note>& notes) {
  for (const std::string& expression : sizes_of_nothing(boundaries, options.min_size)) {
    notes.push_back(
        {Note::Kind::warning,
         kVoid,
         fmt::format("the size '{}' asks for nothing: it is a number above zero at no vertex of "
                     "its regions",
                     expression),
         {}});
  }
  if (options.size_field && !asks_for_something(options.size_field, boundaries))
    notes.push_back(
        {Note::Kind::warning,
         kVoid,
         fmt::format("the size field{} asks for nothing: it is a number above zero at no "
                     "vertex of the input",
                     options.size_field_name.empty()
                         ? std::string()
                         : fmt::format(" '{}'", options.size_field_name)),
         {}});
}

/// Tells where expressions change too fast. One place is enough.
void warn_of_missed_sizes(std::span<const RegionBoundary> boundaries, std::vector<Note>& notes) {
  const auto at = std::find_if(boundaries.begin(), boundaries.end(),
                               [](const RegionBoundary& b) { return b.size_missed.has_value(); });
  if (at == boundaries.end()) return;
  notes.push_back({Note::Kind::warning,
                   kVoid,
                   fmt::format("the sizes asked for by expressions change too fast to be looked "
                               "at everywhere: near {} edges may be longer than asked",
                               describe(*at->size_missed)),
                   {*at->size_missed}});
}

/// Segments longer than the sizes asked for there.
struct LongSegments {
  std::size_t count = 0;
  std::size_t longest = 0;
  std::size_t unrefined = 0;  ///< regions that have longer sides alone
};

double length_of(const Pslg& pslg, std::size_t s) {
  const Segment& segment = pslg.segments[s];
  return length(pslg.points[segment.b.index()] - pslg.points[segment.a.index()]);
}

LongSegments long_segments(const Pslg& pslg, const Options& options,
                           std::span<const RegionBoundary> boundaries) {
  LongSegments found;
  std::vector<bool> is_long(pslg.segments.size(), false);
  for (const RegionBoundary& boundary : boundaries) {
    if (!has_sizes(boundary, options)) continue;
    std::size_t long_sides = 0;
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      if (boundary.segments[s] == kHullSide) continue;
      const auto& [a, b] = boundary.sides[s];
      SegmentSizes sizes(boundary.points[a], boundary.points[b], options);
      sizes.add(boundary, s);
      if (!sizes.is_long()) continue;
      ++long_sides;
      const std::size_t segment = boundary.segments[s].index();
      is_long[segment] = true;
      if (!is_long[found.longest] || length_of(pslg, segment) > length_of(pslg, found.longest))
        found.longest = segment;
    }
    if (long_sides == boundary.sides.size()) ++found.unrefined;
  }
  found.count = static_cast<std::size_t>(std::count(is_long.begin(), is_long.end(), true));
  return found;
}

/// Tells that segments longer than the sizes beside them stay as they are.
void warn_of_long_segments(const Pslg& pslg, const LongSegments& found, bool may_be_cut,
                           std::vector<Note>& notes) {
  if (found.count == 0) return;
  const Segment& segment = pslg.segments[found.longest];
  const Point a = pslg.points[segment.a.index()], b = pslg.points[segment.b.index()];
  const std::string unrefined =
      found.unrefined == 0
          ? ""
          : fmt::format("; of {} all segments are", counted(found.unrefined, "region"));
  notes.push_back(
      {Note::Kind::warning,
       kVoid,
       fmt::format(
           "{} longer than the sizes asked for there, up to {:.6g} from {} to {}: "
           "triangles beside them are larger than asked, since segments stay {}{}",
           found.count == 1 ? "1 segment is" : fmt::format("{} segments are", found.count),
           length_of(pslg, found.longest), describe(a), describe(b),
           may_be_cut ? "whole unless --split-interfaces cuts them" : "as they are in the mesh",
           unrefined),
       {a, b}});
}

}  // namespace

void warn_of_sizes(const Pslg& pslg, const Options& options,
                   std::span<const RegionBoundary> boundaries, bool may_be_cut,
                   std::vector<Note>& notes) {
  if (options.method != Method::quality) {
    if (options.sizes.empty() && !options.size_field) return;
    notes.push_back({Note::Kind::warning,
                     kVoid,
                     fmt::format("sizes count with method quality only{}",
                                 options.split_interfaces ? ", but for cutting segments" : ""),
                     {}});
    return;
  }
  warn_of_vast_sizes(pslg, options, boundaries, notes);
  warn_of_sizes_of_nothing(options, boundaries, notes);
  warn_of_missed_sizes(boundaries, notes);
  warn_of_long_segments(pslg, long_segments(pslg, options, boundaries), may_be_cut, notes);
}

}  // namespace cover
