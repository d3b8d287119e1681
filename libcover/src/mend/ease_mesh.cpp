// An angle at a is obtuse if g = (b - a).(c - a) is negative. The shortest move of all three that
// makes g zero, to first order, goes along the gradient of g, as far as each of them may move: a
// projection onto what the triangle allows. These are done in turn, as often as one is left; where
// all that is asked for together leaves any room, that ends.
// Tested by tests/unit/mend/ease_mesh_test.cpp.
#include "mend/ease_mesh.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <utility>
#include <vector>

#include "cdt/cdt.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/foot.hpp"
#include "geom/predicates.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "mend/effort.hpp"

namespace cover {
namespace {

constexpr double kLittle = 0.01;    ///< cosine of what is obtuse by little
constexpr double kMostMove = 0.25;  ///< of the shortest edge
constexpr double kSpacings = 4;  ///< of coordinates, beyond a right angle that is asked for exactly

class Easer {
 public:
  Easer(std::span<const FollowedVertex> pairs, const JoinedMesh& mesh)
      : mesh_(mesh),
        points_(mesh.points),
        follower_(points_.size(), kNone),
        leader_(points_.size(), kNone),
        right_at_first_(points_.size(), false),
        around_(points_.size()),
        reach_(largest_coordinate(points_)) {
    for (const FollowedVertex& pair : pairs) {
      follower_[pair.first] = pair.other;
      leader_[pair.other] = pair.first;
      right_at_first_[pair.first] = pair.right_at_first;
    }
    std::vector<IndexPair> pieces;
    for (const JoinedMesh::Piece& piece : mesh.pieces)
      pieces.push_back({std::min(piece.a, piece.b), std::max(piece.a, piece.b)});
    std::sort(pieces.begin(), pieces.end());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const IndexTriple& v = mesh.triangles[t];
      std::array<bool, 3>& faces = faces_piece_.emplace_back();
      for (const Corner i : kCorners) {
        around_[v[i]].push_back(t);
        const auto [b, c] = std::minmax(v[i.next()], v[i.previous()]);
        faces[i] = std::binary_search(pieces.begin(), pieces.end(), IndexPair{b, c});
      }
    }
    is_waiting_.assign(mesh.triangles.size(), false);
  }

