// Tested by tests/unit/app/check_text_test.cpp.
#include "words/check_text.hpp"

#include <algorithm>
#include <span>

#include <fmt/core.h>

#include <cover/limits.hpp>
#include <cover/periodic.hpp>
#include <cover/point.hpp>
#include <cover/report.hpp>
#include <cover/text.hpp>

#include "terminal/console.hpp"
#include "words/limits_text.hpp"

namespace cover::app {
namespace {

/// For scripts and large views: a message names the first of its places itself.
std::string places_text(std::span<const Point> places) {
  std::string text;
  for (const Point& p : places) text += fmt::format("    at ({:.17g}, {:.17g})\n", p.x, p.y);
  return text;
}

/// Of `count` violations no more need be shown.
std::string and_more(std::size_t count, std::size_t shown) {
  return count > shown ? fmt::format("... and {} more\n", grouped(count - shown)) : "";
}

/// "--weld, --overlap or --scale".
std::string any_of(std::span<const std::string> options) {
  if (options.size() < 2) return listed(options);
  return fmt::format("{} or {}", listed(options.first(options.size() - 1)), options.back());
}

std::string obtuse_triangles(const Verification& found) {
  std::string text = fmt::format("{} obtuse triangles", grouped(found.obtuse));
  if (found.obtuse_by_rounding > 0)
    text += fmt::format(", {} more by no more than rounding of coordinates",
                        grouped(found.obtuse_by_rounding));
  return text;
}

/// Which targets are those of the run that made the mesh.
const char* whose_text(const AngleTargets& targets) {
  if (targets.is_largest_of_run && targets.is_smallest_of_run)
    return ", those of the run that made it";
  if (targets.is_largest_of_run) return ", the first that of the run that made it";
  return targets.is_smallest_of_run ? ", the second that of the run that made it" : "";
}

}  // namespace

std::string violations_text(const Verification& found) {
  std::string text;
  for (const Violation& violation : found.violations) {
    const char* const what = violation.promise == 4 ? " (materials)" : "";
    text += fmt::format("FAILED promise {}{}: {}\n", violation.promise, what,
                        printable(violation.message)) +
            places_text(violation.where);
  }
  return text + and_more(found.violation_count, found.violations.size());
}

std::string sound_text(const Verification& found, std::size_t triangles, bool is_all_met,
                       const AngleTargets& targets) {
  std::string text = fmt::format("{}: {}, {}, {} whole",
                                 !is_all_met               ? "All else that was checked holds"
                                 : found.unchecked.empty() ? "Every promise holds"
                                                           : "All that was checked holds",
                                 plural(triangles, "triangle"), plural(found.regions, "region"),
                                 plural(found.segments_whole, "segment"));
  if (found.within_rounding > 0) {
    text += fmt::format("; {} of the regions meet the bound up to the rounding of coordinates",
                        grouped(found.within_rounding));
  }
  text += "\n";
  LimitCounts limits;
  for (const RegionLimits& region : found.limits) limits.add(region);
  if (const std::string counts = limits_text(limits); !counts.empty())
    text += fmt::format(
        "Regions beside targets of {:.6g} and {:.6g} degrees{}, and beside proven limits: {}\n",
        targets.largest.in_degrees(), targets.smallest.in_degrees(), whose_text(targets), counts);
  for (const std::string& what : found.unchecked)
    text += fmt::format("Not checked: {}\n", printable(what));
  return text;
}

std::string wrong_regions_text(std::span<const WrongRegion> regions) {
  std::string text;
  for (const WrongRegion& region : regions)
    text += fmt::format("FAILED named regions: {} of '{}' {} named '{}'\n",
                        counted(region.triangles, "triangle"), printable(region.name),
                        region.triangles == 1 ? "is" : "are", printable(region.group)) +
            places_text({&region.at, 1});
  return text;
}

std::string wrong_points_text(std::span<const WrongPoint> points) {
  std::string text;
  for (const WrongPoint& point : points)
    text +=
        fmt::format("FAILED named points: '{}' {}\n", printable(point.name),
                    point.there.empty() ? std::string("has no name in the mesh")
                                        : fmt::format("is named '{}'", printable(point.there))) +
        places_text({&point.at, 1});
  return text;
}

std::string wrong_lines_text(const NamedLines& lines) {
  std::string text;
  for (const WrongLine& line : lines.wrong) {
    const std::string name = printable(line.name);
    if (line.missing > 0)
      text += fmt::format("FAILED named lines: {} of the {} of '{}' {} not there under that name\n",
                          grouped(line.missing), counted(line.edges, "edge"), name,
                          line.missing == 1 ? "is" : "are") +
              places_text(line.missing_at);
    if (line.foreign > 0)
      text += fmt::format("FAILED named lines: {} named '{}' {} not of that line\n",
                          counted(line.foreign, "edge"), name, line.foreign == 1 ? "is" : "are") +
              places_text(line.foreign_at);
  }
  return text;
}

std::string unchecked_lines_text(const NamedLines& lines) {
  std::string text;
  for (const std::string& what : lines.unchecked) text += fmt::format("Not checked: {}\n", what);
  return text;
}

std::string cuts_text(const OwnCuts& cuts, bool are_sides_images) {
  if (!cuts.are_meant) {
    const char* const all_else = cuts.are_pieces_sound ? "all else" : "all else but materials";
    const std::string what =
        cuts.are_on_arcs
            ? fmt::format("Segments are cut at {} points, those of arcs on their circles",
                          grouped(cuts.points))
            : "Segments have vertices inside";
    return fmt::format(
        "{}; {} is sound. {}f segments were to be cut, as by --split-interfaces{}, add "
        "--allow-split\n",
        what, all_else,
        are_sides_images ? "I" : "If sides were made images of each other, repeat --periodic; i",
        cuts.are_on_arcs ? "" : ", --box-method or --method nonobtuse");
  }
  return cuts.are_on_arcs
             ? fmt::format("Segments are cut at {} points, those of arcs on their circles{}{}\n",
                           grouped(cuts.points), cuts.option.empty() ? "" : ": ", cuts.option)
             : fmt::format("Segments are cut at {} by the run itself: {}\n",
                           counted(cuts.points, "point"), cuts.option);
}

std::string rounded_text(const RoundedPoints& rounded) {
  if (rounded.count == 0) return {};
  return fmt::format(
      "FAILED promise 1: {} of the input {} rounded in the mesh, by its format and not by the "
      "mesher: readers of .inp take 20 characters of a coordinate; other formats keep all digits\n"
      "    at ({:.17g}, {:.17g}), there ({:.17g}, {:.17g})\n"
      "What follows is of the mesh with the digits of the input:\n",
      counted(rounded.count, "point"), rounded.count == 1 ? "is" : "are", rounded.first.x,
      rounded.first.y, rounded.as_there.x, rounded.as_there.y);
}

std::string missing_text(std::size_t points, std::span<const std::string> of_run,
                         std::span<const std::string> possible) {
  if (points == 0) return {};
  const std::string begin =
      fmt::format("{} of the input missing in the mesh. ", counted(points, "point"));
  if (!of_run.empty()) return begin + repeat_text(of_run);
  return begin +
         fmt::format("If the run that made it moved them, or read other ones, repeat its {} here\n",
                     any_of(possible));
}

std::string repeat_text(std::span<const std::string> of_run) {
  if (of_run.empty()) return {};
  return fmt::format("The run that made it had other options: repeat {} here\n",
                     listed(of_run, " "));
}

std::string materials_text(std::span<const std::string> possible) {
  if (possible.empty()) return {};
  return fmt::format(
      "If the run that made the mesh took materials from elsewhere, repeat its {} here\n",
      any_of(possible));
}

std::string other_ids_text(std::size_t triangles) {
  if (triangles == 0) return {};
  return fmt::format(
      "{} another RegionId than the input's region has there. If the run that made the mesh joined "
      "regions of one material, or did not, repeat or leave out --merge-materials here\n",
      triangles == 1 ? "1 triangle has" : fmt::format("{} triangles have", grouped(triangles)));
}

std::string in_void_text(std::size_t triangles) {
  if (triangles == 0) return {};
  return fmt::format(
      "{} along segments in the void. If the mesh is to cover the convex hull, add --hull\n",
      triangles == 1 ? "1 triangle lies" : fmt::format("{} triangles lie", grouped(triangles)));
}

std::string couplings_text(const Verification& found) {
  constexpr std::size_t kListed = 20;
  using Kind = NegativeCoupling::Kind;
  const auto& all = found.negative_couplings;
  const auto count = [&](Kind kind) {
    return grouped(static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [&](const NegativeCoupling& c) { return c.kind == kind; })));
  };
  if (all.empty())
    return fmt::format("Box method: no negative coupling; {}\n", obtuse_triangles(found));
  std::string text = fmt::format(
      "FAILED box method: {} negative couplings: {} on inner edges, {} on sides that a "
      "vertex of the boundary encroaches, {}{} on other sides\n",
      grouped(all.size()), count(Kind::inside), count(Kind::encroached),
      count(Kind::forced) == "0"
          ? ""
          : fmt::format("{} that the bound on angles forces, ", count(Kind::forced)),
      count(Kind::given_up));
  text += fmt::format("    {}\n", obtuse_triangles(found));
  for (std::size_t k = 0; k < std::min(kListed, all.size()); ++k) {
    const NegativeCoupling& c = all[k];
    text +=
        fmt::format("    region {}: {} from {} to {}, {} {}\n", c.region.value(),
                    c.kind == Kind::inside ? "inner edge" : "side", describe(c.a), describe(c.b),
                    c.kind == Kind::encroached ? "encroached by" : "seen from", describe(c.apex));
  }
  if (all.size() > kListed)
    text += fmt::format("    ... and {} more\n", grouped(all.size() - kListed));
  return text;
}

