// See mutable_mesh.hpp. Tested by tests/unit/quality/mutable/mutable_mesh_test.cpp.
#include "quality/mutable/mutable_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/containers/give_back.hpp"
#include "base/faults/internal_fault.hpp"
#include "geom/predicates.hpp"

namespace cover {
// Triangles of a mesh name corners and neighbours of the same mesh: the innermost functions take
// them from the arrays themselves, since each access that is checked takes as long as a product.

namespace {

/// Rounding slack of an allowance: the same triangle from another corner must not count as worse.
constexpr double kSlack = 1e-12;

/// Room that is left where triangles are put in order: in the next stage parts of a region have a
/// fortieth more of them. What is not used costs nothing.
constexpr std::size_t kSpareOf = 16;

/// Takes places that are free, the last one first, and then those behind `size`, which grows.
void take_places(std::span<std::uint32_t> places, std::vector<std::uint32_t>& free,
                 std::size_t size) {
  for (std::uint32_t& place : places) {
    if (free.empty()) {
      place = static_cast<std::uint32_t>(size++);
    } else {
      place = free.back();
      free.pop_back();
    }
  }
}

/// Sets the home of a vertex to the last of its triangles, in any order; kNone comes before all.
void set_to_last(std::uint32_t& home, std::uint32_t t) {
  const std::atomic_ref last(home);
  std::uint32_t other = last.load(std::memory_order_relaxed);
  while ((other == kNone || other < t) &&
         !last.compare_exchange_weak(other, t, std::memory_order_relaxed)) {
  }
}

}  // namespace

MutableMesh::MutableMesh(const Triangulation& triangulation, std::uint32_t fixed,
                         std::span<const EdgeRef> side_at, SideLimits limits, const Team& team)
    : points(triangulation.points.begin(), triangulation.points.end()),
      triangles(triangulation.triangles.size()),
      excess(triangulation.triangles.size()),
      home(triangulation.points.size(), kNone),
      sides(std::move(limits)),
      allowances(sides.size()),
      fixed_(fixed) {
  team.each_range(triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const Triangle& from = triangulation.triangles[t];
      triangles[t] = {from.v, from.n};
      excess[t] = 0;
    }
  });
  if (team.workers() > 1) {
    team.each_range(triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
        for (const std::uint32_t v : triangles[t].v) set_to_last(home[v], t);
      }
    });
  } else {  // the same
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (const std::uint32_t v : triangles[t].v) home[v] = t;
    }
  }
  for (std::uint32_t s = 0; s < side_at.size(); ++s) {
    if (side_at[s].triangle == kNone)
      throw InternalFault("a side is no edge of the triangulation", {});
    triangles[side_at[s].triangle].n[side_at[s].edge] = kSideBit | s;
  }
  team.each_range(triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const auto t = static_cast<std::uint32_t>(k);
      for (const Corner i : kCorners) {
        if (triangles[t].n[i] == kNone)
          throw InternalFault("an edge of the triangulation has nothing on its other side",
                              {corner(t, i.next()), corner(t, i.previous())});
      }
    }
  });
}

Allowance allowance_for(const SideLimit& side, const Goal& goal) {
  Allowance allowance;
  const double forced = -side.apex_cot - goal.large;
  double small = side.slim_cot;
  if (forced > 0) {
    small = std::max(small, side.smallest_cot);
    allowance.large = forced + kSlack * std::abs(side.apex_cot);
  }
  for (const CornerLimit& corner : side.corners) {
    const bool can_cut_off = corner.ear_large <= goal.large;
    small =
        std::max(small, can_cut_off ? std::min(corner.half_cot, corner.ear_cot) : corner.half_cot);
  }
  if (small > goal.small) allowance.small = small - goal.small + kSlack * small;
  if (goal.coupling.weight > 0) {
    allowance.least_cot =
        std::min(side.least_cot + kLeastCoupling,
                 std::max(side.least_cot, side.apex_cot - kSlack * (1 + std::abs(side.apex_cot))));
    if (side.is_inner && goal.coupling.strict) {
      allowance.lowest_cot = side.least_cot - kSameCot * (1 + std::abs(side.least_cot));
    }
  }
  return allowance;
}

