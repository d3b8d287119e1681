// Bowyer's and Watson's way to add a vertex, with pieces of lines as walls; ears to take one away.
// Everything that is written is remembered, triangle by triangle.
// Tested by tests/unit/mend/mesh_with_undo_test.cpp.
#include "mend/mesh_with_undo.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/containers/order.hpp"
#include "base/numbers.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/foot.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kCannotBe = kInfinity;
constexpr std::uint32_t kOnNoLine = JoinedMesh::kInside;
constexpr std::size_t kMostInHole = 96;   ///< triangles: larger ones are left alone
constexpr std::size_t kMostCorners = 40;  ///< of a hole that a vertex leaves
constexpr std::uint32_t kMostSteps = 64;  ///< of a walk
constexpr double kFilter = 1e-12;  ///< of the largest product: below, signs are looked at exactly
/// More than angle_rounding() of a triangle by its largest coordinate over its shortest edge.
constexpr double kMostRounding = 5 * std::numeric_limits<double>::epsilon();
constexpr float kBadBySign = 0.25;  ///< cost of a triangle whose coupling has the wrong sign
constexpr float kBeyondWorst = 16;  ///< more than all else that a triangle costs
constexpr double kFlat = std::numbers::sqrt3;  ///< cotangent of 30 degrees: above 150
constexpr double kBadAtLeast = 0.4;            ///< cost of a triangle that is hardly bad
constexpr double kFreeAtMost = 4;  ///< times the triangles: entries of the list of free ones

/// Whether an angle is obtuse by so much that neither its sign nor its rounding matters: for most,
/// that spares three roots and an exact product.
bool is_clearly_blunt(const std::array<Point, 3>& p, double blunt, double sharp,
                      double doubled_area) {
  if (!(-blunt > kFilter * sharp)) return false;
  const double shortest = std::sqrt(std::min(
      {squared_length(p[1] - p[0]), squared_length(p[2] - p[1]), squared_length(p[0] - p[2])}));
  return -blunt * shortest > std::abs(doubled_area) * kMostRounding * largest_coordinate(p);
}

}  // namespace

MeshWithUndo::MeshWithUndo(const JoinedMesh& mesh, std::vector<WantedAngles> angles)
    : angles_(std::move(angles)), lines_(mesh.lines) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    vertices_.push_back({mesh.points[v], mesh.line[v], kNone});
  triangles_.resize(mesh.triangles.size());
  link_all(mesh);
  make_delaunay();
  for (Triangle& t : triangles_) {
    t.cost = static_cast<float>(cost_of(t));
    count(t);
  }
  keep();
}

void MeshWithUndo::link_all(const JoinedMesh& mesh) {
  const std::vector<std::uint32_t> across = opposite_half_edges(mesh.points.size(), mesh.triangles);
  const HalfEdges edges(mesh.points.size(), mesh.triangles);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    Triangle& triangle = triangles_[t];
    triangle.v = mesh.triangles[t];
    triangle.region = mesh.region[t];
    triangle.line.fill(kOnNoLine);
    for (const Corner i : kCorners) {
      const std::uint32_t twin = across[3 * t + i.next()];
      triangle.n[i] = twin == kNone ? kNone : twin / 3;
      vertices_[triangle.v[i]].home = t;
    }
  }
  for (const auto& [a, b, line] : mesh.pieces) {
    for (const std::uint32_t h : {edges.find(a, b), edges.find(b, a)}) {
      if (h != kNone) triangles_[h / 3].line[Corner(h % 3).previous()] = line;
    }
  }
}