std::string curved_violations_text(const CurvedVerification& found) {
  std::string text;
  for (const Violation& violation : found.violations)
    text +=
        fmt::format("FAILED second order: {}\n", violation.message) + places_text(violation.where);
  return text + and_more(found.violation_count, found.violations.size());
}

std::string curved_sound_text(const CurvedVerification& found) {
  return fmt::format(
      "Second order: every Jacobian is positive everywhere; {} edges lie on arcs{}\n",
      grouped(found.on_arcs),
      found.straight == 0 ? "" : fmt::format(", {} of arcs are straight", grouped(found.straight)));
}

std::string periodic_text(const PeriodicRule& rule, const Result<std::size_t>& pairs) {
  if (!pairs)
    return fmt::format("FAILED {}\n", pairs.error().message) + places_text(pairs.error().where);
  return fmt::format("Periodic: {} pairs of vertices on {}, none without a partner\n",
                     grouped(*pairs), describe(rule));
}

std::string layers_text(const LayersFound& layers, const std::string& line,
                        const std::string& region, bool is_met) {
  std::string text =
      fmt::format("{}Layers along '{}' in '{}': ", is_met ? "" : "FAILED ", line, region);
  const std::string edges =
      fmt::format("{} edge{}", grouped(layers.edges), layers.edges == 1 ? "" : "s");
  if (layers.layered == 0) return text + fmt::format("none over {}\n", edges);
  return text + fmt::format(
                    "{} to {} over {} of {}; the first {:.10g} to {:.10g} thick, all {:.10g}; {} "
                    "triangles, largest angle {:.6f}, {} above 90 degrees; {}\n",
                    layers.fewest, layers.most, grouped(layers.layered), edges, layers.first_least,
                    layers.first_most, layers.thickness, grouped(layers.triangles),
                    layers.largest.in_degrees(), grouped(layers.above_90),
                    counted(layers.negative, "negative coupling"));
}

}  // namespace cover::app
