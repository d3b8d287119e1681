// What is left of the region is a region of its own, whose boundary is the front on the layers. It
// has no layer that its mesh could put a vertex on, so both meshes share the vertices and the edges
// of the front. Exact tests say whether the front bounds a region and whether the whole mesh fills
// the region; the bound is that of the whole region, and the constrained Delaunay triangulation of
// the rest often tells that no mesh of it can hold that. Inner edges with a negative coupling,
// where many rows end in one vertex, are flipped away; where that would break the bound, single
// vertices give way (mend/couplings/delaunay_within_bound), those of layers last. Where something
// fails still, the sides below the places get a third fewer rows, for couplings one less, and all
// is done again. Tested by tests/unit/layers/layered_region_test.cpp.
#include "layers/layered_region.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "base/numbers.hpp"
#include "cdt/couplings.hpp"
#include "cdt/region_cdt.hpp"
#include "geom/spatial_order.hpp"
#include "geom/vector.hpp"
#include "layers/filled_film.hpp"
#include "layers/front/layer_front.hpp"
#include "layers/front/offsets.hpp"
#include "layers/front/side_links.hpp"
#include "mend/couplings/delaunay_within_bound.hpp"
#include "region/triangulation_of.hpp"
#include "region/whole_mesh.hpp"
#include "target/angle_limit.hpp"
#include "target/report/fill_report.hpp"
#include "target/report/holds_bound.hpp"

