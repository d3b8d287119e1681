// Every promise as a look-up in sorted arrays. The chain of reasoning:
//
//   - all triangles are counter-clockwise, exactly, so they cover a point as often as the sum of
//     their directed edges winds around it;
//   - edges that are no part of a segment cancel: each has its reverse;
//   - so what is left of the edges of one region's triangles are pieces of segments with that
//     region on their left. Every such side is there, once: the sum is the region's boundary,
//     which winds once around its inside and not at all around the rest.
//
// Thus the triangles of a region cover it without gaps or overlap, and no tolerance was used.
// What is broken is listed by kind.
// Tested by tests/unit/verify/verify_test.cpp, which damages good meshes in every way it can think
// of.
#include <cover/text.hpp>
#include <cover/verify.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>

#include "base/numbers_where.hpp"
#include "base/run_all.hpp"
#include "geom/predicates.hpp"
#include "geom/topology/soup_edges.hpp"
#include "geom/vector.hpp"
#include "verify/expected_domain.hpp"
#include "verify/promises/verify_bound.hpp"
#include "verify/promises/verify_boxes.hpp"
#include "verify/promises/verify_labels.hpp"
#include "verify/promises/verify_limits.hpp"
#include "verify/verify_by_team.hpp"
#include "verify/verify_regions.hpp"

namespace cover {
namespace {

constexpr std::size_t kMostOfAKind = 10;  // are listed

class Verifier {
 public:
  Verifier(const Pslg& pslg, const RegionTable& table, const TriangleSoup& mesh,
           const VerifyOptions& options, const Team& team)
      : pslg_(pslg),
        table_(table),
        mesh_(mesh),
        options_(options),
        team_(team),
        edges_(mesh, team) {
    for (const Point& p : pslg.points) scale_ = std::max({scale_, std::abs(p.x), std::abs(p.y)});
  }

  Verification run() {
    domain_ = expected_domain(pslg_, table_, options_.hull, team_);
    if (!domain_.conflicts.empty()) {
      add(Kind::input, 1, "the input is no clean planar straight-line graph", {});
      return std::move(result_);
    }
    check_triangles();
    check_points();
    check_sides();
    check_inner_edges();
    find_regions();
    check_region_ids();
    if (options_.allow_split)
      result_.unchecked.emplace_back("that segments are one edge each (promise 1)");
    if (options_.bound && !options_.allow_split)
      check_bound();
    else
      result_.unchecked.emplace_back("the bound on the largest angle (promise 3)");
    if (options_.materials)
      check_materials();
    else
      result_.unchecked.emplace_back("materials");
    if (options_.box_method) check_couplings();
    if (result_.violation_count == 0 && !options_.allow_split && !options_.hull)
      result_.limits = verify_limits(mesh_, region_, domain_,
                                     {options_.max_angle.supplement(), options_.min_angle}, team_);
    result_.triangle_regions = std::move(region_);
    return std::move(result_);
  }

 private:
  enum class Kind {
    input,
    unusable,
    orientation,
    doubled,
    overlap,
    point,
    segment,
    in_void,
    open_edge,
    no_region,
    two_regions,
    region_id,
    material,
    bound,
  };

  void add(Kind kind, int promise, std::string message, std::vector<Point> where) {
    ++result_.violation_count;
    if (++listed_[kind] <= kMostOfAKind) {
      result_.violations.push_back({promise, std::move(message), std::move(where)});
    }
  }

  // Places, for violations to show.
  [[nodiscard]] Point at(std::uint32_t vertex) const { return mesh_.points[vertex]; }
  [[nodiscard]] std::array<Point, 3> corners(std::uint32_t triangle) const {
    const auto& t = mesh_.triangles[triangle];
    return {at(t[0]), at(t[1]), at(t[2])};
  }
  [[nodiscard]] std::string input_point(std::uint32_t v) const {
    const long id = pslg_.point_ids.empty() ? static_cast<long>(v) : pslg_.point_ids[v];
    const std::string where = describe(pslg_.points[v]);
    return id < 0 ? "the point at " + where : fmt::format("point {} at {}", id, where);
  }
  [[nodiscard]] std::string edge_text(const SoupEdges::Edge& e) const {
    return fmt::format("edge {}-{} from {} to {}", e.from, e.to, describe(at(e.from)),
                       describe(at(e.to)));
  }