/// Flips what is not locally Delaunay, unless that brings in a flat triangle beyond the worst: one
/// that loses a region its bound. Others are flipped for their couplings, and mended.
void MeshWithUndo::make_delaunay() {
  const auto is_flat = [&](const Triangle& t) {
    const Point a = at(t.v[0]), b = at(t.v[1]), c = at(t.v[2]);
    const double blunt = std::min({dot(b - a, c - a), dot(c - b, a - b), dot(a - c, b - c)});
    return blunt < -kFlat * std::max(cross(b - a, c - a), 0.0);
  };
  const auto beyond = [&](const Triangle& t) {
    return is_flat(t) && cost_of(t) >= kBeyondWorst ? 1 : 0;
  };
  std::vector<std::uint32_t> waiting(triangles_.size());
  for (std::uint32_t t = 0; t < waiting.size(); ++t) waiting[t] = t;
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    for (const Corner i : kCorners) {
      const std::uint32_t u = triangles_[t].n[i];
      if (u == kNone || triangles_[t].line[i] != kOnNoLine) continue;
      const Triangle s = triangles_[t], o = triangles_[u];
      const Corner j = corner_with(o.n, t);
      const std::uint32_t p = s.v[i], a = s.v[i.next()], b = s.v[i.previous()], q = o.v[j];
      if (in_circle(at(p), at(a), at(b), at(q)) != Sign::positive) continue;
      // (p, a, b) and (q, b, a) become (p, a, q) and (q, b, p).
      Triangle x{{p, a, q},
                 {o.n[j.next()], u, s.n[i.previous()]},
                 {o.line[j.next()], kOnNoLine, s.line[i.previous()]},
                 s.region,
                 0};
      Triangle y{{q, b, p},
                 {s.n[i.next()], t, o.n[j.previous()]},
                 {s.line[i.next()], kOnNoLine, o.line[j.previous()]},
                 s.region,
                 0};
      if (beyond(x) + beyond(y) > beyond(s) + beyond(o)) continue;
      triangles_[t] = x, triangles_[u] = y;
      link(x.n[0], q, a, t);
      link(y.n[0], p, b, u);
      for (const std::uint32_t v : x.v) vertices_[v].home = t;
      for (const std::uint32_t v : y.v) vertices_[v].home = u;
      waiting.push_back(t);
      waiting.push_back(u);
      break;
    }
  }
}

/// 0 for a triangle that is not bad. `is_piece`: of the edge opposite to each corner.
double MeshWithUndo::cost_of(const std::array<Point, 3>& p, const std::array<bool, 3>& is_piece,
                             std::uint32_t region) const {
  const auto& [a, b, c] = p;
  const Vector ab = b - a, bc = c - b, ca = a - c;
  const std::array<double, 3> product{-dot(ab, ca), -dot(ab, bc), -dot(bc, ca)};  // by corner
  const double doubled_area = cross(ab, bc);
  const auto [blunt, sharp] = std::minmax({product[0], product[1], product[2]});
  const WantedAngles& wanted = angles_[region];
  double cost = 0;
  if (wanted.least_cot < 0) {
    if (blunt < wanted.least_cot * doubled_area)
      cost = kBadAtLeast - blunt / std::hypot(blunt, doubled_area) +
             wanted.least_cot / std::hypot(1, wanted.least_cot);
  } else if (blunt < 0) {
    const Blunt is = is_clearly_blunt(p, blunt, sharp, doubled_area) ? Blunt::yes
                     : blunt == product[0]                           ? bluntness(c, a, b)
                     : blunt == product[1]                           ? bluntness(a, b, c)
                                                                     : bluntness(b, c, a);
    if (is == Blunt::yes) cost = kBadAtLeast - blunt / std::hypot(blunt, doubled_area);
  }
  if (cost == 0 && blunt < kFilter * sharp) {
    for (const Corner i : kCorners) {
      if (is_piece[i] && product[i] < kFilter * sharp &&
          compare_with_90_degrees(p[i.next()], p[i], p[i.previous()]) == Sign::positive)
        cost = kBadBySign;
    }
  }
  const double allowed = wanted.largest_cot * doubled_area;
  if (allowed > 0 && sharp > allowed) cost += kBadAtLeast + 1 - allowed / sharp;
  // Flat by rounding: any angle is worse than that, but where none is asked for.
  if (blunt < wanted.worst_cot * std::max(doubled_area, 0.0)) cost += kBeyondWorst;
  return cost;
}