namespace cover {
namespace {

using layers::LayerFront;
using layers::SideLayers;

constexpr int kTriesForCouplings = 8;
constexpr int kRounds = 40;  ///< in the second half of them, all layers become fewer
constexpr SegmentId kFrontSide{0xfffffffeU};  ///< of no segment, and not to be split

/// What the layers leave of a region.
struct Rest {
  RegionBoundary boundary;
  std::vector<std::uint32_t> vertices;  ///< by its points: of the region with layers
};

Point point_of(const RegionBoundary& boundary, const LayerFront& front, std::uint32_t v) {
  const std::size_t own = boundary.points.size();
  return v < own ? boundary.points[v] : front.added()[v - own];
}

/// The vertices of the front and the isolated points, ascending by coordinates.
std::vector<std::uint32_t> rest_vertices(const RegionBoundary& boundary, const LayerFront& front,
                                         const std::vector<LayerFront::Edge>& edges) {
  std::vector<bool> on_side(boundary.points.size(), false);
  std::vector<std::uint32_t> out;
  for (const auto& [a, b] : boundary.sides) on_side[a] = on_side[b] = true;
  for (std::uint32_t v = 0; v < on_side.size(); ++v) {
    if (!on_side[v]) out.push_back(v);
  }
  for (const LayerFront::Edge& edge : edges) out.push_back(edge.a), out.push_back(edge.b);
  const auto place = [&](std::uint32_t v) { return std::pair(point_of(boundary, front, v), v); };
  std::sort(out.begin(), out.end(),
            [&](std::uint32_t u, std::uint32_t v) { return place(u) < place(v); });
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// In canonical order, as all boundaries are.
Rest rest_of(const RegionBoundary& boundary, const LayerFront& front) {
  const std::vector<LayerFront::Edge> edges = front.front();
  const std::vector<std::uint32_t> ascending = rest_vertices(boundary, front, edges);
  std::vector<Point> points;
  for (const std::uint32_t v : ascending) points.push_back(point_of(boundary, front, v));
  Rest rest;
  RegionBoundary& out = rest.boundary;
  out.id = boundary.id;
  out.size = boundary.size;
  out.size_expressions = boundary.size_expressions;
  out.size_function = boundary.size_function;
  out.is_rest = true;
  std::vector<std::uint32_t> local(boundary.points.size() + front.added().size(), kNone);
  for (const std::uint32_t k : spatial_order(points)) {
    const std::uint32_t v = ascending[k];
    local[v] = static_cast<std::uint32_t>(rest.vertices.size());
    rest.vertices.push_back(v);
    out.points.push_back(points[k]);
    if (!boundary.size_at.empty())
      out.size_at.push_back(v < boundary.size_at.size() ? boundary.size_at[v] : 0);
  }
  std::vector<std::pair<IndexPair, SegmentId>> sides;
  for (const auto& [a, b, side] : edges) {
    sides.push_back({{local[a], local[b]}, side == kNone ? kFrontSide : boundary.segments[side]});
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [side, segment] : sides) {
    out.sides.push_back(side);
    out.segments.push_back(segment);
  }
  return rest;
}

/// The vertices where the front does not bound a region, or no mesh of it can hold the bound.
std::vector<std::uint32_t> hopeless_places(const RegionBoundary& rest, Angle nu_bound) {
  const CdtResult result = triangulate_domain(rest.points, rest.sides);
  if (const auto flaw = find_flaw(result, rest.points, rest.sides)) return flaw->points;
  const Triangulation& cdt = result.triangulation;
  const AngleLimit limit = angle_limit(cdt, rest.sides, rest.segments);
  std::vector<std::uint32_t> out;
  for (std::size_t s = 0; s < rest.sides.size(); ++s) {
    if (limit.side_nu[s] >= nu_bound.in_radians()) continue;
    const auto& corners = cdt.triangles[limit.at[s].triangle].v;
    out.insert(out.end(), corners.begin(), corners.end());
  }
  return out;
}

/// The layers and the mesh of the rest as one.
RegionMesh put_together(const RegionBoundary& boundary, const LayerFront& front, const Rest& rest,
                        RegionMesh mesh) {
  const auto own = static_cast<std::uint32_t>(rest.vertices.size());
  const auto first = static_cast<std::uint32_t>(boundary.points.size() + front.added().size());
  RegionMesh out;
  out.report = std::move(mesh.report);
  out.steiner = front.added();
  out.steiner.insert(out.steiner.end(), mesh.steiner.begin(), mesh.steiner.end());
  out.triangles = front.triangles();
  out.layer_triangles = out.triangles.size();
  out.layer_vertices = front.added().size();
  for (IndexTriple t : mesh.triangles) {
    for (std::uint32_t& v : t) v = v < own ? rest.vertices[v] : first + (v - own);
    out.triangles.push_back(t);
  }
  std::erase_if(out.report.notes, [](const Note& note) {
    return note.kind == Note::Kind::target_missed || note.kind == Note::Kind::bound_missed;
  });
  return out;
}

/// Flips what has a negative coupling, as far as the bound holds. Rectangles have none; where
/// layers taper off, their triangles may have large angles, and so may those of the rest beside
/// them.
void mend_couplings(const RegionBoundary& boundary, RegionMesh& mesh) {
  const std::vector<Point> points = all_points(boundary, mesh);
  make_delaunay(points, mesh.triangles, boundary.sides, [&](const IndexTriple& t) {
    return holds_bound(points, std::span(&t, 1), mesh.report.nu_bound);
  });
}

/// All edges, as LayerFront::sides_in() takes them.
std::vector<std::pair<Point, Point>> ends_of_edges(const RegionBoundary& boundary,
                                                   const RegionMesh& mesh) {
  const std::vector<Point> points = all_points(boundary, mesh);
  std::vector<std::pair<Point, Point>> edges;
  for (const IndexTriple& t : mesh.triangles) {
    for (const Corner i : kCorners) edges.push_back(std::minmax(points[t[i]], points[t[i.next()]]));
  }
  sort_unique(edges);
  return edges;
}

/// What became of the layers, by line.
std::vector<LayerReport> reports(const RegionBoundary& boundary, const Options& options,
                                 const LayerFront& front, const std::vector<SideLayers>& sides) {
  std::vector<LayerReport> out;
  std::vector<std::size_t> at(options.layers.size(), options.layers.size());
  std::vector<std::vector<LayerReport::Short>> stops;
  for (std::uint32_t s = 0; s < boundary.sides.size(); ++s) {
    if (boundary.layers[s] == 0) continue;
    const std::uint32_t rule = boundary.layers[s] - 1;
    if (at[rule] == options.layers.size()) {
      at[rule] = out.size();
      out.emplace_back();
      out.back().asked = options.layers[rule];
      out.back().fewest = std::numeric_limits<int>::max();
      stops.emplace_back(kLayerStops);
    }
    LayerReport& report = out[at[rule]];
    const auto& [rows, stop] = sides[s];
    const Point a = boundary.points[boundary.sides[s][0]];
    const Point b = boundary.points[boundary.sides[s][1]];
    ++report.segments;
    report.length += length(b - a);
    if (stop == LayerStop::corner) {  // covered all the same
      ++report.complete;
      continue;
    }
    report.fewest = std::min(report.fewest, rows);
    if (rows > report.most) {
      report.most = rows;
      report.thickness = front.thickness(s, rows);
    }
    if (stop == LayerStop::none || stop == LayerStop::isotropic) {
      ++report.complete;
      continue;
    }
    LayerReport::Short& part = stops[at[rule]][static_cast<std::size_t>(stop)];
    if (part.segments++ == 0) part.at = midpoint(a, b);
    part.why = stop;
  }
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].fewest = std::min(out[k].fewest, out[k].most);
    for (const LayerReport::Short& part : stops[k]) {
      if (part.segments > 0) out[k].cut_short.push_back(part);
    }
  }
  return out;
}

/// What there is to say where layers along a line are missing since they taper off: that walls at
/// its ends may be cut, if there are some; or at which corner it ends.
std::string about_ends(const RegionBoundary& boundary, const Options& options,
                       const LayerRule& asked) {
  const auto is_of_line = [&](std::uint32_t s) {
    if (boundary.layers[s] == 0) return false;
    const LayerRule& rule = options.layers[boundary.layers[s] - 1];
    return rule.line == asked.line && rule.region == asked.region;
  };
  const auto normal_of = [&](std::uint32_t s) {
    const auto& [a, b] = boundary.sides[s];
    return layers::unit_normal(boundary.points[a], boundary.points[b]);
  };
  const std::vector<std::uint32_t> next = layers::next_sides(boundary);
  double sharpest = 0;
  Point corner;
  for (std::uint32_t s = 0; s < next.size(); ++s) {
    const std::uint32_t n = next[s];
    if (!is_of_line(s) && !is_of_line(n)) continue;
    const double turn = layers::turning_angle(normal_of(s), normal_of(n));
    if (turn < layers::kInnerMitre) continue;
    const std::uint32_t wall = is_of_line(s) ? n : s;
    if (turn > 90 + layers::kSkew) {
      if (turn > sharpest) corner = boundary.points[boundary.sides[n][0]];
      sharpest = std::max(sharpest, turn);
    } else if (!options.split_interfaces && !options.box_method &&
               boundary.segments[wall] != kHullSide) {
      return " (--split-interfaces or --box-method cuts segments across, so that layers go on to "
             "them)";
    }
  }
  if (sharpest == 0) return "";
  return fmt::format(" towards {}, where the boundary turns inwards by {:.3g} degrees",
                     describe(corner), sharpest);
}

/// What lies straight across a region from the middle of a side.
struct Across {
  std::uint32_t side = kNone;
  double distance = kInfinity;
};

Across across_from(const RegionBoundary& boundary, std::uint32_t side) {
  const auto ends = [&](std::uint32_t s) {
    const auto& [a, b] = boundary.sides[s];
    return std::pair(boundary.points[a], boundary.points[b]);
  };
  const auto [a, b] = ends(side);
  const Point from = midpoint(a, b);
  const Vector up = layers::unit_normal(a, b);
  Across nearest;
  for (std::uint32_t s = 0; s < boundary.sides.size(); ++s) {
    const auto [p, q] = ends(s);
    const double of_p = cross(up, p - from), of_q = cross(up, q - from);
    if (s == side || (of_p > 0) == (of_q > 0)) continue;
    const double distance = dot(up, p + of_p / (of_p - of_q) * (q - p) - from);
    if (distance > 0 && distance < nearest.distance) nearest = {s, distance};
  }
  return nearest;
}

/// Where a line with layers was cut to a size and the region is thin: that the wall across wants
/// the same size, if it has none. Else both have other points, and slanted edges between them.
std::string about_wall_across(const RegionBoundary& boundary, const Options& options,
                              const LayerRule& asked, Point at) {
  const auto size = std::find_if(options.sizes.begin(), options.sizes.end(),
                                 [&](const auto& r) { return r.at && r.name == asked.line; });
  if (!options.split_interfaces || size == options.sizes.end()) return "";
  for (std::uint32_t s = 0; s < boundary.sides.size(); ++s) {
    const Point a = boundary.points[boundary.sides[s][0]],
                b = boundary.points[boundary.sides[s][1]];
    if (boundary.layers[s] == 0 || midpoint(a, b) != at) continue;
    const Across across = across_from(boundary, s);
    if (across.side == kNone || across.distance > length(b - a)) return "";
    const double wished = boundary.size_along.empty() ? 0 : boundary.size_along[across.side];
    if (wished > 0 && wished <= size->size) return "";
    const auto& [c, d] = boundary.sides[across.side];
    return fmt::format(
        " (the region is thin there: --size-at LINE={} for the line across it as well, as at {}, "
        "makes points of both alike)",
        describe(size->size), describe(midpoint(boundary.points[c], boundary.points[d])));
  }
  return "";
}

/// Behind the reason why layers along a line are fewer, first at a place.
std::string what_helps(const RegionBoundary& boundary, const Options& options,
                       const LayerRule& asked, const LayerReport::Short& part) {
  if (part.why == LayerStop::end) return about_ends(boundary, options, asked);
  if (part.why != LayerStop::couplings) return "";
  std::string wall = about_wall_across(boundary, options, asked, part.at);
  if (!wall.empty() || options.box_method) return wall;
  return " (--couplings last keeps all that the bound allows)";
}

/// What layers fell short of, but for their ends.
std::vector<Note> notes_of(const RegionBoundary& boundary, const Options& options,
                           const std::vector<LayerReport>& layers) {
  std::vector<Note> notes;
  for (const LayerReport& line : layers) {
    for (const LayerReport::Short& part : line.cut_short) {
      if (part.why == LayerStop::end && line.most > 0) continue;
      notes.push_back(
          {Note::Kind::warning,
           boundary.id,
           fmt::format("region {}: layers along '{}' are {} on {}, the first at {}: {}{}",
                       boundary.id.value(), line.asked.line, line.most == 0 ? "missing" : "fewer",
                       counted(part.segments, "segment"), describe(part.at), describe(part.why),
                       what_helps(boundary, options, line.asked, part)),
           {part.at}});
    }
  }
  return notes;
}

/// Layers that become fewer until the region is as it should be.
class LayeredRegion {
 public:
  /// `options` are for the rest; couplings of the whole are mended as hard as `couplings` says.
  LayeredRegion(const RegionBoundary& boundary, const Options& options,
                const CouplingEffort& couplings, std::stop_token stop)
      : boundary_(boundary),
        options_(options),
        couplings_(couplings),
        stop_(std::move(stop)),
        most_(boundary.sides.size(), std::numeric_limits<int>::max()),
        for_couplings_(boundary.sides.size(), false) {
    const Triangulation cdt = triangulation_of(boundary);
    limit_ = angle_limit(cdt, boundary.sides, boundary.segments);
  }

