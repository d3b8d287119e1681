// Tested by tests/unit/layers/layer_rules_test.cpp.
#include "layers/layer_rules.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <cover/regions.hpp>
#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "base/words/meant_or_there.hpp"
#include "geom/box.hpp"
#include "geom/ulp.hpp"
#include "region/lines_between.hpp"

namespace cover {
namespace {

constexpr double kLeastThickness = 32;  ///< spacings of coordinates

Error bad_layers(const LayerRule& rule, const std::string& what, std::vector<Point> where = {}) {
  return {ErrorCode::bad_option,
          fmt::format("layers for '{}{}': {}", rule.line,
                      rule.region.empty() ? "" : "@" + rule.region, what),
          std::move(where),
          {}};
}

/// For a rule of a line that has '@' in its name.
std::optional<Error> unquoted(const LayerRule& rule, const Pslg& pslg, const RegionTable& table) {
  const std::string whole = rule.line + "@" + rule.region;
  if (rule.region.empty() || named_segments(pslg, table, whole).empty()) return std::nullopt;
  return bad_layers(rule, fmt::format("region '{}' of line '{}' is meant; in quotation marks, "
                                      "\"{}\", it is the line of that name",
                                      rule.region, rule.line, whole));
}

Error no_such_line(const LayerRule& rule, const Pslg& pslg, const RegionTable& table) {
  std::vector<std::string> names;
  for (const Interface& line : table.interfaces) names.push_back(line.name);
  const std::string in_void = line_in_void(pslg, rule.line);
  if (!in_void.empty()) return bad_layers(rule, in_void);
  const std::string between = lines_between(table, rule.line);
  return bad_layers(
      rule, "there is no interface, contact, outline, inner line or boundary marker of that name" +
                (between.empty() ? meant_or_there(rule.line, names) : between));
}

/// Layers that coordinates cannot hold.
Status check_thinnest(const LayerRule& rule, const Pslg& pslg) {
  const double largest = largest_coordinate(pslg.points), spacing = spacing_at(largest);
  if (rule.first >= kLeastThickness * spacing) return ok();
  return bad_layers(rule, fmt::format("a first layer of {} is too thin: coordinates as large as {} "
                                      "are {} apart, and layers need {} times that",
                                      describe_roughly(rule.first), describe_roughly(largest),
                                      describe_roughly(spacing), kLeastThickness));
}

/// No region is thicker than its bounding box.
Status check_thickest(const LayerRule& rule, const RegionTable& table,
                      const RegionBoundary& boundary) {
  const Box box = box_of(boundary.points);
  const double width = std::min(box.width(), box.height());
  if (rule.first < width) return ok();
  return bad_layers(
      rule,
      fmt::format("the first layer, {}, is no thinner than region {} '{}', which is {} from {} to "
                  "{}",
                  describe(rule.first), boundary.id.value(), table.region(boundary.id).name,
                  describe_roughly(width), describe(box.low), describe(box.high)),
      {box.low, box.high});
}

/// Tells the sides of a rule's lines which rule they have.
class Resolver {
 public:
  Resolver(const Pslg& pslg, const RegionTable& table, std::span<RegionBoundary> boundaries)
      : pslg_(pslg), table_(table), boundaries_(boundaries) {
    rule_of_.assign(pslg.segments.size(), {0, 0});
  }

  Status add(const LayerRule& rule, std::uint32_t number) {
    std::vector<RegionId> wanted;
    if (!rule.region.empty()) {
      wanted = named_regions(table_, rule.region);
      if (auto error = wanted.empty() ? unquoted(rule, pslg_, table_) : std::nullopt)
        return *std::move(error);
      if (wanted.empty())
        return no_such_region(table_, fmt::format("layers for '{}'", rule.line), rule.region);
    }
    std::vector<RegionId> beside;
    std::vector<std::string> names;
    const auto is_wanted = [&](RegionId region) {
      if (region == kVoid) return false;
      names.push_back(table_.region(region).name);
      return wanted.empty() || std::find(wanted.begin(), wanted.end(), region) != wanted.end();
    };
    const std::vector<SegmentId> line = named_segments(pslg_, table_, rule.line);
    if (auto error = line.empty() ? unquoted(rule, pslg_, table_) : std::nullopt)
      return *std::move(error);
    if (line.empty()) return no_such_line(rule, pslg_, table_);
    for (const SegmentId s : line) {
      const SegmentSides& sides = table_.sides[s.index()];
      if (is_wanted(sides.left)) mark(s, 0, sides.left, number, beside);
      if (is_wanted(sides.right)) mark(s, 1, sides.right, number, beside);
    }
    if (beside.empty()) return not_beside(rule, std::move(names));
    for (const RegionId region : beside) {
      if (Status status = check_thickest(rule, table_, boundaries_[place_of(region)]); !status)
        return status;
    }
    return check_thinnest(rule, pslg_);
  }

  void finish() {
    for (RegionBoundary& boundary : boundaries_) {
      std::vector<std::uint32_t> rules(boundary.sides.size(), 0);
      for (std::size_t s = 0; s < rules.size(); ++s) {
        if (boundary.segments[s] == kHullSide) continue;
        const Segment& segment = pslg_.segments[boundary.segments[s].index()];
        const bool forward = segment.a == boundary.vertices[boundary.sides[s][0]];
        rules[s] = rule_of_[boundary.segments[s].index()][forward ? 0 : 1];
      }
      const bool any = std::any_of(rules.begin(), rules.end(), [](auto r) { return r != 0; });
      boundary.layers = any ? std::move(rules) : std::vector<std::uint32_t>();
    }
  }

 private:
  void mark(SegmentId s, std::size_t side, RegionId region, std::uint32_t number,
            std::vector<RegionId>& beside) {
    rule_of_[s.index()][side] = number;
    if (std::find(beside.begin(), beside.end(), region) == beside.end()) beside.push_back(region);
  }

  static Error not_beside(const LayerRule& rule, std::vector<std::string> names) {
    sort_unique(names);
    std::string all;
    for (const std::string& name : names)
      all += fmt::format("{}'{}'", all.empty() ? "" : " and ", name);
    return bad_layers(rule,
                      fmt::format("region '{}' is not beside that line, but {}", rule.region, all));
  }

  const Pslg& pslg_;
  const RegionTable& table_;
  std::span<RegionBoundary> boundaries_;
  std::vector<std::array<std::uint32_t, 2>> rule_of_;  ///< by SegmentId: left and right
};

}  // namespace

Options with_layers_of(const Input& input, const Options& options) {
  Options all = options;
  all.layers.insert(all.layers.begin(), input.layers.begin(), input.layers.end());
  return all;
}

Status resolve_layers(const Pslg& pslg, const RegionTable& table, const Options& options,
                      std::span<RegionBoundary> boundaries) {
  if (options.layers.empty()) return ok();
  Resolver resolver(pslg, table, boundaries);
  for (std::uint32_t r = 0; r < options.layers.size(); ++r) {
    if (Status status = resolver.add(options.layers[r], r + 1); !status) return status;
  }
  resolver.finish();
  return ok();
}

}  // namespace cover