double MeshWithUndo::cost_of(const Triangle& t) const {
  return cost_of({at(t.v[0]), at(t.v[1]), at(t.v[2])},
                 {t.line[0] != kOnNoLine, t.line[1] != kOnNoLine, t.line[2] != kOnNoLine},
                 t.region);
}

bool MeshWithUndo::is_grave(const Triangle& t) { return t.cost > kBadBySign; }

bool MeshWithUndo::is_beyond_worst(const Triangle& t) { return t.cost >= kBeyondWorst; }

void MeshWithUndo::count(const Triangle& t) {
  bad_ += t.cost > 0 ? 1 : 0;
  grave_ += is_grave(t) ? 1 : 0;
  beyond_worst_ += is_beyond_worst(t) ? 1 : 0;
  cost_ += t.cost;
}

void MeshWithUndo::discount(const Triangle& t) {
  bad_ -= t.cost > 0 ? 1 : 0;
  grave_ -= is_grave(t) ? 1 : 0;
  beyond_worst_ -= is_beyond_worst(t) ? 1 : 0;
  cost_ -= t.cost;
}

void MeshWithUndo::write(std::uint32_t t, const Triangle& value) {
  journal_.push_back({t, triangles_[t]});
  Triangle& now = triangles_[t];
  if (now.v[0] != kNone) discount(now);
  now = value;
  if (now.v[0] == kNone) return;
  now.cost = static_cast<float>(cost_of(now));
  count(now);
  for (const std::uint32_t v : now.v) vertices_[v].home = t;
}

void MeshWithUndo::save_vertex(std::uint32_t v) {
  vertex_journal_.push_back({journal_.size(), v, vertices_[v]});
}

std::uint32_t MeshWithUndo::new_triangle() {
  while (!free_.empty()) {
    const std::uint32_t t = free_.back();
    free_.pop_back();
    if (triangles_[t].v[0] == kNone) return t;
  }
  triangles_.emplace_back();
  return static_cast<std::uint32_t>(triangles_.size() - 1);
}

void MeshWithUndo::free_triangle(std::uint32_t t) {
  free_.push_back(t);
  if (static_cast<double>(free_.size()) < kFreeAtMost * static_cast<double>(triangles_.size()))
    return;
  sort_unique(free_);
  std::erase_if(free_, [&](std::uint32_t u) { return triangles_[u].v[0] != kNone; });
}

void MeshWithUndo::undo(std::size_t mark) {
  const std::size_t last = journal_.size();
  for (std::size_t k = last; k-- > mark;) {
    const auto& [t, old] = journal_[k];
    const Triangle& now = triangles_[t];
    if (now.v[0] != kNone) discount(now);
    triangles_[t] = old;
    if (old.v[0] != kNone) {
      count(old);
    } else {
      free_triangle(t);
    }
  }
  while (!vertex_journal_.empty() && vertex_journal_.back().mark >= mark) {
    vertices_[vertex_journal_.back().vertex] = vertex_journal_.back().old;
    vertex_journal_.pop_back();
  }
  for (std::size_t k = mark; k < last; ++k) {
    const std::uint32_t t = journal_[k].triangle;
    if (triangles_[t].v[0] == kNone) continue;
    for (const std::uint32_t v : triangles_[t].v) vertices_[v].home = t;
  }
  journal_.resize(mark);
  if (bad_ == 0) cost_ = 0;
}

std::vector<std::uint32_t> MeshWithUndo::written_since(std::size_t mark) const {
  std::vector<std::uint32_t> found;
  for (std::size_t k = mark; k < journal_.size(); ++k) found.push_back(journal_[k].triangle);
  return found;
}