  RegionMesh run(const RegionMesher& mesh_rest) {
    std::optional<RegionMesh> best;
    for (int round = 0, tries = 0;; ++round) {
      if (round == kRounds) {
        for (std::uint32_t s = 0; s < most_.size(); ++s) lower(s, 0);
      }
      const bool everywhere = round >= kRounds / 2;
      LayerFront front(boundary_, options_.layers, most_);
      front.lay();
      if (front.triangles().empty())
        return best ? *std::move(best) : without_layers(front, mesh_rest);
      const Rest rest = rest_of(boundary_, front);
      std::vector<std::uint32_t> hopeless =
          hopeless_places(rest.boundary, Angle::radians(limit_.promised_nu()));
      if (!hopeless.empty()) {
        for (std::uint32_t& v : hopeless) v = rest.vertices[v];
        withdraw(front, everywhere ? std::vector<std::uint32_t>() : hopeless);
        continue;
      }
      RegionMesh mesh = put_together(boundary_, front, rest, mesh_rest(rest.boundary, options_));
      if (stop_.stop_requested()) return mesh;
      if (const std::vector<std::uint32_t> vertices = judge(mesh); !vertices.empty()) {
        withdraw(front, everywhere ? std::vector<std::uint32_t>() : vertices);
        continue;
      }
      mesh.report.method += " with layers";
      std::vector<SideLayers> sides = front.sides_in(ends_of_edges(boundary_, mesh));
      complete_filled_films(boundary_, options_.layers, front, mesh, sides);
      tell(front, std::move(sides), mesh.report);
      const bool again = options_.couplings != Couplings::last && tries < kTriesForCouplings &&
                         lay_fewer(front, mesh, tries++);
      if (!best || mesh.report.box.negative_inside < best->report.box.negative_inside)
        best = std::move(mesh);
      if (!again) return *std::move(best);
    }
  }