void MutableMesh::set_goal(const Goal& goal, const Team& team) {
  if (goal == goal_) return;
  set_goal_unmeasured(goal, team);
  measure_all(team);
}

void MutableMesh::set_goal_unmeasured(const Goal& goal, const Team& team) {
  goal_ = goal;
  allowances.assign(
      sides.size(), [&](std::size_t s) { return allowance_for(sides[s], goal); }, team);
}

bool MutableMesh::is_unforced() const {
  for (std::size_t s = 0; s < allowances.size(); ++s) {
    if (allowances[s].large > 0 || allowances[s].small > 0) return false;
  }
  return true;
}

void MutableMesh::measure_all(const Team& team) {
  team.each_range(triangles.size(), kItemsAtATime, [this](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const auto t = static_cast<std::uint32_t>(k);
      if (!is_hole(t)) measure(t);
    }
  });
}

double MutableMesh::excess_of(const std::array<std::uint32_t, 3>& v,
                              const std::array<std::uint32_t, 3>& n) const {
  const CouplingGoal& coupling = goal_.coupling;
  const bool has_sides = ((n[0] | n[1] | n[2]) & kSideBit) != 0;
  if (coupling.weight > 0 && (has_sides || coupling.inside)) return coupled_excess(v, n);
  const Point* const point = points.data();
  const Point a = point[v[0]], b = point[v[1]], c = point[v[2]];
  if (!has_sides) return cover::excess(goal_, a, b, c);
  return cover::excess(goal_, a, b, c, allowances_beside(n));
}

double MutableMesh::coupled_excess(const std::array<std::uint32_t, 3>& v,
                                   const std::array<std::uint32_t, 3>& n) const {
  const Point* const point = points.data();
  const SideAllowances allowed = allowances_beside(n);
  const bool has_sides = ((n[0] | n[1] | n[2]) & kSideBit) != 0;
  const Corners k(point[v[0]], point[v[1]], point[v[2]]);
  double worst = has_sides ? cover::excess(goal_, k, allowed) : cover::excess(goal_, k);
  if (worst == kInverted) return kInverted;
  const double inverse = 1 / k.cross;
  for (const Corner i : kCorners) {
    const double cot = k.dot[i] * inverse;
    worst = std::max(worst, kBoundFirst * (-cot - goal_.coupling.bound));
    if (allowed[i] != nullptr) {
      if (cot < allowed[i]->lowest_cot) return kInverted;
      worst = std::max(worst, goal_.coupling.weight * (allowed[i]->least_cot - cot));
      continue;
    }
    if (!goal_.coupling.inside || n[i] == kSomeTriangle) continue;
    const std::uint32_t from = v[i.previous()];
    const double sum = cot + cot_opposite(n[i], from);
    if (sum >= kLeastCoupling) continue;
    const auto& o = triangles.data()[n[i]];
    const bool given = is_given(v[0], v[1], v[2], o.v[o.edge_from(from)]);
    worst = std::max(worst, inner_excess(sum, given));
  }
  return worst;
}

double MutableMesh::cot_opposite(std::uint32_t t, std::uint32_t from) const {
  const MeshTriangle& s = triangles.data()[t];
  const Point* const point = points.data();
  const Corner i = s.edge_from(from);
  const Point p = point[s.v[i]], a = point[s.v[i.next()]], b = point[s.v[i.previous()]];
  const double ux = a.x - p.x, uy = a.y - p.y, vx = b.x - p.x, vy = b.y - p.y;
  return (ux * vx + uy * vy) / (ux * vy - uy * vx);
}

void MutableMesh::link(std::uint32_t n, std::uint32_t a, std::uint32_t b, std::uint32_t t) {
  if (is_side(n)) return;
  MeshTriangle& other = triangles.data()[n];
  for (const Corner k : kCorners) {
    if (other.v[k.next()] == b && other.v[k.previous()] == a) other.n[k] = t;
  }
}