  void check_triangles() {
    for (const std::uint32_t k : edges_.unusable()) {
      const auto& t = mesh_.triangles[k];
      add(Kind::unusable, 2,
          fmt::format("triangle {} has the corners {}, {}, {}: one of them does not exist, is not "
                      "finite or occurs twice",
                      k, t[0], t[1], t[2]),
          {});
    }
    const auto all = edges_.all();
    const auto sign_of = [this](const SoupEdges::Edge& e) {
      const auto [a, b, c] = corners(e.triangle);
      return orientation(a, b, c);
    };
    const auto is_turned = [&](std::uint32_t k) {
      return all[k].from == mesh_.triangles[all[k].triangle][0] &&  // once per triangle
             sign_of(all[k]) != Sign::positive;
    };
    for (const std::uint32_t k : numbers_where(all.size(), is_turned, team_)) {
      const SoupEdges::Edge& e = all[k];
      const auto [a, b, c] = corners(e.triangle);
      add(Kind::orientation, 2,
          fmt::format("triangle {} with corners {}, {}, {} is {}", e.triangle, describe(a),
                      describe(b), describe(c), sign_of(e) == Sign::zero ? "flat" : "clockwise"),
          {a, b, c});
    }
    for (const auto& [v, w] : edges_.doubles(team_)) {
      add(Kind::doubled, 2, fmt::format("vertices {} and {} are both at {}", v, w, describe(at(v))),
          {at(v)});
    }
    const auto is_second = [&](std::uint32_t k) {
      return k > 0 && all[k - 1].from == all[k].from && all[k - 1].to == all[k].to;
    };
    for (const std::uint32_t k : numbers_where(all.size(), is_second, team_)) {
      add(Kind::overlap, 2,
          fmt::format("triangles {} and {} overlap: both have the {}", all[k - 1].triangle,
                      all[k].triangle, edge_text(all[k])),
          {at(all[k].from), at(all[k].to)});
    }
  }

  void check_points() {
    vertex_.assign(pslg_.points.size(), std::nullopt);
    is_input_.assign(mesh_.points.size(), false);
    team_.each_range(vertex_.size(), kItemsAtATime, [this](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        if (domain_.is_used[v] != 0) vertex_[v] = edges_.vertex_at(pslg_.points[v]);
      }
    });
    for (std::uint32_t v = 0; v < pslg_.points.size(); ++v) {
      if (domain_.is_used[v] == 0) continue;
      if (!vertex_[v]) {
        ++result_.points_missing;
        add(Kind::point, 1, input_point(v) + " is no vertex of the mesh", {pslg_.points[v]});
      } else {
        is_input_[*vertex_[v]] = true;
      }
    }
  }

  void check_sides() {
    side_of_.assign(edges_.all().size(), kNone);
    edge_of_.assign(domain_.sides.size(), std::nullopt);
    team_.each_range(edge_of_.size(), kItemsAtATime, [this](std::size_t first, std::size_t last) {
      for (std::size_t s = first; s < last; ++s) {
        const auto from = vertex_[domain_.sides[s].a], to = vertex_[domain_.sides[s].b];
        if (from && to) edge_of_[s] = edges_.find(*from, *to);
      }
    });
    const std::size_t segment_sides = 2 * pslg_.segments.size();
    for (std::uint32_t s = 0; s < segment_sides; s += 2) {
      if (domain_.sides[s].region == kVoid && domain_.sides[s + 1].region == kVoid) continue;
      const bool left = check_side(s), right = check_side(s + 1);
      result_.segments_whole += left && right ? 1 : 0;
    }
    for (auto s = static_cast<std::uint32_t>(segment_sides); s < domain_.sides.size(); ++s) {
      check_side(s);
    }
  }