 private:
  RegionMesh without_layers(const LayerFront& front, const RegionMesher& mesh_rest) const {
    RegionMesh mesh = mesh_rest(boundary_, options_);
    if (options_.couplings != Couplings::last && !stop_.stop_requested()) {
      if (std::optional<RegionMesh> mended =
              mend_couplings_within_bound(boundary_, mesh, stop_, couplings_))
        mesh = *std::move(mended);
    }
    tell(front, front.sides(), mesh.report);
    return mesh;
  }

  void tell(const LayerFront& front, std::vector<SideLayers> sides, RegionReport& report) const {
    for (std::size_t s = 0; s < sides.size(); ++s) {
      if (sides[s].stop == LayerStop::withdrawn && for_couplings_[s])
        sides[s].stop = LayerStop::couplings;
    }
    report.layers = reports(boundary_, options_, front, sides);
    const std::vector<Note> notes = notes_of(boundary_, options_, report.layers);
    report.notes.insert(report.notes.end(), notes.begin(), notes.end());
  }

  /// Measures the mesh; returns vertices where it is not as it should be.
  std::vector<std::uint32_t> judge(RegionMesh& mesh) const {
    RegionReport& report = mesh.report;
    report.id = boundary_.id;
    set_bound(limit_, report);
    if (const auto flaw = find_flaw({all_points(boundary_, mesh), mesh.triangles, boundary_.sides,
                                     boundary_.segments, boundary_.points.size()}))
      return flaw->points.empty() ? std::vector<std::uint32_t>{0} : flaw->points;
    if (options_.couplings != Couplings::last) mend_couplings(boundary_, mesh);
    fill_report(boundary_, mesh);
    if (options_.couplings != Couplings::last) {
      if (std::optional<RegionMesh> mended =
              mend_couplings_within_bound(boundary_, mesh, stop_, couplings_))
        mesh = *std::move(mended);
    }
    std::vector<std::uint32_t> out;
    if (report.bound_held) return out;
    const std::vector<Point> points = all_points(boundary_, mesh);
    for (const IndexTriple& t : mesh.triangles) {
      if (!holds_bound(points, std::span(&t, 1), report.nu_bound))
        out.insert(out.end(), t.begin(), t.end());
    }
    return out;
  }