  void run() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) wait(t);
    for (std::size_t k = 0;
         k < effort::mend::kMostMoves * mesh_.triangles.size() && !waiting_.empty(); ++k) {
      const std::uint32_t t = waiting_.front();
      waiting_.pop_front();
      is_waiting_[t] = false;
      for (const Corner i : kCorners) right(t, i);
    }
  }

  [[nodiscard]] bool is_sound() const {
    return std::all_of(mesh_.triangles.begin(), mesh_.triangles.end(), [&](const IndexTriple& t) {
      return orientation(points_[t[0]], points_[t[1]], points_[t[2]]) == Sign::positive;
    });
  }

  [[nodiscard]] std::vector<Point> points() && { return std::move(points_); }

 private:
  /// What moves, and how g changes with it: along a line that is one number.
  struct Mover {
    std::uint32_t vertex;
    Vector gradient;
  };

  void wait(std::uint32_t t) {
    if (is_waiting_[t]) return;
    is_waiting_[t] = true;
    waiting_.push_back(t);
  }

  [[nodiscard]] bool is_on_line(std::uint32_t v) const {
    return mesh_.line[v] < mesh_.lines.size();
  }

  [[nodiscard]] Vector direction(std::uint32_t v) const {
    const auto& [a, b] = mesh_.lines[mesh_.line[v]];
    return (1 / length(b - a)) * (b - a);
  }

  /// On its line, at the foot of `p`.
  [[nodiscard]] Point on_line(std::uint32_t v, Point p) const {
    const auto& [a, b] = mesh_.lines[mesh_.line[v]];
    return nearest_on_line(a, b, p);
  }

  /// `gradient` of g by the place of `v`, for what moves it.
  void add(std::uint32_t v, Vector gradient, std::vector<Mover>& movers) const {
    if (!is_on_line(v)) {
      if (mesh_.line[v] == JoinedMesh::kInside) movers.push_back({v, gradient});
      return;
    }
    double by = dot(gradient, direction(v));
    if (const std::uint32_t leader = leader_[v]; leader != kNone) {
      const double cosine = dot(direction(v), direction(leader));
      by = right_at_first_[leader] ? by / cosine : by * cosine;
      v = leader;
    }
    const auto same = std::find_if(movers.begin(), movers.end(),
                                   [&](const Mover& mover) { return mover.vertex == v; });
    if (same != movers.end()) {
      same->gradient = same->gradient + by * direction(v);
    } else {
      movers.push_back({v, by * direction(v)});
    }
  }

  void move(std::uint32_t v, Vector by) {
    before_.emplace_back(v, points_[v]);
    points_[v] = points_[v] + by;
    if (is_on_line(v)) points_[v] = on_line(v, points_[v]);
    if (const std::uint32_t other = follower_[v]; other != kNone) {
      before_.emplace_back(other, points_[other]);
      points_[other] = right_at_first_[v] ? across(v, other) : on_line(other, points_[v]);
    }
  }

  /// On the line of `other`, at a right angle to that of `v`.
  [[nodiscard]] Point across(std::uint32_t v, std::uint32_t other) const {
    const auto& [a, b] = mesh_.lines[mesh_.line[other]];
    return straight_across(points_[v], direction(v), a, b);
  }

  /// No triangle around a vertex, or what follows it, turned over.
  [[nodiscard]] bool stays_sound(std::uint32_t v) const {
    return is_sound(around_[v]) && (follower_[v] == kNone || is_sound(around_[follower_[v]]));
  }

  [[nodiscard]] bool is_sound(const std::vector<std::uint32_t>& triangles) const {
    return std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t t) {
      const IndexTriple& v = mesh_.triangles[t];
      return orientation(points_[v[0]], points_[v[1]], points_[v[2]]) == Sign::positive;
    });
  }

  /// Makes the angle at corner `i` right if it is obtuse.
  void right(std::uint32_t t, Corner i) {
    const IndexTriple& v = mesh_.triangles[t];
    const std::uint32_t a = v[i], b = v[i.next()], c = v[i.previous()];
    const Vector ab = points_[b] - points_[a], ac = points_[c] - points_[a];
    const Blunt is = bluntness(points_[b], points_[a], points_[c]);
    if (is == Blunt::no || (is == Blunt::by_rounding && !faces_piece_[t][i])) return;
    const double reach = length(ab) + length(ac);
    if (-dot(ab, ac) > kLittle * length(ab) * length(ac)) return;
    movers_.clear();
    add(b, ac, movers_);
    add(c, ab, movers_);
    add(a, Vector{-ab.x - ac.x, -ab.y - ac.y}, movers_);
    double squared = 0;
    for (const Mover& mover : movers_) squared += squared_length(mover.gradient);
    if (!(squared > 0)) return;
    const double beyond = faces_piece_[t][i] ? kSpacings * spacing_at(reach_) * reach : 0;
    const double step = (beyond - dot(ab, ac)) / squared;
    const double most = kMostMove * std::min({length(ab), length(ac), length(ac - ab)});
    for (const Mover& mover : movers_) {
      if (step * length(mover.gradient) > most) return;
    }
    before_.clear();
    bool is_sound = true;
    for (const Mover& mover : movers_) {
      move(mover.vertex, step * mover.gradient);
      is_sound = is_sound && stays_sound(mover.vertex);
    }
    if (is_sound) {
      for (const auto& [u, p] : before_) {
        for (const std::uint32_t s : around_[u]) wait(s);
      }
    } else {
      for (auto moved = before_.rbegin(); moved != before_.rend(); ++moved)
        points_[moved->first] = moved->second;
    }
  }

  const JoinedMesh& mesh_;
  std::vector<Point> points_;
  std::vector<std::uint32_t> follower_, leader_;
  std::vector<bool> right_at_first_;
  std::vector<std::vector<std::uint32_t>> around_;  ///< by vertex: triangles
  std::vector<std::array<bool, 3>> faces_piece_;    ///< by triangle and corner
  double reach_;                                    ///< the largest coordinate
  std::deque<std::uint32_t> waiting_;
  std::vector<bool> is_waiting_;
  std::vector<Mover> movers_;
  std::vector<std::pair<std::uint32_t, Point>> before_;  ///< what the last move has moved
};

}  // namespace

Point straight_across(Point p, Vector along, Point a, Point b) {
  return at_part(a, b, dot(p - a, along) / dot(b - a, along));
}

bool ease(std::span<const FollowedVertex> pairs, JoinedMesh& mesh) {
  Easer easer(pairs, mesh);
  easer.run();
  if (!easer.is_sound()) return false;
  mesh.points = std::move(easer).points();
  return true;
}

}  // namespace cover
