// See thin_out.hpp. Tested by tests/unit/quality/repair/thin_out_test.cpp.
#include "quality/repair/thin_out.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geom/vector.hpp"
#include "quality/fault/keep_rules.hpp"
#include "quality/mutable/cavity.hpp"
#include "quality/optimum/min_max_polygon.hpp"
#include "quality/optimum/placement.hpp"

namespace cover {
namespace {

constexpr double kHopeless = 0.4;  ///< excess of a first try from which no place is found
constexpr int kPartners = 2;  ///< neighbours of a vertex that it may be merged with: the nearest

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Thinner {
 public:
  Thinner(MutableMesh& mesh, std::uint64_t budget)
      : mesh_(mesh), budget_(budget), cavity_(mesh), widest_(mesh.goal(), kMostThinned) {}

  ThinOutResult run() {
    vertices_.resize(mesh_.points.size());
    for (std::uint32_t v = mesh_.fixed_vertices(); v < mesh_.points.size(); ++v) enqueue(v);
    return work_off();
  }
  /// Begins with these vertices alone.
  ThinOutResult run(std::span<const std::uint32_t> vertices) {
    vertices_.resize(mesh_.points.size());
    for (const std::uint32_t v : vertices) enqueue(v);
    return work_off();
  }

 private:
  ThinOutResult work_off() {
    std::size_t removed = 0;
    for (; now_ < queue_.size() && evaluations_ < budget_; ++now_) {
      const std::uint32_t v = queue_[now_];
      vertices_[v] = {now_, vertices_[v].changed, false, {kNone, kNone}};
      if (mesh_.home[v] == kNone) continue;
      if (cavity_.start_star(v) && (try_removal() || try_merge(v))) {
        ++removed;
        for (int k = 0; k < installed_.count; ++k) {
          for (const std::uint32_t w : mesh_.triangles[installed_.triangles[at(k)]].v) enqueue(w);
        }
      }
    }
    return {removed, evaluations_};
  }

  /// What is known of a free vertex. Times are places in the queue.
  struct Vertex {
    std::uint32_t looked_at = 0;
    std::uint32_t changed = 0;  ///< its star
    bool is_queued = false;
    std::array<std::uint32_t, kPartners> partners{kNone, kNone};  ///< tried in vain
  };

  void enqueue(std::uint32_t v) {
    if (mesh_.is_fixed(v) || mesh_.home[v] == kNone) return;
    vertices_[v].changed = now_;
    if (std::exchange(vertices_[v].is_queued, true)) return;
    queue_.push_back(v);
  }

  /// Whether `u` has been tried with `v`, and both stars are as they were.
  [[nodiscard]] bool is_known(std::uint32_t u, std::uint32_t v) const {
    const Vertex& other = vertices_[u];
    return !other.is_queued && other.looked_at > vertices_[v].changed &&
           std::find(other.partners.begin(), other.partners.end(), v) != other.partners.end();
  }

  /// ENSURES: where it fails, the cavity is the star of `v`
  bool try_removal() {
    ++evaluations_;
    Patch patch;
    return min_max_polygon(mesh_, cavity_, kMostThinned, patch) <= kMostThinned &&
           install_patch(mesh_, cavity_, patch, installed_);
  }

  /// Replaces `v`, whose star the cavity is, and one of the free vertices nearest to it by one
  /// vertex.
  bool try_merge(std::uint32_t v) {
    const Cavity star = cavity_;
    std::array<double, Cavity::kCapacity> distances{};  // squared; infinite: no partner
    const Point* const points = mesh_.points.data();
    for (int k = 0; k < star.size(); ++k) {
      const std::uint32_t w = star.vertex(k);
      distances[at(k)] = mesh_.is_fixed(w) ? kInverted : squared_length(points[w] - points[v]);
    }
    const std::span<const double> known = std::span(distances).first(at(star.size()));
    for (int attempt = 0; attempt < kPartners; ++attempt) {
      const int k = nearest_free(known, attempt);
      if (k < 0) return false;
      const std::uint32_t u = star.vertex(k);
      vertices_[v].partners[at(attempt)] = u;
      if (is_known(u, v) || !has_room_beside(star, k)) continue;
      cavity_ = star;
      if (!swallow(u) || !has_room(mesh_, cavity_, kMostThinned)) continue;
      const Hole hole(mesh_, cavity_);
      const Point middle = midpoint(mesh_.points[u], mesh_.points[v]);
      ++evaluations_;
      if (hole.worst(middle, kHopeless) > kHopeless) continue;
      const Placement placement = place(hole, middle, kMostThinned);
      evaluations_ += placement.evaluations;
      if (placement.worst <= kMostThinned &&
          install_star(mesh_, cavity_, placement.at, installed_)) {
        return true;
      }
    }
    return false;
  }

  /// Whether the loop of `star` and that around its vertex k, made one, has room at the corners
  /// that they share: there most loops are too wide, and this is known before the cavity is grown.
  [[nodiscard]] bool has_room_beside(const Cavity& star, int k) const {
    const int before = star.previous(k), after = star.next(k);
    const Point* const points = mesh_.points.data();
    const auto corner = [&](int i) { return points[star.vertex(i)]; };
    const auto beyond = [&](int i) {  // the corner across loop edge i, which is no side
      const MeshTriangle& t = mesh_.triangles[star.outer(i)];
      return points[t.v[t.edge_from(star.vertex(star.next(i)))]];
    };
    return widest_.allows(corner(star.previous(before)), corner(before), beyond(before)) &&
           widest_.allows(beyond(k), corner(after), corner(star.next(after)));
  }

  /// The first index of the `rank`-th of the different distances, from 0, in order; -1: there are
  /// fewer.
  static int nearest_free(std::span<const double> distances, int rank) {
    int result = -1;
    double last = -1;
    for (int r = 0; r <= rank; ++r) {
      double least = kInverted;
      result = -1;
      for (std::size_t k = 0; k < distances.size(); ++k) {
        if (distances[k] <= last || distances[k] >= least) continue;
        least = distances[k];
        result = static_cast<int>(k);
      }
      last = least;
    }
    return result;
  }

  /// Grows the cavity around `u` on its loop until `u` is inside; or a vertex beside it that has
  /// three edges: then that one goes in its place, and `u` stays.
  bool swallow(std::uint32_t u) {
    const int before = cavity_.swallowed_count();
    while (cavity_.swallowed_count() == before) {
      int k = 0;
      while (cavity_.vertex(k) != u) ++k;
      if (!cavity_.grow(k)) return false;
    }
    return true;
  }

  MutableMesh& mesh_;
  std::uint64_t budget_;
  std::uint64_t evaluations_ = 0;
  Cavity cavity_;
  WidestCorner widest_;
  Installed installed_;
  std::vector<std::uint32_t> queue_;
  std::uint32_t now_ = 0;
  std::vector<Vertex> vertices_;
};

ThinOutResult thin_out_in_parts(MutableMesh& mesh, std::uint64_t budget, const Sharing& sharing) {
  std::vector<ThinOutResult> results(part_count(mesh, sharing));
  const auto triangles = static_cast<double>(mesh.triangle_count());
  const Borders borders = work_in_parts(mesh, sharing, [&](Part& part) {
    const double share = static_cast<double>(part.mesh.triangles.size()) / triangles;
    const auto own = static_cast<std::uint64_t>(share * static_cast<double>(budget));
    results[part.index] = Thinner(part.mesh, own).run();
  });
  ThinOutResult sum;
  for (const ThinOutResult& result : results) {
    sum.removed += result.removed;
    sum.evaluations += result.evaluations;
  }
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t t : borders.triangles_near(mesh, sharing.team)) {
    vertices.insert(vertices.end(), mesh.triangles[t].v.begin(), mesh.triangles[t].v.end());
  }
  const std::uint64_t left = budget - std::min(budget, sum.evaluations);
  const ThinOutResult last = Thinner(mesh, left).run(vertices);
  return {sum.removed + last.removed, sum.evaluations + last.evaluations};
}

}  // namespace

ThinOutResult thin_out(MutableMesh& mesh, std::uint64_t budget, const Sharing& sharing) {
  if (sharing.divides(mesh)) return thin_out_in_parts(mesh, budget, sharing);
  return Thinner(mesh, budget).run();
}

}  // namespace cover
