// Promises 1, 2 and 4 are checked again here, by the checker that shares no code with the mesher.
// Of the bound, and of angles, is told what the run measured on its mesh; `cover check` looks anew.
// Tested by tests/unit/app/verdict_test.cpp.
#include "words/verdict.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include <cover/curved_mesh.hpp>
#include <cover/judged_angle.hpp>
#include <cover/option_ranges.hpp>
#include <cover/requirements.hpp>
#include <cover/verify.hpp>

#include "terminal/console.hpp"
#include "words/angle_text.hpp"

namespace cover::app {
namespace {

using Grade = Finding::Grade;

/// What the run aimed at, in degrees; 0: nothing.
struct Targets {
  double largest = 0;
  double smallest = 0;
};

double number_of(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

Targets targets_of(const Output& output) {
  const Options defaults;
  Targets targets{defaults.max_angle.in_degrees(), defaults.min_angle.in_degrees()};
  for (const auto& [name, value] : output.report.provenance.settings) {
    if (name == "max-angle") targets.largest = number_of(value);
    if (name == "min-angle") targets.smallest = number_of(value);
    if (name == "method" && value == "almond") return {};
    if (name == "method" && value == "nonobtuse") return {kLargestSnapped, 0};
  }
  return targets;
}

bool has_setting(const Output& output, std::string_view name) {
  const auto& settings = output.report.provenance.settings;
  return std::any_of(settings.begin(), settings.end(),
                     [&](const Provenance::Setting& s) { return s.name == name; });
}

std::string in_regions(std::size_t count, std::size_t all) {
  return all == 1 ? std::string("the region")
                  : fmt::format("{} of {} regions", grouped(count), grouped(all));
}

std::string quoted_name(const Output& output, const RegionReport& region) {
  return fmt::format("region {} '{}'", region.id.value(), output.table.region(region.id).name);
}

/// Promises 1 and 2, and materials.
Finding check_mesh(const Output& output) {
  VerifyOptions options;
  options.bound = false;  // see check_bound()
  options.hull = has_setting(output, "hull");
  const Verification found =
      verify_cover(output.pslg, output.table, triangle_soup(output.mesh), options);
  if (!found.violations.empty()) {
    return {Grade::bad, "Mesh",
            fmt::format("NOT VALID: {}{}", found.violations.front().message,
                        found.violation_count > 1
                            ? fmt::format(", and {} more", grouped(found.violation_count - 1))
                            : "")};
  }
  const std::size_t more = output.pslg.segments.size() - output.report.input_segments;
  const bool is_cut = output.report.input_segments > 0 && more > 0;
  const std::string segments =
      is_cut ? fmt::format("The {} segments are cut into {}, as was asked for; each piece",
                           grouped(found.segments_whole - more), grouped(found.segments_whole))
             : fmt::format("Each of the {} segments", grouped(found.segments_whole));
  return {
      Grade::good, "Mesh",
      fmt::format("Valid: no gap, no overlap, no hanging vertex, in exact arithmetic. {} is one "
                  "edge, each input point a vertex, bit for bit.",
                  segments)};
}

Finding check_bound(const Output& output) {
  const auto& regions = output.report.regions;
  const auto held = static_cast<std::size_t>(
      std::count_if(regions.begin(), regions.end(), [](const auto& r) { return r.bound_held; }));
  if (missed_bound(output.report)) return {Grade::bad, "Bound", describe_missed_bound(output)};
  if (held < regions.size())
    return {Grade::caution, "Bound",
            fmt::format("The proven bound on the largest angle holds in {}; the others lie below "
                        "the resolution of doubles.",
                        in_regions(held, regions.size()))};
  return {Grade::good, "Bound",
          regions.size() == 1
              ? std::string("The proven bound on the largest angle holds.")
              : fmt::format("The proven bound on the largest angle holds in all {} regions.",
                            grouped(regions.size()))};
}

/// Regions that miss the target for the largest angle.
struct Misses {
  std::size_t best = 0;    ///< no mesh is better
  std::size_t forced = 0;  ///< no mesh reaches the target, but a better one is not ruled out
  std::size_t open = 0;    ///< nor is one that reaches the target

  [[nodiscard]] std::size_t all() const { return best + forced + open; }
};

Misses misses_of(const std::vector<RegionReport>& regions, Angle wanted_nu) {
  constexpr double kSame = 0.9999;  // of 180 degrees less the angle: equal to the digits shown
  Misses misses;
  for (const RegionReport& region : regions) {
    const Angle nu = judged_nu(region.quality), lowest = region.lowest_nu();
    if (meets(nu, wanted_nu)) continue;
    const bool is_best = nu.in_radians() >= kSame * lowest.in_radians();
    ++(meets(lowest, wanted_nu) ? misses.open : is_best ? misses.best : misses.forced);
  }
  return misses;
}

/// Whose fault it is.
std::string reasons(const Misses& misses) {
  if (misses.best == misses.all()) return ", where no mesh is better";
  if (misses.forced == misses.all())
    return ", where no mesh reaches it, though a better one is not ruled out";
  if (misses.open == misses.all()) return ", where the input does not force it";
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    if (count == 0) return;
    text += fmt::format("{} in {} {}", text.empty() ? ":" : ",", grouped(count), what);
  };
  add(misses.best, "no mesh is better");
  add(misses.forced, "no mesh reaches it, though a better one is not ruled out");
  add(misses.open, "the input does not force it");
  return text;
}

Finding check_largest(const Output& output, double target) {
  const auto& regions = output.report.regions;
  const Misses misses = misses_of(regions, Angle::degrees(180 - target));
  const RegionReport* worst = &*std::min_element(
      regions.begin(), regions.end(), [](const RegionReport& a, const RegionReport& b) {
        return a.quality.largest_nu < b.quality.largest_nu;
      });
  const std::string largest = angle_text(worst->quality.largest_nu);
  if (target == 0)
    return {Grade::fact, "Largest angle",
            fmt::format("{}°, in {}. The bound was all that was asked for.", largest,
                        quoted_name(output, *worst))};
  if (misses.all() == 0)
    return {Grade::good, "Largest angle",
            fmt::format("{}°: the target of {:g}° is reached everywhere.", largest, target)};
  return {
      Grade::caution, "Largest angle",
      fmt::format(
          "{}°, in {}; no mesh with whole segments has less than {}° there. The target of {:g}° is "
          "missed in {}{}.",
          largest, quoted_name(output, *worst), angle_text(worst->lowest_nu()), target,
          in_regions(misses.all(), regions.size()), reasons(misses))};
}

Finding check_smallest(const Output& output, double target) {
  const auto& regions = output.report.regions;
  const auto below = static_cast<std::size_t>(std::count_if(
      regions.begin(), regions.end(),
      [&](const RegionReport& r) { return !meets(r.quality.smallest, Angle::degrees(target)); }));
  const std::string smallest = small_angle_text(output.report.quality.smallest) + "°";
  if (target == 0) return {Grade::fact, "Smallest angle", smallest + "; none was asked for."};
  if (below == 0)
    return {Grade::good, "Smallest angle",
            fmt::format("{}: the target of {:g}° is reached everywhere.", smallest, target)};
  return {Grade::caution, "Smallest angle",
          fmt::format(
              "{}; the target of {:g}°, which counts less than the largest angle, is missed in {}.",
              smallest, target, in_regions(below, regions.size()))};
}

Finding describe_pairs(const PeriodicNodes& nodes) {
  return {Grade::good, "Periodic",
          fmt::format("'{}' and '{}' have {} pairs of vertices, none without a partner.",
                      nodes.rule.from, nodes.rule.to, grouped(nodes.vertices.size()))};
}

/// Edges on arcs, where there are any.
std::optional<Finding> describe_arcs(const Output& output) {
  if (output.pslg.circles.empty()) return std::nullopt;
  const CurvedMesh curved = curved_mesh(output);
  if (curved.edges.empty()) return std::nullopt;
  const std::size_t straight = curved.straight_edges();
  const std::string text =
      fmt::format("{} edges have their ends on arcs; triangles of second order are valid with them",
                  grouped(curved.edges.size()));
  if (straight == 0) return Finding{Grade::good, "Arcs", text + "."};
  return Finding{Grade::caution, "Arcs",
                 fmt::format("{}, but for {} that stay straight.", text, grouped(straight))};
}

Finding check_input(const Output& output) {
  const std::size_t changes = output.report.changes.size();
  std::size_t remarks = 0;
  for (const Note& note : output.report.notes) remarks += note.kind == Note::Kind::warning ? 1 : 0;
  std::string text =
      changes == 0   ? "Meshed as it is"
      : changes == 1 ? "Changed in one place, told below"
                     : fmt::format(
                           "Changed in {} places, of which the first of each kind are told below; "
                           "all stand in the JSON report",
                           grouped(changes));
  if (remarks > 0) text += fmt::format("; {} warning{}", grouped(remarks), remarks == 1 ? "" : "s");
  return {changes + remarks == 0 ? Grade::good : Grade::caution, "Input", text + "."};
}

Finding check_box_method(const Output& output) {
  std::size_t non_delaunay = 0;
  for (const RegionReport& region : output.report.regions)
    non_delaunay += region.box.non_delaunay_edges;
  const std::size_t obtuse = output.report.quality.obtuse;
  if (obtuse + non_delaunay == 0)
    return {Grade::good, "Finite volumes", "No obtuse triangle: boxes are exact."};
  return {
      Grade::fact, "Finite volumes",
      fmt::format("{} obtuse triangles: the areas of solvers that add up unsigned boxes are off "
                  "by {}. It does not matter for finite elements.",
                  grouped(obtuse), excess_text(excess_of_unsigned_boxes(output.report)))};
}

}  // namespace

long excess_of_unsigned_boxes(const Report& report) {
  double box_area = 0, area = 0;
  for (const RegionReport& region : report.regions) {
    box_area += region.box.box_area;
    area += region.quality.area;
  }
  constexpr double kMost = 1e6;  // obtuse triangles may have boxes without bounds
  return area > 0 ? std::lround(std::min(1e3 * (box_area - area) / area, kMost)) : 0;
}

std::string excess_text(long tenths) {
  return tenths <= 1000 ? fmt::format("{:.1f} %", static_cast<double>(tenths) / 10)
                        : "more than 100 %";
}

std::vector<Finding> findings_of(const Output& output) {
  std::vector<Finding> findings{check_mesh(output), check_bound(output)};
  if (!output.report.regions.empty()) {
    const Targets targets = targets_of(output);
    findings.push_back(check_largest(output, targets.largest));
    findings.push_back(check_smallest(output, targets.smallest));
  }
  for (const PeriodicNodes& nodes : output.periodic) findings.push_back(describe_pairs(nodes));
  if (const auto arcs = describe_arcs(output)) findings.push_back(*arcs);
  findings.push_back(check_input(output));
  findings.push_back(check_box_method(output));
  return findings;
}

Finding::Grade verdict_of(const std::vector<Finding>& findings) {
  const auto has = [&](Grade grade) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const Finding& finding) { return finding.grade == grade; });
  };
  return has(Grade::bad) ? Grade::bad : has(Grade::caution) ? Grade::caution : Grade::good;
}

}  // namespace cover::app
