// Tested by tests/unit/mend/repairs_test.cpp.
#include "mend/repairs.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "base/containers/order.hpp"
#include "base/numbers.hpp"
#include "geom/vector.hpp"
#include "mend/effort.hpp"

namespace cover {
namespace {

constexpr double kRatherStays = 0.2;  ///< cost of a vertex that was put where it is on purpose
constexpr double kGain = 1e-9;        ///< of the cost, that counts as better
constexpr std::size_t kStay = 3;      ///< steps for which a vertex that was moved stays
constexpr std::size_t kSeldom = 3;    ///< once in so many steps any bad triangle, not the worst

}  // namespace

bool Repairs::is_bad(std::uint32_t t) const {
  return mesh_.triangles()[t].v[0] != kNone && mesh_.triangles()[t].cost > 0;
}

bool Repairs::is_grave(std::uint32_t t) const {
  const MeshWithUndo::Triangle& triangle = mesh_.triangles()[t];
  return triangle.v[0] != kNone && MeshWithUndo::is_grave(triangle);
}

bool Repairs::is_beyond_worst(std::uint32_t t) const {
  const MeshWithUndo::Triangle& triangle = mesh_.triangles()[t];
  return triangle.v[0] != kNone && MeshWithUndo::is_beyond_worst(triangle);
}

bool Repairs::is_bad_by_a_movable(std::uint32_t t) const {
  if (!is_bad(t) || is_grave(t)) return false;
  const auto corner = corner_over_a_piece(t);
  return corner && mesh_.is_movable(mesh_.triangles()[t].v[*corner]);
}

bool Repairs::is_fine(const MostBad& most) const {
  return mesh_.bad() <= most.bad && mesh_.grave() <= most.grave &&
         mesh_.bad() - mesh_.grave() <= most.by_sign_only &&
         mesh_.beyond_worst() <= most.beyond_worst;
}

/// The corner that sees a piece opposite to it at more than a right angle; nothing if none does.
std::optional<Corner> Repairs::corner_over_a_piece(std::uint32_t t) const {
  const MeshWithUndo::Triangle& triangle = mesh_.triangles()[t];
  for (const Corner i : kCorners) {
    const Point apex = mesh_.at(triangle.v[i]), a = mesh_.at(triangle.v[i.next()]),
                b = mesh_.at(triangle.v[i.previous()]);
    if (triangle.line[i] != JoinedMesh::kInside && dot(a - apex, b - apex) < 0) return i;
  }
  return std::nullopt;
}

std::vector<std::uint32_t> Repairs::neighbours(std::uint32_t v) const {
  std::vector<std::uint32_t> found;
  const std::uint32_t start = mesh_.vertices()[v].home;
  const auto turn = [&](std::uint32_t t, bool left) {
    const MeshWithUndo::Triangle& triangle = mesh_.triangles()[t];
    const Corner i = corner_with(triangle.v, v);
    found.push_back(triangle.v[left ? i.previous() : i.next()]);
    return triangle.n[left ? i.next() : i.previous()];
  };
  std::uint32_t t = start;
  do {
    t = turn(t, true);
  } while (t != kNone && t != start && found.size() < effort::mend::kMostNeighbours);
  if (t == kNone) {
    for (t = start; t != kNone && found.size() < effort::mend::kMostNeighbours;) t = turn(t, false);
  }
  return found;
}

std::vector<std::uint32_t> Repairs::near(std::uint32_t v, std::size_t count) {
  std::vector<std::uint32_t> found{v}, seen{v};
  for (std::size_t head = 0;
       head < seen.size() && seen.size() < effort::mend::kMostSeen && found.size() < 2 * count;
       ++head) {
    std::vector<std::uint32_t> around = neighbours(seen[head]);
    const std::size_t turn = around.empty() ? 0 : random_.below(around.size());
    std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(turn), around.end());
    for (const std::uint32_t u : around) {
      if (std::find(seen.begin(), seen.end(), u) != seen.end()) continue;
      seen.push_back(u);
      if (mesh_.is_movable(u)) found.push_back(u);
    }
  }
  if (found.size() > count) found.resize(count);
  return found;
}

/// A new attempt, to mend `t` or, if that is kNone, what the attempt itself makes bad.
void Repairs::begin_at(std::uint32_t t) {
  focus_ = t;
  spares_.clear();
  starts_.clear();
}