void MutableMesh::reserve_more(std::size_t more_triangles, std::size_t more_vertices,
                               const Team& team) {
  // If there is too little, a quarter more than that: whoever needs it would move all, and room
  // that is not used costs nothing. (At borders of parts refinement adds more than a thirtieth.)
  constexpr std::size_t kLittle = 4;
  const auto reserve = [&](auto& list, std::size_t more, std::size_t free) {
    const std::size_t least = list.size() + more - std::min(more, free);
    if (list.capacity() < least)
      list = copy_of(list, team, least / kLittle * (kLittle + 1) + kLittle);
  };
  reserve(triangles, more_triangles, free_triangles_.size());
  reserve(excess, more_triangles, free_triangles_.size());
  reserve(points, more_vertices, free_vertices_.size());
  reserve(home, more_vertices, free_vertices_.size());
}

void MutableMesh::add_triangles(std::span<std::uint32_t> places) {
  const std::size_t more = places.size() - std::min(places.size(), free_triangles_.size());
  take_places(places, free_triangles_, triangles.size());
  triangles.resize(triangles.size() + more);
  excess.resize(excess.size() + more);
}

void MutableMesh::add_vertices(std::span<std::uint32_t> places) {
  const std::size_t more = places.size() - std::min(places.size(), free_vertices_.size());
  take_places(places, free_vertices_, points.size());
  points.resize(points.size() + more);
  home.resize(home.size() + more);
}

std::uint32_t MutableMesh::add_vertex(Point p) {
  if (!free_vertices_.empty()) {
    const std::uint32_t v = free_vertices_.back();
    free_vertices_.pop_back();
    points[v] = p;
    return v;
  }
  points.push_back(p);
  home.push_back(kNone);
  return static_cast<std::uint32_t>(points.size() - 1);
}

void MutableMesh::drop_vertex(std::uint32_t v) {
  home[v] = kNone;
  free_vertices_.push_back(v);
}

std::uint32_t MutableMesh::add_triangle() {
  if (!free_triangles_.empty()) {
    const std::uint32_t t = free_triangles_.back();
    free_triangles_.pop_back();
    return t;
  }
  triangles.push_back({});
  excess.push_back(0);
  return static_cast<std::uint32_t>(triangles.size() - 1);
}

void MutableMesh::drop_triangle(std::uint32_t t) {
  triangles[t].v[0] = kNone;
  excess[t] = -kInverted;
  free_triangles_.push_back(t);
}

double MutableMesh::excess_after_flip(std::uint32_t t, Corner i, double most) const {
  const MeshTriangle& s = triangles.data()[t];
  const std::uint32_t u = s.n[i];
  const MeshTriangle& o = triangles.data()[u];
  const std::uint32_t a = s.v[i], b = s.v[i.next()], c = s.v[i.previous()];
  const Corner j = o.edge_from(c);
  const std::uint32_t d = o.v[j];
  const std::uint32_t between = goal_.coupling.inside ? kSomeTriangle : t;
  double worst = excess_of({a, b, d}, {o.n[j.next()], between, s.n[i.previous()]});
  if (worst > most) return worst;
  worst = std::max(worst, excess_of({a, d, c}, {o.n[j.previous()], s.n[i.next()], between}));
  if (!goal_.coupling.inside || worst == kInverted) return worst;
  const Corners k(points[a], points[b], points[d]), l(points[a], points[d], points[c]);
  const double sum = k.dot[1] / k.cross + l.dot[2] / l.cross;
  return sum < kLeastCoupling ? std::max(worst, inner_excess(sum, is_given(a, b, c, d))) : worst;
}

bool MutableMesh::flip(std::uint32_t t, Corner i) {
  MeshTriangle& s = triangles[t];
  const std::uint32_t u = s.n[i];
  MeshTriangle& o = triangles[u];
  const std::uint32_t a = s.v[i], b = s.v[i.next()], c = s.v[i.previous()];
  const Corner j = o.edge_from(c);
  const std::uint32_t d = o.v[j];
  if (orientation(points[a], points[b], points[d]) != Sign::positive ||
      orientation(points[a], points[d], points[c]) != Sign::positive) {
    return false;
  }
  const std::uint32_t ab = s.n[i.previous()], ca = s.n[i.next()];
  const std::uint32_t bd = o.n[j.next()], dc = o.n[j.previous()];
  s = {{a, b, d}, {bd, u, ab}};
  o = {{a, d, c}, {dc, ca, t}};
  link(bd, b, d, t);
  link(ca, c, a, u);
  home[a] = home[b] = home[d] = t;
  home[c] = u;
  measure(t);
  measure(u);
  for (const std::uint32_t n : {bd, ab, dc, ca}) measure_beyond(n);
  return true;
}