  /// One row less, later a third, over the sides below inner edges with a negative coupling that no
  /// flip may take away. Returns whether there are such sides.
  bool lay_fewer(const LayerFront& front, const RegionMesh& mesh, int tries) {
    if (mesh.report.box.negative_inside == 0) return false;
    const auto own = static_cast<std::uint32_t>(boundary_.points.size());
    const std::vector<Point> points = all_points(boundary_, mesh);
    std::vector<std::uint32_t> below;
    const auto add = [&](std::uint32_t v) {
      if (v >= own && v - own < front.added().size()) below.push_back(front.side_below()[v - own]);
    };
    for (const NegativeEdge& e : negative_edges(points, mesh.triangles, boundary_.sides)) {
      if (e.is_side) continue;
      for (const std::uint32_t v : {e.edge[0], e.edge[1], e.apex}) add(v);
    }
    sort_unique(below);
    bool any = false;
    for (const std::uint32_t s : below) {
      const int rows = front.sides()[s].rows;
      if (rows == 0) continue;
      couplings_took_rows_ = true;
      lower(s, 2 * tries < kTriesForCouplings ? rows - 1 : rows * 2 / 3);
      any = true;
    }
    return any;
  }

  /// Fewer rows over the sides below `vertices`; over all sides if there are none below.
  void withdraw(const LayerFront& front, const std::vector<std::uint32_t>& vertices) {
    const auto own = static_cast<std::uint32_t>(boundary_.points.size());
    bool any = false;
    const auto limit = [&](std::uint32_t s) {
      const int rows = front.sides()[s].rows;
      if (rows == 0 && most_[s] == 0) return;
      lower(s, rows * 2 / 3);
      any = true;
    };
    for (const std::uint32_t v : vertices) {
      if (v >= own && v - own < front.added().size()) limit(front.side_below()[v - own]);
    }
    if (any) return;
    for (std::uint32_t s = 0; s < most_.size(); ++s) limit(s);
  }

