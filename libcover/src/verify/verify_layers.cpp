// A walk up from each edge of the line, over two triangles at a time, which know nothing of how the
// mesh was made. Tested by tests/unit/verify/verify_layers_test.cpp.
#include <cover/verify_layers.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <cover/angle.hpp>
#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/predicates.hpp"
#include "geom/topology/corner.hpp"
#include "geom/topology/soup_edges.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kSkew = 20;  ///< degrees, from parallel, upright and straight on
/// The same from upright where a rule tells how thick rows are, as in mitres of inner corners.
constexpr double kMitre = 40;
constexpr double kThickest = 3;     ///< times the row below
constexpr double kThinnest = 0.99;  ///< times the row below
constexpr double kAlike = 1e-3;     ///< of a thickness

/// A cell of a row: lower edge from a to b, upper edge from d to c.
struct Cell {
  std::uint32_t a = 0, b = 0, c = 0, d = 0;
  std::array<std::uint32_t, 2> triangles{};
  double height = 0;
};

double angle_between(Vector u, Vector v) {
  return Angle::radians(std::atan2(std::abs(cross(u, v)), dot(u, v))).in_degrees();
}

class LayerFinder {
 public:
  LayerFinder(const Pslg& pslg, const TriangleSoup& mesh) : mesh_(mesh), edges_(mesh) {
    for (const Segment& s : pslg.segments) {
      const auto a = edges_.vertex_at(pslg.points[s.a.index()]);
      const auto b = edges_.vertex_at(pslg.points[s.b.index()]);
      if (a && b) segments_.insert(std::minmax(*a, *b));
    }
  }

  /// Counts the side from p to q, which is to have no layers.
  void count(Point p, Point q, LayersFound& found) const {
    const auto a = edges_.vertex_at(p), b = edges_.vertex_at(q);
    if (a && b && edges_.find(*a, *b)) ++found.edges;
  }

  /// Adds what lies over the side from p to q, with the region on its left, if the first row is as
  /// thick as `rule` says; without a rule whatever lies there.
  void add(Point p, Point q, const LayerRule* rule, LayersFound& found) {
    const auto a = edges_.vertex_at(p), b = edges_.vertex_at(q);
    const auto edge = a && b ? edges_.find(*a, *b) : std::nullopt;
    if (!edge) return;
    ++found.edges;
    Cell cell;
    int rows = 0;
    double total = 0, growth = 0;
    for (std::optional<std::size_t> at = edge; at;) {
      const std::optional<Cell> next =
          cell_on(*at, rows == 0 ? nullptr : &cell, rule != nullptr ? kMitre : kSkew);
      if (!next) break;
      if (rows == 0) {
        if (rule != nullptr && !is_alike(next->height, rule->first)) break;
        if (rule != nullptr) growth = rule->growth;
      } else if (growth == 0) {
        growth = next->height / cell.height;
      } else if (!is_alike(next->height, growth * cell.height)) {
        break;
      }
      cell = *next;
      total += cell.height;
      if (++rows == 1) count_first(cell, found);
      for (const std::uint32_t t : cell.triangles) triangles_[found.region].insert(t);
      if (is_segment(cell.d, cell.c) || (rule != nullptr && rows == rule->count)) break;
      at = edges_.find(cell.d, cell.c);  // its triangle is the one above
    }
    if (rows == 0) return;
    found.fewest = found.layered == 0 ? rows : std::min(found.fewest, rows);
    ++found.layered;
    if (rows > found.most) {
      found.most = rows;
      found.thickness = total;
    }
  }