/// Triangle `beyond` has `t` across its edge from a to b.
void MeshWithUndo::link(std::uint32_t beyond, std::uint32_t a, std::uint32_t b, std::uint32_t t) {
  if (beyond == kNone) return;
  Triangle& triangle = triangles_[beyond];
  for (const Corner i : kCorners) {
    if (triangle.v[i.next()] == a && triangle.v[i.previous()] == b) triangle.n[i] = t;
  }
}

Spot MeshWithUndo::on_line(Point p, std::uint32_t triangle, Corner edge) const {
  const Triangle& t = triangles_[triangle];
  const std::uint32_t line = t.line[edge];
  if (line >= lines_.size()) return {};
  return {nearest_on_line(lines_[line].a, lines_[line].b, p), triangle, edge};
}

Spot MeshWithUndo::locate(Point p, std::uint32_t triangle) const {
  const Triangle* const triangles = triangles_.data();
  const Vertex* const vertices = vertices_.data();
  for (std::uint32_t step = 0; step < kMostSteps; ++step) {
    const Triangle& t = triangles[triangle];
    if (t.v[0] == kNone) return {};
    std::optional<Corner> through;
    for (const Corner i : kCorners) {
      const Corner k = (i + step) % 3;
      const Point a = vertices[t.v[k.next()]].at;
      const Point b = vertices[t.v[k.previous()]].at;
      if (orientation(a, b, p) != Sign::negative) continue;
      through = k;
      if (t.line[k] == kOnNoLine) break;
    }
    if (!through) return {p, triangle};
    if (t.line[*through] != kOnNoLine) return on_line(p, triangle, *through);
    triangle = t.n[*through];
  }
  return {};
}

/// The triangles whose circles hold the spot, and their rim.
bool MeshWithUndo::gather(const Spot& spot) {
  rim_.clear();
  if (spot.triangle == kNone) return false;
  // Half of the time goes here: each access that is checked takes as long as a product.
  const Triangle* const triangles = triangles_.data();
  const Vertex* const vertices = vertices_.data();
  cavity_.begin(triangles_.size(), spot.triangle);
  std::uint32_t other = kNone;
  if (spot.edge) {
    const Corner e = *spot.edge;
    other = triangles_[spot.triangle].n[e];
    // Beyond the piece's ends nothing is cut.
    const Point from = at(triangles_[spot.triangle].v[e.next()]),
                to = at(triangles_[spot.triangle].v[e.previous()]);
    if (!(dot(spot.at - from, to - from) > 0) || !(dot(spot.at - to, from - to) > 0)) return false;
    if (other != kNone) cavity_.add(other);
  }
  const auto across = [&](std::uint32_t t, Corner i) {
    return triangles[t].line[i] == kOnNoLine ? triangles[t].n[i] : kNone;
  };
  const auto corners = [&](std::uint32_t t) {
    const auto& [a, b, c] = triangles[t].v;
    return std::array{vertices[a].at, vertices[b].at, vertices[c].at};
  };
  const auto add_to_rim = [&](std::uint32_t t, Corner i) {
    const Triangle& triangle = triangles[t];
    const std::uint32_t n = triangle.n[i];
    // The piece that is cut is no part of the rim, on either side.
    if (spot.edge && ((t == spot.triangle && i == *spot.edge) ||
                      (t == other && n == spot.triangle && triangle.line[i] != kOnNoLine)))
      return true;
    rim_.push_back(
        {triangle.v[i.next()], triangle.v[i.previous()], n, triangle.line[i], triangle.region});
    return true;
  };
  if (!cavity_.grow(spot.at, across, corners, add_to_rim, kMostInHole)) return false;
  // Not only the first one: a border of closed regions need be no piece.
  for (const std::uint32_t t : cavity_.triangles()) {
    if (angles_[triangles[t].region].closed) return false;
  }
  // A spot on a piece is rounded, and may lie beyond a vertex beside it: the hole would swallow it.
  const bool is_at_hull = spot.edge && other == kNone;
  if (rim_.size() != cavity_.size() + (is_at_hull ? 1 : 2)) return false;
  return std::all_of(rim_.begin(), rim_.end(), [&](const RimEdge& e) {
    return orientation(vertices[e.a].at, vertices[e.b].at, spot.at) == Sign::positive;
  });
}

