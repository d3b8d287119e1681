// Tested by tests/unit/io/read_mesh/formats/msh_periodic_test.cpp.
#include "io/read_mesh/formats/msh_periodic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "base/containers/order.hpp"
#include "base/numbers.hpp"
#include "geom/box.hpp"
#include "geom/isometry.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "io/text/text.hpp"
#include "io/text/token_reader.hpp"

namespace cover {
namespace {

constexpr double kRounding = 0x1p-30;          ///< as periodic sides of inputs are matched
constexpr double kRoundingOfDigits = 0x1p-49;  ///< of the largest coordinate

/// A curve that is the image of another one.
struct CurveLink {
  long image = 0;
  long original = 0;
  std::array<double, 16> map{};
  std::map<std::uint32_t, std::uint32_t> original_of;  ///< by node
};

/// What stands between $Periodic and its end; nothing where that is binary.
std::optional<std::string_view> section_of(std::string_view text) {
  constexpr std::string_view kBegin = "\n$Periodic", kEnd = "$EndPeriodic";
  const std::string source;
  TokenReader head(text, source);
  head.expect("$MeshFormat");
  head.real("the version of the format");
  if (head.integer("the file type") != 0 || head.failed()) return std::nullopt;
  const std::size_t begin = text.find(kBegin);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::string_view rest = text.substr(begin + kBegin.size());
  return rest.substr(0, rest.find(kEnd));
}

/// False where a map is no isometry of the plane up to rounding. One that turns by no more than
/// that is made a translation: its centre would be rounding alone.
bool settle_isometry(std::array<double, 16>& m) {
  double &xx = m[0], &xy = m[1], &yx = m[4], &yy = m[5];
  const auto is_small = [](double x) { return std::abs(x) <= kRounding; };  // NaN is not
  if (!is_small(xx * xx + yx * yx - 1) || !is_small(xy * xy + yy * yy - 1) ||
      !is_small(xx * xy + yx * yy))
    return false;
  if (is_small(xx - 1) && is_small(xy) && is_small(yx) && is_small(yy - 1)) {
    xx = yy = 1;
    xy = yx = 0;
  }
  return std::all_of(m.begin(), m.end(), [](double x) { return std::isfinite(x); });
}

/// The links between curves; nothing where one cannot be understood.
std::optional<std::vector<CurveLink>> links_in(std::string_view section, const MshFile& file) {
  std::unordered_map<long, std::uint32_t> index;
  for (std::size_t p = 0; p < file.point_ids.size(); ++p)
    index.emplace(file.point_ids[p], static_cast<std::uint32_t>(p));
  const std::string source;
  TokenReader tokens(section, source);
  std::vector<CurveLink> links;
  const std::size_t n = tokens.count("links");
  for (std::size_t k = 0; k < n && !tokens.failed(); ++k) {
    const long dimension = tokens.integer("a dimension");
    CurveLink link;
    link.image = tokens.integer("a curve");
    link.original = tokens.integer("a curve");
    // Version 2 has a word there, version 4 the count of the numbers.
    const std::string_view map = tokens.word();
    if (dimension > 1 || (dimension == 1 && map != "Affine" && map != "16")) return std::nullopt;
    std::size_t nodes = 0;
    if (map == "Affine" || map == "16") {
      for (double& number : link.map) number = tokens.real("a number of a map");
      nodes = tokens.count("nodes");
    } else if (file.has_entities) {
      nodes = static_cast<std::size_t>(std::max(parse_integer(map).value_or(0), 0L));
    } else {
      nodes = tokens.count("nodes");  // behind a map of no numbers
    }
    for (std::size_t i = 0; i < nodes && !tokens.failed(); ++i) {
      const auto image = index.find(tokens.integer("a node"));
      const auto original = index.find(tokens.integer("a node"));
      if (image == index.end() || original == index.end()) return std::nullopt;
      const auto [at, is_new] = link.original_of.emplace(image->second, original->second);
      if (!is_new && at->second != original->second) return std::nullopt;
    }
    if (dimension != 1) continue;
    if (!settle_isometry(link.map)) return std::nullopt;
    links.push_back(std::move(link));
  }
  if (tokens.failed()) return std::nullopt;
  return links;
}

Isometry isometry_of(const std::array<double, 16>& m) {
  return {{m[0], 0}, {m[1], 0}, {m[4], 0}, {m[5], 0}, {m[3], 0}, {m[7], 0}};
}

/// REQUIRES: the map is a settled isometry
PeriodicRule rule_of(std::string from, std::string to, const std::array<double, 16>& m,
                     double tolerance) {
  PeriodicRule rule{std::move(from), std::move(to), PeriodicRule::Map::translation, {}, {}};
  const double xx = m[0], xy = m[1], yx = m[4], yy = m[5];
  if (xx == 1 && xy == 0 && yx == 0 && yy == 1) return rule;
  if (xx * yy - xy * yx < 0) {
    // Twice the shift along the axis.
    const double along_x = m[3] + xx * m[3] + xy * m[7], along_y = m[7] + yx * m[3] + yy * m[7];
    rule.map = std::hypot(along_x, along_y) > 2 * tolerance ? PeriodicRule::Map::glide
                                                            : PeriodicRule::Map::mirror;
    return rule;
  }
  rule.map = PeriodicRule::Map::rotation;
  rule.angle = Angle::radians(std::atan2(yx, xx));
  // The place that stays.
  const double determinant = (1 - xx) * (1 - yy) - xy * yx;
  rule.centre = {((1 - yy) * m[3] + xy * m[7]) / determinant,
                 (yx * m[3] + (1 - xx) * m[7]) / determinant};
  return rule;
}

class MshPairs {
 public:
  explicit MshPairs(const MshFile& file) : file_(file) {
    for (std::size_t e = 0; e < file.elements.size(); ++e)
      if (file.elements[e].dimension == 1) lines_[file.elements[e].entity].push_back(e);
    tolerance_ = kRounding * box_of(file.points).extent() +
                 kRoundingOfDigits * largest_coordinate(file.points);
  }

