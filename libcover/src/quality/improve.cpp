// See improve.hpp. Tested by tests/unit/quality/improve_test.cpp.
#include "quality/improve.hpp"

#include "base/once_queue.hpp"
#include "geom/predicates.hpp"
#include "quality/cavity.hpp"
#include "quality/placement.hpp"
#include "quality/polygon.hpp"

namespace cover {
namespace {

constexpr double kLeastGain = 0.01;  ///< of the excess: what a step must win to be worth its time
constexpr int kLargestCavity = 4;    ///< triangles: larger ones succeed once in thirty times

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The excess that a step on triangles with largest excess `worst` must stay below.
double improvement_of(double worst) { return (1 - kLeastGain) * worst; }

class Improver {
 public:
  Improver(MutableMesh& mesh, std::uint64_t budget) : mesh_(mesh), budget_(budget), cavity_(mesh) {}

  ImproveResult run() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) enqueue(t);
    while (!queue_.empty()) {
      const std::uint32_t t = queue_.pop();
      if (!(mesh_.excess[t] > 0)) continue;
      if (result_.evaluations > budget_) {
        result_.budget_used_up = true;
        break;
      }
      (void)(try_flip(t) || try_move(t) || try_removal(t) || try_restar(t));
    }
    return result_;
  }

 private:
  void enqueue(std::uint32_t t) {
    if (mesh_.excess[t] > 0) queue_.push(t);
  }

  /// Queues a changed triangle and those beside it.
  void changed(std::uint32_t t) {
    enqueue(t);
    for (const std::uint32_t n : mesh_.triangles[t].n) {
      if (!is_side(n)) enqueue(n);
    }
  }

  bool try_flip(std::uint32_t t) {
    int best_edge = -1;
    double best_gain = 0;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t u = mesh_.triangles[t].n[at(i)];
      if (is_side(u)) continue;
      const double before = std::max(mesh_.excess[t], mesh_.excess[u]);
      const double limit = improvement_of(before);
      const double after = mesh_.excess_after_flip(t, i, limit);
      if (!(after < limit)) continue;
      if (best_edge < 0 || before - after > best_gain) {
        best_edge = i;
        best_gain = before - after;
      }
    }
    if (best_edge < 0) return false;
    const std::uint32_t u = mesh_.triangles[t].n[at(best_edge)];
    if (!mesh_.flip(t, best_edge)) return false;
    ++result_.flips;
    changed(t);
    changed(u);
    return true;
  }

  bool try_move(std::uint32_t t) {
    const std::array<std::uint32_t, 3> corners = mesh_.triangles[t].v;
    for (const std::uint32_t v : corners) {
      if (mesh_.is_fixed(v) || !cavity_.start_star(v)) continue;
      const double limit = improvement_of(cavity_.worst());
      const Placement placement =
          place(Hole(mesh_, cavity_), mesh_.points[v], limit, result_.evaluations);
      if (placement.worst < limit && relocate(mesh_, cavity_, placement.at)) {
        ++result_.moves;
        for (int k = 0; k < cavity_.size(); ++k) {
          enqueue(cavity_.triangle(k));
          if (!is_side(cavity_.outer(k))) enqueue(cavity_.outer(k));
        }
        return true;
      }
    }
    return false;
  }

  bool try_removal(std::uint32_t t) {
    const std::array<std::uint32_t, 3> corners = mesh_.triangles[t].v;
    for (const std::uint32_t v : corners) {
      if (mesh_.is_fixed(v) || !cavity_.start_star(v) || cavity_.size() > kPolygonLimit) continue;
      Patch patch;
      const double worst = min_max_polygon(mesh_, cavity_, cavity_.worst(), patch);
      ++result_.evaluations;
      if (worst <= cavity_.worst() && install_patch(mesh_, cavity_, patch, installed_)) {
        ++result_.removals;
        finish();
        return true;
      }
    }
    return false;
  }

  /// Grows a cavity from `t`, alone or with each of its neighbours, and puts a vertex into it.
  bool try_restar(std::uint32_t t) {
    Cavity best_cavity(mesh_);
    Placement best;
    double best_gain = 0;
    for (int i = -1; i < 3; ++i) {
      cavity_.start(t);
      if (i >= 0 && !cavity_.grow(i)) continue;
      Point p = i < 0 ? Hole(mesh_, cavity_).centre() : midpoint_of_loop_edge(t, i);
      for (;;) {
        const Hole hole(mesh_, cavity_);
        const double limit = improvement_of(cavity_.worst());
        Placement placement{p, kInverted};
        ++result_.evaluations;
        if (has_room(mesh_, cavity_, limit)) {
          placement = place(hole, p, 0, result_.evaluations);
          if (!(placement.worst < kInverted)) break;
          p = placement.at;
        }
        const double gain = limit - placement.worst;
        if (gain > best_gain || (best_gain == 0 && placement.worst < best.worst)) {
          best_cavity = cavity_;
          best = placement;
          best_gain = std::max(gain, 0.0);
        }
        if (placement.worst <= 0 || cavity_.triangle_count() >= kLargestCavity) break;
        if (!grow_towards(p, hole)) break;
      }
      if (best_gain > 0 && best.worst <= 0) break;
    }
    if (!(best.worst < kInverted)) return false;
    if (best.worst > 0) {
      best = place(Hole(mesh_, best_cavity), best.at, improvement_of(best_cavity.worst()),
                   result_.evaluations);
    }
    if (!(best.worst < improvement_of(best_cavity.worst()))) return false;
    if (!install_star(mesh_, best_cavity, best.at, installed_)) return false;
    ++result_.insertions;
    finish();
    return true;
  }

  /// Grows the cavity across the edge with the worst triangle among those that can be taken in and
  /// whose new vertex `p` sees.
  bool grow_towards(Point p, const Hole& hole) {
    std::array<bool, Cavity::kCapacity> tried{};
    for (int count = 0; count < 4; ++count) {
      const int k = hole.worst_edge(p, tried);
      if (k < 0) return false;
      tried[at(k)] = true;
      if (!cavity_.sees_beyond(k, p)) continue;
      if (cavity_.grow(k)) return true;
    }
    return false;
  }

  /// The middle of the edge of `t` that loop edge i of Cavity::start is.
  [[nodiscard]] Point midpoint_of_loop_edge(std::uint32_t t, int i) const {
    return midpoint(mesh_.corner(t, i), mesh_.corner(t, next3(i)));
  }

  void finish() {
    for (int k = 0; k < installed_.count; ++k) changed(installed_.triangles[at(k)]);
  }

  MutableMesh& mesh_;
  std::uint64_t budget_;
  ImproveResult result_;
  Cavity cavity_;
  Installed installed_;
  OnceQueue queue_;
};

}  // namespace

ImproveResult improve(MutableMesh& mesh, std::uint64_t budget) {
  return Improver(mesh, budget).run();
}

}  // namespace cover