/// Those of the piece that is cut; kNone if none is.
std::array<std::uint32_t, 2> MeshWithUndo::ends_of(const Spot& spot) const {
  if (!spot.edge) return {kNone, kNone};
  const Corner e = *spot.edge;
  const Triangle& t = triangles_[spot.triangle];
  return {t.v[e.next()], t.v[e.previous()]};
}

double MeshWithUndo::change_with(const Spot& spot, double most) {
  if (!gather(spot)) return kCannotBe;
  double change = 0;
  for (const std::uint32_t t : cavity_.triangles()) change -= triangles_[t].cost;
  const std::array<std::uint32_t, 2> ends = ends_of(spot);
  const Vertex* const vertices = vertices_.data();
  for (const RimEdge& e : rim_) {
    const bool at_b = e.b == ends[0] || e.b == ends[1], at_a = e.a == ends[0] || e.a == ends[1];
    change += cost_of({spot.at, vertices[e.a].at, vertices[e.b].at},
                      {e.line != kOnNoLine, at_b, at_a}, e.region);
    if (change > most) break;
  }
  return change;
}

std::uint32_t MeshWithUndo::insert(const Spot& spot, std::uint32_t v) {
  if (!gather(spot)) return kNone;
  const std::uint32_t line = spot.edge ? triangles_[spot.triangle].line[*spot.edge] : kOnNoLine;
  const std::array<std::uint32_t, 2> ends = ends_of(spot);
  if (v == kNone) {
    v = static_cast<std::uint32_t>(vertices_.size());
    vertices_.emplace_back();
  }
  save_vertex(v);
  vertices_[v] = {spot.at, line, kNone};
  slots_ = cavity_.triangles();
  while (slots_.size() < rim_.size()) {
    const std::uint32_t t = new_triangle();  // it may stand twice in the list of free ones
    if (std::find(slots_.begin(), slots_.end(), t) == slots_.end()) slots_.push_back(t);
  }
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const RimEdge& e = rim_[k];
    Triangle t{
        {v, e.a, e.b}, {e.beyond, kNone, kNone}, {e.line, kOnNoLine, kOnNoLine}, e.region, 0};
    for (std::size_t j = 0; j < rim_.size(); ++j) {
      if (rim_[j].a == e.b) t.n[1] = slots_[j];
      if (rim_[j].b == e.a) t.n[2] = slots_[j];
    }
    if (e.b == ends[0] || e.b == ends[1]) t.line[1] = line;
    if (e.a == ends[0] || e.a == ends[1]) t.line[2] = line;
    write(slots_[k], t);
  }
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    if (rim_[k].beyond == kNone) continue;
    journal_.push_back({rim_[k].beyond, triangles_[rim_[k].beyond]});
    link(rim_[k].beyond, rim_[k].b, rim_[k].a, slots_[k]);
  }
  return v;
}

/// The triangles around `v`, counter-clockwise, from the void on if it is there.
bool MeshWithUndo::star_of(std::uint32_t v) {
  star_.clear();
  const std::uint32_t start = vertices_[v].home;
  const auto corner = [&](std::uint32_t t) { return corner_with(triangles_[t].v, v); };
  std::uint32_t t = start;
  do {
    star_.push_back(t);
    if (star_.size() > kMostCorners) return false;
    t = triangles_[t].n[corner(t).next()];
  } while (t != start && t != kNone);
  if (t == start) {  // the same triangles come of it, whichever is the vertex's home
    std::rotate(star_.begin(), std::min_element(star_.begin(), star_.end()), star_.end());
    return true;
  }
  for (t = triangles_[start].n[corner(start).previous()]; t != kNone;
       t = triangles_[t].n[corner(t).previous()]) {
    star_.insert(star_.begin(), t);
    if (star_.size() > kMostCorners) return false;
  }
  return true;
}