  /// Counts what the triangles of the rows are like.
  void finish(LayersFound& found) const {
    const auto of_region = triangles_.find(found.region);
    if (of_region == triangles_.end()) return;
    double largest = 0;
    for (const std::uint32_t t : of_region->second) {
      const auto& v = mesh_.triangles[t];
      double wide = 0;
      for (const Corner i : kCorners) {
        const Vector u = at(v[i.next()]) - at(v[i]), w = at(v[i.previous()]) - at(v[i]);
        wide = std::max(wide, std::atan2(cross(u, w), dot(u, w)));
        found.negative += is_negative(v[i], v[i.next()], v[i.previous()], of_region->second);
      }
      ++found.triangles;
      found.above_90 += bluntness_of(at(v[0]), at(v[1]), at(v[2])) == Blunt::yes ? 1 : 0;
      largest = std::max(largest, wide);
    }
    found.largest = Angle::radians(largest);
  }

 private:
  [[nodiscard]] Point at(std::uint32_t v) const { return mesh_.points[v]; }

  [[nodiscard]] bool is_segment(std::uint32_t a, std::uint32_t b) const {
    return segments_.count(std::minmax(a, b)) != 0;
  }

  static bool is_alike(double thickness, double expected) {
    return std::abs(thickness - expected) <= kAlike * expected;
  }

  /// The corner of the triangle left of an edge that is on neither end.
  [[nodiscard]] std::uint32_t apex_of(const SoupEdges::Edge& edge) const {
    for (const std::uint32_t v : mesh_.triangles[edge.triangle]) {
      if (v != edge.from && v != edge.to) return v;
    }
    return edge.from;
  }

  static void count_first(const Cell& cell, LayersFound& found) {
    if (found.layered == 0) found.first_least = kInfinity;
    found.first_least = std::min(found.first_least, cell.height);
    found.first_most = std::max(found.first_most, cell.height);
  }

  /// The cell on an edge, if there is one that leans by no more than `lean`; `below` is the one
  /// under it.
  [[nodiscard]] std::optional<Cell> cell_on(std::size_t edge, const Cell* below,
                                            double lean) const {
    const SoupEdges::Edge& base = edges_.all()[edge];
    const std::uint32_t a = base.from, b = base.to, apex = apex_of(base);
    std::optional<Cell> best;
    // The diagonal goes from a to over b, or from b to over a.
    for (const auto& [from, to] : {std::pair(apex, a), std::pair(b, apex)}) {
      if (is_segment(from, to)) continue;
      const auto twin = edges_.find(to, from);
      if (!twin) continue;
      const std::uint32_t other = apex_of(edges_.all()[*twin]);
      Cell cell{a, b, to == a ? apex : other, to == a ? other : apex, {}, 0};
      cell.triangles = {base.triangle, edges_.all()[*twin].triangle};
      if (is_cell(cell, below, lean) && (!best || skew_of(cell) < skew_of(*best))) best = cell;
    }
    return best;
  }

  /// By how many degrees the upper edge is not parallel, and the sides are not upright.
  [[nodiscard]] double tilt_of(const Cell& cell) const {
    return angle_between(at(cell.b) - at(cell.a), at(cell.c) - at(cell.d));
  }
  [[nodiscard]] double lean_of(const Cell& cell) const {
    const Vector base = at(cell.b) - at(cell.a);
    const Vector up{-base.y, base.x};
    return std::max(angle_between(up, at(cell.d) - at(cell.a)),
                    angle_between(up, at(cell.c) - at(cell.b)));
  }
  /// By how many degrees a cell is off a rectangle.
  [[nodiscard]] double skew_of(const Cell& cell) const {
    return std::max(tilt_of(cell), lean_of(cell));
  }

  [[nodiscard]] bool is_cell(Cell& cell, const Cell* below, double lean) const {
    const Vector base = at(cell.b) - at(cell.a);
    const double length_of_base = length(base);
    const auto height = [&](std::uint32_t v) {
      return cross(base, at(v) - at(cell.a)) / length_of_base;
    };
    cell.height = (height(cell.c) + height(cell.d)) / 2;
    if (!(tilt_of(cell) <= kSkew && lean_of(cell) <= lean)) return false;
    if (below == nullptr) return true;
    const auto goes_on = [&](std::uint32_t v, std::uint32_t foot, std::uint32_t root) {
      return angle_between(at(v) - at(foot), at(foot) - at(root)) <= kSkew;
    };
    return cell.height >= kThinnest * below->height && cell.height <= kThickest * below->height &&
           goes_on(cell.d, cell.a, below->a) && goes_on(cell.c, cell.b, below->b);
  }