  /// Marks the edges along a side; true if the side is one edge, or one without a triangle in the
  /// void.
  bool check_side(std::uint32_t s) {
    const ExpectedSide& side = domain_.sides[s];
    const auto from = vertex_[side.a], to = vertex_[side.b];
    if (!from || !to) return false;  // said already
    const auto edge = edge_of_[s];
    if (side.region == kVoid) {
      if (edge && !is_cut_beside(s ^ 1)) report_in_void(side, edges_.all()[*edge]);
      return !edge;
    }
    if (edge && !(options_.allow_split && mark_pieces_beside(s, edges_.all()[*edge]))) {
      side_of_[*edge] = s;
      return true;
    }
    if (edge) return false;
    if (!((options_.allow_split || side.hull) && mark_pieces(s, *from, *to))) {
      report_broken_side(side, edges_.find(*to, *from).has_value());
    }
    return false;
  }

  void report_in_void(const ExpectedSide& side, const SoupEdges::Edge& edge) {
    ++result_.in_void;
    add(Kind::in_void, 2,
        fmt::format("triangle {} lies in the void beside the segment from {} to {}", edge.triangle,
                    input_point(side.a), input_point(side.b)),
        {pslg_.points[side.a], pslg_.points[side.b]});
  }

  void report_broken_side(const ExpectedSide& side, bool has_reverse) {
    add(Kind::segment, 1,
        fmt::format("the {} from {} to {} {} in region {}", side.hull ? "hull side" : "segment",
                    input_point(side.a), input_point(side.b),
                    has_reverse ? "has no triangle on its side" : "is no edge of the mesh",
                    side.region.value()),
        {pslg_.points[side.a], pslg_.points[side.b]});
  }

  /// Marks the edges along a split side; false if there is no way.
  bool mark_pieces(std::uint32_t s, std::uint32_t from, std::uint32_t to) {
    const ExpectedSide& side = domain_.sides[s];
    const RegionId other = side.hull ? kVoid : domain_.sides[s ^ 1].region;
    const std::vector<std::size_t> pieces =
        edges_.along(from, to, offset_on_segment(scale_), is_input_, other == kVoid,
                     SoupEdges::Banks::of(side.region, other));
    for (const std::size_t piece : pieces) side_of_[piece] = s;
    return !pieces.empty();
  }

  /// The same where an edge joins the ends of the side: a rounded cut may lie off it, and a
  /// triangle between them. Only if the mesh's own regions tell so.
  bool mark_pieces_beside(std::uint32_t s, const SoupEdges::Edge& edge) {
    const std::vector<std::size_t> pieces = pieces_beside(s, edge);
    for (const std::size_t piece : pieces) side_of_[piece] = s;
    return !pieces.empty();
  }

  [[nodiscard]] std::vector<std::size_t> pieces_beside(std::uint32_t s,
                                                       const SoupEdges::Edge& edge) const {
    const ExpectedSide& side = domain_.sides[s];
    if (side.hull) return {};
    const RegionId other = domain_.sides[s ^ 1].region;
    const SoupEdges::Banks banks = SoupEdges::Banks::of(side.region, other);
    if (edges_.lies_between(edge, banks)) return {};
    return edges_.along_between(edge.from, edge.to, offset_on_segment(scale_), is_input_,
                                other == kVoid, banks);
  }

  /// Whether side `s` is cut and its pieces lie beyond it by rounding, so that a triangle between
  /// them and the edge that joins its ends is one of its region.
  [[nodiscard]] bool is_cut_beside(std::uint32_t s) const {
    return options_.allow_split && edge_of_[s] &&
           !pieces_beside(s, edges_.all()[*edge_of_[s]]).empty();
  }

  void check_inner_edges() {
    const auto all = edges_.all();
    twins_ = edges_.twins(team_);
    const auto is_to_tell = [&](std::uint32_t k) {
      return side_of_[k] == kNone ? twins_[k] == kNone : !is_whole(all[k], k);
    };
    for (const std::uint32_t k : numbers_where(all.size(), is_to_tell, team_)) {
      if (side_of_[k] != kNone) {
        check_piece(all[k], side_of_[k], twins_[k] != kNone);
      } else {
        add(Kind::open_edge, 2,
            fmt::format(
                "the {} of triangle {} has no triangle on its other side and is no segment: a "
                "gap, an overlap or a vertex inside an edge",
                edge_text(all[k]), all[k].triangle),
            {at(all[k].from), at(all[k].to)});
      }
    }
  }