/// Whether corners k, k + 1 and k + 2 can be cut off.
bool MeshWithUndo::is_ear(std::span<const HoleCorner> corners, std::size_t k, bool delaunay) const {
  const std::size_t n = corners.size();
  const Point a = at(corners[k].vertex), b = at(corners[(k + 1) % n].vertex),
              c = at(corners[(k + 2) % n].vertex);
  if (orientation(a, b, c) != Sign::positive) return false;
  for (std::size_t j = 3; j < n; ++j) {
    const Point p = at(corners[(k + j) % n].vertex);
    if (delaunay
            ? in_circle(a, b, c, p) == Sign::positive
            : orientation(a, b, p) != Sign::negative && orientation(b, c, p) != Sign::negative &&
                  orientation(c, a, p) != Sign::negative)
      return false;
  }
  return true;
}

/// Triangulates a hole with `slots`, which it uses up from the end.
bool MeshWithUndo::fill(std::span<HoleCorner> corners, std::uint32_t region,
                        std::vector<std::uint32_t>& slots) {
  while (corners.size() >= 3) {
    const std::size_t n = corners.size();
    std::size_t ear = n;
    for (const bool delaunay : {true, false}) {
      for (std::size_t k = 0; k < n && ear == n; ++k) {
        if (is_ear(corners, k, delaunay)) ear = k;
      }
    }
    if (ear == n) return false;
    const std::size_t i = ear, j = (ear + 1) % n, k = (ear + 2) % n;
    const std::uint32_t slot = slots.back();
    slots.pop_back();
    Triangle t{{corners[i].vertex, corners[j].vertex, corners[k].vertex},
               {corners[j].beyond, n == 3 ? corners[k].beyond : kNone, corners[i].beyond},
               {corners[j].line, n == 3 ? corners[k].line : kOnNoLine, corners[i].line},
               region,
               0};
    write(slot, t);
    for (const Corner e : kCorners) {
      const std::uint32_t beyond = t.n[e];
      if (beyond == kNone) continue;
      journal_.push_back({beyond, triangles_[beyond]});
      link(beyond, t.v[e.previous()], t.v[e.next()], slot);
    }
    if (n == 3) return true;
    corners[i].beyond = slot;
    corners[i].line = kOnNoLine;
    for (std::size_t m = j; m + 1 < n; ++m) corners[m] = corners[m + 1];
    corners = corners.first(n - 1);
  }
  return false;
}

/// Lets a star begin at its first piece, where the vertex cuts a line; false where other pieces end
/// at the vertex than the two of its line, or the one of them at a hull.
bool MeshWithUndo::turn_star_to_line(std::uint32_t v) {
  std::size_t first = 0, walls = 0;
  for (std::size_t k = 0; k < star_.size(); ++k) {
    const Triangle& t = triangles_[star_[k]];
    if (t.line[corner_with(t.v, v).previous()] == kOnNoLine) continue;
    if (walls == 0) first = k;
    ++walls;
  }
  const Triangle& last = triangles_[star_.back()];
  const bool is_open = last.n[corner_with(last.v, v).next()] == kNone;
  if (walls != (!cuts_line(v) ? 0U : is_open ? 1U : 2U)) return false;
  if (is_open) first = 0;
  std::rotate(star_.begin(), star_.begin() + static_cast<std::ptrdiff_t>(first), star_.end());
  return true;
}