namespace {

constexpr std::size_t kLevelRange = 1 << 12;  ///< triangles
constexpr std::size_t kLargeLevel = 4 * kLevelRange;
constexpr unsigned kWorkersForLevels = 4;  ///< three times the work of one

/// Numbers the triangles beside those of `order` from `first` on, which have no number, in the
/// order in which one thread would find them. Until it is known who finds a triangle first, its
/// number is a claim: the least is kept.
void visit_next_level(std::span<const MeshTriangle> triangles, std::size_t first,
                      std::vector<std::uint32_t>& order, std::span<std::uint32_t> number,
                      const Team& team) {
  constexpr std::uint32_t kClaim = 0x80000000U;  // kNone is above all claims
  const std::size_t last = order.size();
  const auto for_each = [&](const auto& use) {
    team.each_range(last - first, kLevelRange, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        for (const Corner i : kCorners) {
          const std::uint32_t n = triangles[order[first + k]].n[i];
          if (is_side(n)) continue;
          const auto claim = static_cast<std::uint32_t>(kClaim | (3 * k + i));
          use(begin / kLevelRange, n, claim, std::atomic_ref(number[n]));
        }
      }
    });
  };
  for_each([](std::size_t, std::uint32_t, std::uint32_t claim, std::atomic_ref<std::uint32_t> now) {
    std::uint32_t other = now.load(std::memory_order_relaxed);
    while (other >= kClaim && claim < other &&
           !now.compare_exchange_weak(other, claim, std::memory_order_relaxed)) {
    }
  });
  std::vector<std::size_t> next(Team::ranges(last - first, kLevelRange) + 1, 0);
  for_each([&](std::size_t range, std::uint32_t, std::uint32_t claim,
               std::atomic_ref<std::uint32_t> now) {
    if (now.load(std::memory_order_relaxed) == claim) ++next[range + 1];
  });
  next[0] = last;
  for (std::size_t k = 1; k < next.size(); ++k) next[k] += next[k - 1];
  order.resize(next.back());
  for_each([&](std::size_t range, std::uint32_t n, std::uint32_t claim,
               std::atomic_ref<std::uint32_t> now) {
    if (now.load(std::memory_order_relaxed) != claim) return;
    const std::size_t place = next[range]++;
    order[place] = n;
    now.store(static_cast<std::uint32_t>(place), std::memory_order_relaxed);
  });
}

}  // namespace

std::vector<std::uint32_t> MutableMesh::order_from_sides(UnsetVector<std::uint32_t>& number,
                                                         const Team& team) const {
  std::vector<std::uint32_t> order;
  order.reserve(triangle_count());
  number.resize(triangles.size());
  std::vector<std::uint32_t> at_side(sides.size(), kNone);
  // A side is one triangle's, so that no two threads find the same.
  team.each_range(triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      number[k] = kNone;
      const auto t = static_cast<std::uint32_t>(k);
      if (is_hole(t)) continue;
      for (const std::uint32_t n : triangles[t].n) {
        if (is_side(n)) at_side[side_index(n)] = t;
      }
    }
  });
  const auto visit = [&](std::uint32_t t) {
    if (number[t] != kNone) return;
    number[t] = static_cast<std::uint32_t>(order.size());
    order.push_back(t);
  };
  for (const std::uint32_t t : at_side) {
    if (t != kNone) visit(t);
  }
  for (std::size_t first = 0, last = order.size(); first < last; last = order.size()) {
    if (team.workers() >= kWorkersForLevels && last - first >= kLargeLevel) {
      visit_next_level(triangles, first, order, number, team);
      first = last;
      continue;
    }
    for (; first < last; ++first) {  // the same
      for (const std::uint32_t n : triangles[order[first]].n) {
        if (!is_side(n)) visit(n);
      }
    }
  }
  return order;
}