bool Repairs::take(std::uint32_t v) {
  const Point p = mesh_.at(v);
  if (!mesh_.remove(v)) return false;
  spares_.push_back(v);
  starts_.push_back(p);
  return true;
}

bool Repairs::without(std::uint32_t v, const MostBad& most) {
  left_.spend(kRemoval);
  if (!mesh_.remove(v)) return false;
  if (is_fine(most)) return true;
  mesh_.undo(0);
  return false;
}

bool Repairs::with_more_vertices(std::uint32_t t, const MostBad& most, std::size_t tries) {
  begin_at(t);
  for (const int more : std::span(effort::mend::kMore).first(tries)) {
    if (repair(more, effort::mend::steps_with_more(more), most)) return true;
    mesh_.undo(0);
  }
  return false;
}

bool Repairs::with_fewer_vertices(std::uint32_t t, const MostBad& most) {
  begin_at(t);
  for (int step = 0; step < effort::mend::kMostTaken && !left_.is_over(); ++step) {
    const std::uint32_t v = most_helpful_removal(t);
    if (v == kNone || !mesh_.remove(v)) break;
    if (is_fine(most)) return true;
  }
  mesh_.undo(0);
  return false;
}

/// Whether one of the triangles nearest to `t`, as far as pieces that stay whole let it be reached,
/// has a vertex that can be put elsewhere.
bool Repairs::is_near_a_movable(std::uint32_t t) const {
  std::vector<std::uint32_t> seen{t};
  for (std::size_t head = 0; head < seen.size() && seen.size() < effort::mend::kMostSeen; ++head) {
    const MeshWithUndo::Triangle& triangle = mesh_.triangles()[seen[head]];
    for (const Corner i : kCorners) {
      if (mesh_.is_movable(triangle.v[i])) return true;
      const bool is_wall =
          triangle.line[i] != JoinedMesh::kInside && triangle.line[i] >= mesh_.lines().size();
      const std::uint32_t n = triangle.n[i];
      if (n != kNone && !is_wall && std::find(seen.begin(), seen.end(), n) == seen.end())
        seen.push_back(n);
    }
  }
  return false;
}

bool Repairs::with_other_vertices(std::uint32_t t, const MostBad& most, std::uint64_t places) {
  if (!is_near_a_movable(t)) return false;  // more vertices alone are with_more_vertices()
  const std::array<std::uint32_t, 3> corners = mesh_.triangles()[t].v;
  const std::uint64_t end = left_.count - std::min(left_.count, places);
  while (left_.count > end && !left_.is_over()) {
    begin_at(t);
    left_.spend(kRemoval);
    const std::size_t count = 1 + random_.below(effort::mend::kMostAnew);
    for (const std::uint32_t v : near(corners[random_.below(3)], count)) {
      if (mesh_.is_movable(v)) take(v);
    }
    const int more = static_cast<int>(spares_.size() + random_.below(3));
    if (repair(more, effort::mend::steps_with_others(more), most)) return true;
    mesh_.undo(0);
  }
  return false;
}

bool Repairs::with_cuts(std::uint32_t t, const MostBad& most) {
  begin_at(t);
  for (int step = 0; step < effort::mend::kLongestDrive && !left_.is_over(); ++step) {
    if (is_fine(most)) return true;
    const std::optional<Spot> foot = foot_of_a_blunt_corner();
    if (!foot || mesh_.insert(*foot) == kNone) break;
  }
  if (repair(effort::mend::kMore.back(), effort::mend::kStepsAfterCuts, most)) return true;
  mesh_.undo(0);
  return false;
}

bool Repairs::with_others_in_place_of(std::span<const std::uint32_t> vertices, const MostBad& most,
                                      const std::function<Others(int taken)>& others_for) {
  begin_at(kNone);
  left_.spend(kRemoval);  // so that rounds end where nothing can be done
  for (const std::uint32_t v : vertices) take(v);
  if (spares_.empty()) return false;
  const Others others = others_for(static_cast<int>(spares_.size()));
  if (spares_.size() > 1) {
    Vector sum{0, 0};
    for (const Point& p : starts_) sum = sum + (p - starts_[0]);
    starts_.push_back(starts_[0] + (1 / static_cast<double>(spares_.size())) * sum);
  }
  if (repair(others.count, others.steps, most)) return true;
  mesh_.undo(0);
  return false;
}