  /// Whether an edge on a side is all of it.
  [[nodiscard]] bool is_whole(const SoupEdges::Edge& e, std::uint32_t k) const {
    const ExpectedSide& side = domain_.sides[side_of_[k]];
    return e.from == vertex_[side.a] && e.to == vertex_[side.b];
  }

  /// A piece of a split side needs a triangle on its other side just where there is a region. Whole
  /// sides have been looked at.
  void check_piece(const SoupEdges::Edge& e, std::uint32_t s, bool has_reverse) {
    const ExpectedSide& side = domain_.sides[s];
    const RegionId other = side.hull ? kVoid : domain_.sides[s ^ 1].region;
    if (has_reverse == (other != kVoid)) return;
    add(has_reverse ? Kind::in_void : Kind::open_edge, 2,
        fmt::format("the {} on the segment from {} to {} {}", edge_text(e), input_point(side.a),
                    input_point(side.b),
                    has_reverse ? "has a triangle in the void beside it"
                                : "is no edge of the triangles on the other side"),
        {at(e.from), at(e.to)});
  }

  void find_regions() {
    TriangleRegions regions = regions_of_triangles(mesh_, edges_, twins_, side_of_, domain_, team_);
    for (const TwoRegions& mixed : regions.mixed) report_two_regions(mixed);
    for (const std::uint32_t triangle : regions.lost) report_no_region(triangle);
    result_.regions = regions.count;
    region_ = std::move(regions.of);
  }

  void report_two_regions(const TwoRegions& mixed) {
    const SoupEdges::Edge& e = edges_.all()[mixed.edge];
    add(Kind::two_regions, 2,
        fmt::format("triangle {} at the {} hangs together with triangles of both region {} and "
                    "region {}",
                    e.triangle, edge_text(e), mixed.one.value(), mixed.other.value()),
        {at(e.from), at(e.to)});
  }

  void report_no_region(std::uint32_t triangle) {
    const auto [a, b, c] = corners(triangle);
    add(Kind::no_region, 2,
        fmt::format(
            "triangle {} with corners {}, {}, {} hangs together with no segment of a region",
            triangle, describe(a), describe(b), describe(c)),
        {a, b, c});
  }

  void check_region_ids() {
    if (mesh_.region.empty()) return;
    if (mesh_.region.size() != mesh_.triangles.size()) {
      add(Kind::region_id, 2, "the mesh has not one RegionId per triangle", {});
      return;
    }
    verify_region_ids(mesh_, region_, [&](std::uint32_t t, std::string message) {
      const auto [a, b, c] = corners(t);
      ++result_.other_ids;
      add(Kind::region_id, 2, std::move(message), {a, b, c});
    });
  }

  void check_materials() {
    if (mesh_.material.empty()) {
      if (pslg_.seeds.empty()) return;
      if (options_.allow_split)
        result_.unchecked.emplace_back("materials, which the mesh has not");
      else
        add(Kind::material, 4, "the input has materials, but the mesh has no array of materials",
            {});
      return;
    }
    if (mesh_.material.size() != mesh_.triangles.size()) {
      add(Kind::material, 4, "the mesh has not one material per triangle", {});
      return;
    }
    if (!options_.material_numbers)
      result_.unchecked.emplace_back(
          "which material has which number, as the mesh has groups of its own instead");
    verify_materials(mesh_, region_, table_, options_.material_numbers,
                     [&](std::uint32_t t, std::string message) {
                       const auto [a, b, c] = corners(t);
                       add(Kind::material, 4, std::move(message), {a, b, c});
                     });
  }

  void check_couplings() {
    BoxCheck check = verify_boxes(mesh_, edges_, side_of_, domain_, region_, pslg_.points);
    result_.negative_couplings = std::move(check.negative);
    result_.obtuse = check.obtuse;
    result_.obtuse_by_rounding = check.obtuse_by_rounding;
  }