/// The part of a star from its triangle `k` to the next piece: its triangles as slots, and its
/// corners, closed by the piece that is whole again. Returns where the next part begins.
std::size_t MeshWithUndo::take_part(std::uint32_t v, std::size_t k) {
  corners_.clear();
  slots_.clear();
  const bool is_cut = cuts_line(v);
  std::uint32_t end = kNone;
  for (bool is_done = false; k < star_.size() && !is_done; ++k) {
    const Triangle& t = triangles_[star_[k]];
    const Corner i = corner_with(t.v, v);
    corners_.push_back({t.v[i.next()], t.n[i], t.line[i]});
    slots_.push_back(star_[k]);
    end = t.v[i.previous()];
    is_done = is_cut && t.line[i.next()] != kOnNoLine;
  }
  if (is_cut) corners_.push_back({end, kNone, vertices_[v].line});
  return k;
}

/// The one of these triangles that is used and has the piece from `a` to `b` of a line, or kNone.
std::uint32_t MeshWithUndo::triangle_at_piece(std::span<const std::uint32_t> triangles,
                                              std::uint32_t a, std::uint32_t b,
                                              std::uint32_t line) const {
  std::uint32_t found = kNone;
  for (const std::uint32_t t : triangles) {
    if (std::find(slots_.begin(), slots_.end(), t) != slots_.end()) continue;
    const Triangle& triangle = triangles_[t];
    for (const Corner i : kCorners) {
      if (triangle.line[i] == line && triangle.v[i.next()] == a && triangle.v[i.previous()] == b)
        found = t;
    }
  }
  return found;
}

bool MeshWithUndo::remove(std::uint32_t v) {
  const std::size_t before = mark();
  if (!star_of(v) || !turn_star_to_line(v)) return false;
  const std::uint32_t line = vertices_[v].line;
  const bool is_cut = cuts_line(v);
  std::array<std::uint32_t, 2> closing{kNone, kNone};  // triangles at the piece that is whole again
  std::array<std::uint32_t, 2> ends{kNone, kNone};
  std::size_t part = 0;
  save_vertex(v);
  for (std::size_t k = 0; k < star_.size(); ++part) {
    const std::uint32_t region = triangles_[star_[k]].region;
    k = take_part(v, k);
    if (is_cut && part == 0) ends = {corners_.front().vertex, corners_.back().vertex};
    const std::vector<std::uint32_t> own = slots_;
    bool is_filled = part <= 1 && corners_.size() >= 3 && fill(corners_, region, slots_);
    if (is_filled && is_cut) {
      closing[part] = triangle_at_piece(own, ends[1 - part], ends[part], line);
      is_filled = closing[part] != kNone;
    }
    if (!is_filled) {
      undo(before);
      return false;
    }
    for (const std::uint32_t t : slots_) {
      write(t, Triangle{});
      free_triangle(t);
    }
  }
  if (closing[0] != kNone && closing[1] != kNone) {
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      journal_.push_back({closing[k], triangles_[closing[k]]});
      link(closing[k], ends[1 - k], ends[k], closing[1 - k]);
    }
  }
  vertices_[v].home = kNone;
  return true;
}

JoinedMesh MeshWithUndo::result(const JoinedMesh& before) const {
  JoinedMesh mesh;
  mesh.lines = before.lines;
  std::vector<std::uint32_t> number(vertices_.size(), kNone);
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    // Points that touch nothing stay.
    const bool was_there = v < before.points.size() && before.line[v] == JoinedMesh::kFixed;
    if (vertices_[v].home == kNone && !was_there) continue;
    number[v] = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(vertices_[v].at);
    mesh.line.push_back(vertices_[v].line);
  }
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) {
    const Triangle& t = triangles_[k];
    if (t.v[0] == kNone) continue;
    mesh.triangles.push_back({number[t.v[0]], number[t.v[1]], number[t.v[2]]});
    mesh.region.push_back(t.region);
    for (const Corner i : kCorners) {
      if (t.line[i] == kOnNoLine || (t.n[i] != kNone && t.n[i] < k)) continue;
      mesh.pieces.push_back({number[t.v[i.next()]], number[t.v[i.previous()]], t.line[i]});
    }
  }
  return mesh;
}

}  // namespace cover