  /// Once couplings took rows, the bound takes others only beside what they left.
  void lower(std::uint32_t s, int rows) {
    if (most_[s] <= rows) return;
    most_[s] = rows;
    for_couplings_[s] = couplings_took_rows_;
  }

  const RegionBoundary& boundary_;
  const Options& options_;
  CouplingEffort couplings_;
  std::stop_token stop_;
  std::vector<int> most_;            ///< rows, by side
  std::vector<bool> for_couplings_;  ///< by side: why `most_` is as low
  bool couplings_took_rows_ = false;
  AngleLimit limit_;
};

}  // namespace

const char* describe(LayerStop stop) {
  switch (stop) {
    case LayerStop::none:
    case LayerStop::isotropic:
    case LayerStop::corner:
      break;
    case LayerStop::end:
      return "they taper off";
    case LayerStop::room:
      return "there is no more room";
    case LayerStop::turned:
      return "the line bends too much";
    case LayerStop::withdrawn:
      return "the bound would break";
    case LayerStop::couplings:
      return "couplings inside would be negative";
  }
  return "";
}

bool has_layers(const RegionBoundary& boundary) { return !boundary.layers.empty(); }

RegionMesh mesh_with_layers(const RegionBoundary& boundary, const Options& options,
                            const RegionMesher& mesh_rest, std::stop_token stop) {
  const CouplingEffort couplings = CouplingEffort::beside_layers(options.effort);
  RegionMesh mesh = LayeredRegion(boundary, options, couplings, stop).run(mesh_rest);
  const auto negative = [](const RegionMesh& m) { return m.report.box.negative_inside; };
  if (options.couplings == Couplings::last || negative(mesh) == 0 ||
      options.effort == Effort::fast || stop.stop_requested())
    return mesh;
  // Where many rows end in one vertex, a coarser rest may leave flips that a finer one blocks.
  Options coarser = options;
  coarser.effort = Effort::fast;
  RegionMesh other = LayeredRegion(boundary, coarser, couplings, std::move(stop)).run(mesh_rest);
  return negative(other) < negative(mesh) ? std::move(other) : std::move(mesh);
}

}  // namespace cover