  /// The triangles between a side of the hull and points that could lie on it by rounding: no
  /// vertex that splits the side would be told from these. Sides come in the order of their places,
  /// since what one has found ends the search from others.
  [[nodiscard]] std::vector<std::uint32_t> flat_on_hull() const {
    const auto all = edges_.all();
    std::vector<SoupEdges::Edge> sides;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (side_of_[k] != kNone && domain_.sides[side_of_[k]].hull) sides.push_back(all[k]);
    }
    std::sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
      return std::pair(at(a.from), at(a.to)) < std::pair(at(b.from), at(b.to));
    });
    std::vector<std::uint32_t> flat;
    std::vector<bool> is_found(sides.empty() ? 0 : mesh_.triangles.size(), false);
    for (const SoupEdges::Edge& side : sides) add_flat_on(side, is_found, flat);
    std::sort(flat.begin(), flat.end());
    return flat;
  }

  void add_flat_on(const SoupEdges::Edge& side, std::vector<bool>& is_found,
                   std::vector<std::uint32_t>& flat) const {
    const Point a = at(side.from);
    const Vector along = at(side.to) - a;
    const auto is_flat = [&](std::uint32_t t) {
      const auto corners_of = corners(t);
      return std::all_of(corners_of.begin(), corners_of.end(), [&](Point p) {
        return cross(along, p - a) < offset_on_segment(scale_) * length(along);
      });
    };
    std::size_t next = flat.size();
    const auto add = [&](std::uint32_t t) {
      if (is_found[t] || !is_flat(t)) return;
      is_found[t] = true;
      flat.push_back(t);
    };
    for (add(side.triangle); next < flat.size(); ++next) {
      const auto& t = mesh_.triangles[flat[next]];
      for (const Corner i : kCorners) {
        const auto twin = edges_.find(t[i.next()], t[i]);
        if (!twin || side_of_[*twin] != kNone) continue;
        add(edges_.all()[*twin].triangle);
      }
    }
  }

  void check_bound() {
    const BoundCheck check = verify_bound(mesh_, region_, domain_, scale_, flat_on_hull(), team_);
    result_.within_rounding = check.within_rounding;
    for (const BoundMissed& missed : check.missed) {
      const auto [a, b, c] = corners(missed.triangle);
      add(Kind::bound, 3,
          fmt::format("triangle {} with corners {}, {}, {} in region {} has an angle of {:.9g} "
                      "degrees; the bound is {:.9g}",
                      missed.triangle, describe(a), describe(b), describe(c), missed.region.value(),
                      missed.nu.supplement().in_degrees(), missed.bound.supplement().in_degrees()),
          {a, b, c});
    }
  }

  const Pslg& pslg_;
  const RegionTable& table_;
  const TriangleSoup& mesh_;
  const VerifyOptions& options_;
  const Team& team_;
  SoupEdges edges_;
  double scale_ = 0;  ///< largest coordinate
  ExpectedDomain domain_;
  std::vector<std::optional<std::uint32_t>> vertex_;  ///< of the mesh, by VertexId
  std::vector<bool> is_input_;                        ///< by vertex of the mesh
  std::vector<std::optional<std::size_t>> edge_of_;   ///< by side, index into edges_.all()
  std::vector<std::uint32_t> side_of_;                ///< by edge, index into domain_.sides
  std::vector<std::uint32_t> twins_;                  ///< by edge, see SoupEdges
  std::vector<RegionId> region_;                      ///< by triangle
  std::map<Kind, std::size_t> listed_;
  Verification result_;
};

}  // namespace

Verification verify_cover(const Pslg& pslg, const RegionTable& table, const TriangleSoup& mesh,
                          const VerifyOptions& options) {
  const bool is_small = mesh.triangles.size() < 2 * kItemsAtATime;  // to be divided
  Verification found;
  with_team(is_small ? 1 : worker_count(options.threads),
            [&](const Team& team) { found = verify_by_team(pslg, table, mesh, options, team); });
  return found;
}

Verification verify_by_team(const Pslg& pslg, const RegionTable& table, const TriangleSoup& mesh,
                            const VerifyOptions& options, const Team& team) {
  return Verifier(pslg, table, mesh, options, team).run();
}

}  // namespace cover