  /// False where the image of a line is none, or the line itself, or where the map does not take
  /// the originals to their images.
  bool add(const CurveLink& link) {
    const auto images = lines_.find(link.image), originals = lines_.find(link.original);
    if (images == lines_.end() || originals == lines_.end() || images == originals) return false;
    for (const auto& [image, original] : link.original_of)
      if (!is_image(link, image, original)) return false;
    const EdgesOfCurve& known = edges_of(link.original, originals->second);
    auto& [nodes, seen] = all_[{name_of(originals->second), name_of(images->second), link.map}];
    for (const std::size_t e : images->second) {
      const auto ends = file_.nodes_of(file_.elements[e]);
      const std::uint32_t a = original_of(link, ends[0]), b = original_of(link, ends[1]);
      if (!is_image(link, ends[0], a) || !is_image(link, ends[1], b)) return false;
      // As the original runs, which its image need not.
      std::array<std::uint32_t, 4> edge{a, b, ends[0], ends[1]};
      if (!known.contains({a, b})) {
        if (!known.contains({b, a})) return false;
        edge = {b, a, ends[1], ends[0]};
      }
      if (!seen.insert(edge).second) continue;  // a link may stand there twice
      nodes.edges.push_back(edge);
      nodes.vertices.push_back({a, ends[0]});
      nodes.vertices.push_back({b, ends[1]});
    }
    return true;
  }

  /// Nothing where the centre of a rotation cannot be told.
  std::vector<PeriodicNodes> take() {
    std::vector<PeriodicNodes> all;
    for (auto& [key, pairs] : all_) {
      const auto& [from, to, map] = key;
      PeriodicNodes& nodes = pairs.nodes;
      sort_unique(nodes.vertices);
      nodes.rule = rule_of(from, to, map, tolerance_);
      if (!std::isfinite(nodes.rule.centre.x) || !std::isfinite(nodes.rule.centre.y)) return {};
      nodes.map = isometry_of(map);
      all.push_back(std::move(nodes));
    }
    return all;
  }

 private:
  using EdgesOfCurve = std::set<std::array<std::uint32_t, 2>>;
  /// The nodes of one rule, with its edges again to find them.
  struct Pairs {
    PeriodicNodes nodes;
    std::set<std::array<std::uint32_t, 4>> seen;
  };

  /// Of each curve once: one may have images by the thousands.
  const EdgesOfCurve& edges_of(long curve, const std::vector<std::size_t>& lines) {
    EdgesOfCurve& edges = edges_[curve];
    if (!edges.empty()) return edges;
    for (const std::size_t e : lines) {
      const auto ends = file_.nodes_of(file_.elements[e]);
      edges.insert({ends[0], ends[1]});
    }
    return edges;
  }

  /// A node that a rotation or a mirror keeps is its own image; no translation keeps one.
  [[nodiscard]] bool is_image(const CurveLink& link, std::uint32_t image,
                              std::uint32_t original) const {
    const std::array<double, 16>& m = link.map;
    if (image == original && m[0] == 1 && m[5] == 1) return false;
    const Point mapped = image_of(isometry_of(m), file_.points[original]);
    return length(mapped - file_.points[image]) <= tolerance_;  // NaN is not
  }

  /// A node that has no partner is its own image.
  static std::uint32_t original_of(const CurveLink& link, std::uint32_t node) {
    const auto found = link.original_of.find(node);
    return found == link.original_of.end() ? node : found->second;
  }

  [[nodiscard]] std::string name_of(const std::vector<std::size_t>& lines) const {
    const MshElement& first = file_.elements[lines.front()];
    const auto name = file_.names.find({1, first.physical});
    return name != file_.names.end() ? name->second : fmt::format("{}", first.physical);
  }

  const MshFile& file_;
  std::map<long, std::vector<std::size_t>> lines_;  ///< elements, by curve
  std::map<std::tuple<std::string, std::string, std::array<double, 16>>, Pairs> all_;
  std::map<long, EdgesOfCurve> edges_;
  double tolerance_ = 0;
};

}  // namespace

std::vector<PeriodicNodes> periodic_of_msh(std::string_view text, const MshFile& file) {
  if (!file.has_periodic_points) return {};
  const std::optional<std::string_view> section = section_of(text);
  if (!section) return {};
  const auto links = links_in(*section, file);
  if (!links) return {};
  MshPairs pairs(file);
  for (const CurveLink& link : *links)
    if (!pairs.add(link)) return {};
  return pairs.take();
}

}  // namespace cover