// There is most memory in use here, so one array is replaced after the other.
void MutableMesh::arrange(const Team& team) {
  give_back(home);
  give_back(excess);
  UnsetVector<std::uint32_t> number;
  std::vector<std::uint32_t> order = order_from_sides(number, team);
  const std::size_t room = order.size() + order.size() / kSpareOf;
  UnsetVector<MeshTriangle> sorted;
  sorted.reserve(room);
  sorted.resize(order.size());
  team.each_range(order.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      sorted[k] = triangles[order[k]];
      for (std::uint32_t& n : sorted[k].n) n = is_side(n) ? n : number[n];
    }
  });
  triangles = std::move(sorted);
  give_back(number);
  give_back(order);
  number_vertices(team);
  free_triangles_.clear();
  excess.reserve(room);
  excess.resize(triangles.size());
  measure_all(team);
}

namespace {

/// Numbers the vertices of triangles that are not fixed, by ranges of triangles, in the order of
/// their first corners, and sets the home of each to its last triangle. `vertex` has the numbers of
/// those that are fixed, and gets those of the others; returns the number after the last one.
std::uint32_t number_by_team(std::span<MeshTriangle> triangles, std::uint32_t fixed,
                             std::span<std::uint32_t> vertex, std::span<std::uint32_t> home,
                             const Team& team) {
  std::vector<std::uint32_t> first_corner(vertex.size(), kNone);
  const auto for_each = [&](const auto& use) {
    team.each_range(triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
        for (const Corner i : kCorners) use(first / kItemsAtATime, 3 * t + i, triangles[t].v[i]);
      }
    });
  };
  for_each([&](std::size_t, std::uint32_t corner, std::uint32_t v) {
    if (v < fixed) return;
    const std::atomic_ref least(first_corner[v]);
    std::uint32_t other = least.load(std::memory_order_relaxed);
    while (corner < other &&
           !least.compare_exchange_weak(other, corner, std::memory_order_relaxed)) {
    }
  });
  std::vector<std::uint32_t> next(Team::ranges(triangles.size(), kItemsAtATime) + 1, 0);
  for_each([&](std::size_t range, std::uint32_t corner, std::uint32_t v) {
    if (first_corner[v] == corner) ++next[range + 1];
  });
  next[0] = fixed;
  for (std::size_t k = 1; k < next.size(); ++k) next[k] += next[k - 1];
  const std::uint32_t end = next.back();
  for_each([&](std::size_t range, std::uint32_t corner, std::uint32_t v) {
    if (first_corner[v] == corner) vertex[v] = next[range]++;
  });
  for_each([&](std::size_t, std::uint32_t corner, std::uint32_t v) {
    const std::uint32_t t = corner / 3, number = vertex[v];
    triangles[t].v[corner % 3] = number;
    set_to_last(home[number], t);
  });
  return end;
}

}  // namespace

void MutableMesh::number_vertices(const Team& team) {
  const std::size_t count = points.size() - free_vertices_.size();
  const std::size_t room = count + count / kSpareOf;
  std::vector<std::uint32_t> vertex(points.size(), kNone);
  for (std::uint32_t v = 0; v < fixed_; ++v) vertex[v] = v;
  std::uint32_t next = fixed_;
  home.reserve(room);
  home.assign(count, kNone);
  if (team.workers() > 1) {
    next = number_by_team(triangles, fixed_, vertex, home, team);
  } else {  // the same in one pass
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (std::uint32_t& v : triangles[t].v) {
        if (vertex[v] == kNone) vertex[v] = next++;
        v = vertex[v];
        home[v] = t;
      }
    }
  }
  UnsetVector<Point> sorted;
  sorted.reserve(room);
  sorted.resize(next);
  team.each_range(points.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      if (vertex[v] != kNone) sorted[vertex[v]] = points[v];
    }
  });
  points = std::move(sorted);
  free_vertices_.clear();
}

bool MutableMesh::is_valid() const {
  for (const MeshTriangle& t : triangles) {
    if (t.v[0] == kNone) continue;
    if (orientation(points[t.v[0]], points[t.v[1]], points[t.v[2]]) != Sign::positive) return false;
  }
  return true;
}

}  // namespace cover
