#include "quality/mutable/delaunay_flips.hpp"

#include <atomic>

#include "geom/predicates.hpp"

namespace cover {

namespace {

/// Whether edge i of `t`, if it is no side, has a negative coupling.
bool is_negative(const MutableMesh& mesh, std::uint32_t t, Corner i) {
  const std::uint32_t u = mesh.triangles[t].n[i];
  const std::uint32_t from = mesh.triangles[t].v[i.previous()];
  return in_circle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2),
                   mesh.corner(u, mesh.triangles[u].edge_from(from))) == Sign::positive;
}

/// The first triangle with a negative coupling to a later one, or how many triangles there are.
std::uint32_t first_negative(const MutableMesh& mesh, const Team& team) {
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::atomic<std::uint32_t> least = count;
  team.each_range(count, kFewAtATime, [&](std::size_t first, std::size_t last) {
    for (auto t = static_cast<std::uint32_t>(first); t < last && t < least; ++t) {
      if (mesh.is_hole(t)) continue;
      for (const Corner i : kCorners) {
        const std::uint32_t u = mesh.triangles[t].n[i];
        if (is_side(u) || u < t || !is_negative(mesh, t, i)) continue;
        std::uint32_t other = least;
        while (t < other && !least.compare_exchange_weak(other, t)) {
        }
      }
    }
  });
  return least;
}

class Flips {
 public:
  explicit Flips(MutableMesh& mesh) : mesh_(mesh) {}

  /// Flips one edge of `t`, if it has to be, among those to triangles from `first` on, and what
  /// that entails.
  void flip_from(std::uint32_t t, std::uint32_t first) {
    flip_one(t, first);
    while (!stack_.empty()) {
      const std::uint32_t changed = stack_.back();
      stack_.pop_back();
      flip_one(changed, 0);
    }
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  void flip_one(std::uint32_t t, std::uint32_t first) {
    for (const Corner i : kCorners) {
      const std::uint32_t u = mesh_.triangles[t].n[i];
      if (is_side(u) || u < first || !is_negative(mesh_, t, i) || !mesh_.flip(t, i)) continue;
      ++count_;
      stack_.push_back(t);
      stack_.push_back(u);
      return;
    }
  }

  MutableMesh& mesh_;
  std::vector<std::uint32_t> stack_;
  std::size_t count_ = 0;
};

}  // namespace

std::size_t make_delaunay(MutableMesh& mesh, const Team& team) {
  Flips flips(mesh);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  const std::uint32_t begin = team.workers() > 1 ? first_negative(mesh, team) : 0;
  for (std::uint32_t t = begin; t < count; ++t) {
    if (!mesh.is_hole(t)) flips.flip_from(t, t);
  }
  return flips.count();
}

std::size_t make_delaunay(MutableMesh& mesh, std::span<const std::uint32_t> triangles) {
  Flips flips(mesh);
  for (const std::uint32_t t : triangles) flips.flip_from(t, 0);
  return flips.count();
}

}  // namespace cover