  /// Whether an edge of a row has a negative coupling; one between two of them counts once.
  [[nodiscard]] bool is_negative(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                 const std::set<std::uint32_t>& rows) const {
    const auto twin = is_segment(a, b) ? std::nullopt : edges_.find(b, a);
    if (!twin) return compare_with_90_degrees(at(a), at(c), at(b)) == Sign::positive;
    const SoupEdges::Edge& other = edges_.all()[*twin];
    if (b < a && rows.count(other.triangle) != 0) return false;
    return in_circle(at(a), at(b), at(c), at(apex_of(other))) == Sign::positive;
  }

  const TriangleSoup& mesh_;
  SoupEdges edges_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> segments_;  ///< the lower vertex first
  std::map<RegionId, std::set<std::uint32_t>> triangles_;       ///< of rows
};

bool has_name(const Region& region, std::string_view name) {
  return region.name == name || region.material_name == name;
}

Error bad_line(std::string_view what) { return {ErrorCode::bad_option, std::string(what), {}, {}}; }

/// Whether there are rules for the line, of which none was for the region in question.
bool is_of_other_side(std::string_view line, std::span<const LayerRule> rules) {
  return std::any_of(rules.begin(), rules.end(),
                     [&](const LayerRule& r) { return r.line == line; });
}

}  // namespace

const LayerRule* layer_rule_for(const Region& region, std::string_view line,
                                std::span<const LayerRule> rules) {
  const auto rule = std::find_if(rules.rbegin(), rules.rend(), [&](const LayerRule& r) {
    return r.line == line && (r.region.empty() || has_name(region, r.region));
  });
  return rule == rules.rend() ? nullptr : &*rule;
}

Result<std::vector<LayersFound>> verify_layers(const Pslg& pslg, const RegionTable& table,
                                               const TriangleSoup& mesh, std::string_view line,
                                               std::string_view region,
                                               std::span<const LayerRule> rules) {
  std::map<RegionId, std::vector<std::pair<Point, Point>>> sides;  // of the line, by region
  for (const SegmentId s : named_segments(pslg, table, line)) {
    const Segment& segment = pslg.segments[s.index()];
    const Point a = pslg.points[segment.a.index()], b = pslg.points[segment.b.index()];
    sides[table.sides[s.index()].left].push_back({a, b});
    sides[table.sides[s.index()].right].push_back({b, a});
  }
  if (sides.empty()) {
    std::vector<std::string> names;
    for (const Interface& part : table.interfaces) names.push_back(part.name);
    return bad_line(
        fmt::format("there is no interface, contact, outline, inner line or boundary marker '{}'{}",
                    line, did_you_mean(line, names)));
  }
  std::erase_if(sides, [&](const auto& beside) {
    return beside.first == kVoid ||
           (!region.empty() && !has_name(table.region(beside.first), region));
  });
  if (sides.empty())
    return bad_line(fmt::format("no region '{}' is beside the line '{}'", region, line));
  std::vector<LayersFound> out;
  LayerFinder finder(pslg, mesh);
  for (const auto& [id, beside] : sides) {
    LayersFound layers;
    layers.region = id;
    const LayerRule* rule = layer_rule_for(table.region(id), line, rules);
    if (rule == nullptr && is_of_other_side(line, rules)) {
      for (const auto& [a, b] : beside) finder.count(a, b, layers);
    } else {
      for (const auto& [a, b] : beside) finder.add(a, b, rule, layers);
      if (rule != nullptr && layers.layered == 0) {  // none is as it says: whatever lies there
        layers = {};
        layers.region = id;
        for (const auto& [a, b] : beside) finder.add(a, b, nullptr, layers);
      }
    }
    finder.finish(layers);
    out.push_back(layers);
  }
  return out;
}

}  // namespace cover