/// Adds up to `more` vertices and moves others until the mesh is fine.
bool Repairs::repair(int more, int steps, const MostBad& most) {
  stay_.clear();
  double best = mesh_.cost();
  int in_vain = 0;
  const int most_in_vain = effort::mend::kInVain + more;
  for (int step = 0; step < steps; ++step) {
    if (is_fine(most)) return true;
    if (left_.is_over()) return false;
    const std::uint32_t t = a_bad_triangle();
    if (t == kNone) return false;
    VertexPlace placement;
    if (more > 0) places_.add_one(t, starts_, placement);
    places_.move_one(t, stay_, placement);
    if (!(placement.cost < kInfinity) || !apply(placement, more)) return false;
    if (mesh_.cost() < best - kGain) {
      best = mesh_.cost();
      in_vain = 0;
    } else if (++in_vain > most_in_vain) {
      break;
    }
  }
  return is_fine(most);
}

bool Repairs::apply(const VertexPlace& placement, int& more) {
  std::uint32_t v = placement.vertex;
  if (v != kNone) {
    if (!mesh_.remove(v)) return false;
    stay_.push_back(v);
    if (stay_.size() > kStay) stay_.erase(stay_.begin());
  } else {
    --more;
    if (!spares_.empty()) {
      v = spares_.back();
      spares_.pop_back();
    }
  }
  return mesh_.insert(placement.spot, v) != kNone;
}

/// One of those that this attempt has made, mostly the worst one.
std::uint32_t Repairs::a_bad_triangle() {
  if (focus_ != kNone && is_bad(focus_)) return focus_;
  bad_.clear();
  for (const std::uint32_t t : mesh_.written_since(0)) {
    if (is_bad(t)) bad_.push_back(t);
  }
  if (bad_.empty()) return kNone;
  sort_unique(bad_);
  if (random_.below(kSeldom) == 0) return bad_[random_.below(bad_.size())];
  return *std::max_element(bad_.begin(), bad_.end(), [&](std::uint32_t s, std::uint32_t t) {
    return mesh_.triangles()[s].cost < mesh_.triangles()[t].cost;
  });
}

/// Of the worst bad triangle that has one opposite to a piece, among those of this attempt.
std::optional<Spot> Repairs::foot_of_a_blunt_corner() {
  std::vector<std::uint32_t> places = mesh_.written_since(0);
  places.push_back(focus_);
  std::optional<Spot> foot;
  double worst = 0;
  for (const std::uint32_t t : places) {
    if (!is_bad(t) || mesh_.triangles()[t].cost <= worst) continue;
    const auto corner = corner_over_a_piece(t);
    if (!corner) continue;
    const Point apex = mesh_.at(mesh_.triangles()[t].v[*corner]);
    const Spot spot = mesh_.on_line(apex, t, *corner);
    left_.spend(1);
    if (spot.triangle == kNone || !(mesh_.change_with(spot) < kInfinity)) continue;
    worst = mesh_.triangles()[t].cost;
    foot = spot;
  }
  return foot;
}

/// Vertices of `t` and its neighbours, and of what became gravely bad since, in order.
std::vector<std::uint32_t> Repairs::removable_around(std::uint32_t t) const {
  std::vector<std::uint32_t> found;
  const auto add = [&](std::uint32_t s) {
    for (const std::uint32_t v : mesh_.triangles()[s].v) {
      if ((mesh_.is_movable(v) || mesh_.only_goes(v)) &&
          std::find(found.begin(), found.end(), v) == found.end())
        found.push_back(v);
    }
  };
  std::vector<std::uint32_t> places = mesh_.written_since(0);
  places.push_back(t);
  for (const std::uint32_t place : places) {
    if (!is_bad(place) || (place != t && !is_grave(place))) continue;
    for (const std::uint32_t s : mesh_.triangles()[place].n) {
      if (s != kNone) add(s);
    }
    add(place);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::uint32_t Repairs::most_helpful_removal(std::uint32_t t) {
  std::uint32_t best = kNone;
  double least = kInfinity;
  for (const std::uint32_t v : removable_around(t)) {
    const std::size_t mark = mesh_.mark();
    left_.spend(kRemoval);
    if (!mesh_.remove(v)) continue;
    const double cost =
        static_cast<double>(mesh_.grave()) + mesh_.cost() + (mesh_.only_goes(v) ? kRatherStays : 0);
    if (cost < least) least = cost, best = v;
    mesh_.undo(mark);
  }
  return best;
}

}  // namespace cover
