// A hole in the triangulation: the triangles to be replaced and the loop around them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// A set of triangles that form a disk, and its loop of edges, counter-clockwise. No side lies
/// inside. Small and of fixed capacity: nothing is allocated.
class Cavity {
 public:
  static constexpr int kCapacity = 32;  ///< edges of the loop

  explicit Cavity(const MutableMesh& mesh) : mesh_(&mesh) {}
  Cavity(const Cavity& other) : mesh_(other.mesh_) { *this = other; }
  /// Most of the room is not in use, and is left as it is.
  Cavity& operator=(const Cavity& other) {
    if (this == &other) return *this;
    mesh_ = other.mesh_;
    std::copy_n(other.loop_.begin(), size_ = other.size_, loop_.begin());
    std::copy_n(other.triangles_.begin(), triangle_count_ = other.triangle_count_,
                triangles_.begin());
    std::copy_n(other.swallowed_.begin(), swallowed_count_ = other.swallowed_count_,
                swallowed_.begin());
    worst_ = other.worst_;
    return *this;
  }
  ~Cavity() = default;

  /// Begins with one triangle.
  void start(std::uint32_t t);
  /// Begins with all triangles around a free vertex, which is swallowed.
  ///
  /// ENSURES: false, and the cavity is of no use, if there are too many.
  bool start_star(std::uint32_t v);
  /// Takes in the triangle across loop edge k. A free vertex that ends up inside is swallowed.
  ///
  /// ENSURES: false, and nothing has changed, if that is a side, if the hole would no longer be a
  ///          disk, if it would swallow a fixed vertex, or if it is full.
  bool grow(int k);

  /// Whether `p`, which sees all of the loop, would still do so after grow(k).
  [[nodiscard]] bool sees_beyond(int k, Point p) const;

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] std::uint32_t vertex(int k) const { return loop_[at(k)].from; }
  [[nodiscard]] std::uint32_t outer(int k) const { return loop_[at(k)].outer; }
  [[nodiscard]] int next(int k) const { return k + 1 == size_ ? 0 : k + 1; }
  [[nodiscard]] int previous(int k) const { return k == 0 ? size_ - 1 : k - 1; }
  [[nodiscard]] int triangle_count() const { return triangle_count_; }
  [[nodiscard]] std::uint32_t triangle(int k) const { return triangles_[at(k)]; }
  [[nodiscard]] int swallowed_count() const { return swallowed_count_; }
  [[nodiscard]] std::uint32_t swallowed(int k) const { return swallowed_[at(k)]; }
  /// The largest excess among the triangles inside.
  [[nodiscard]] double worst() const { return worst_; }

 private:
  struct Edge {
    std::uint32_t from;   ///< to the `from` of the next edge
    std::uint32_t outer;  ///< the triangle or side on the right
  };
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  void take(std::uint32_t t, const double* excess);
  void erase(int k);

  const MutableMesh* mesh_;
  std::array<Edge, kCapacity> loop_;
  std::array<std::uint32_t, kCapacity> triangles_;
  std::array<std::uint32_t, kCapacity> swallowed_;
  int size_ = 0;
  int triangle_count_ = 0;
  int swallowed_count_ = 0;
  double worst_ = -kInverted;
};

/// Triangles that are to replace those of a cavity; corners are indices into the loop, or its size
/// for a new vertex.
class Patch {
 public:
  using Corner = std::array<int, 3>;

  std::optional<Point> inserted;  ///< the new vertex

  void clear() {
    count_ = 0;
    inserted.reset();
  }
  void add(int a, int b, int c) { corners_[static_cast<std::size_t>(count_++)] = {a, b, c}; }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] const Corner& corners(int k) const { return corners_[static_cast<std::size_t>(k)]; }

 private:
  std::array<Corner, 2 * Cavity::kCapacity> corners_;
  int count_ = 0;
};

/// The new triangles, for whoever has to look at them.
struct Installed {
  std::array<std::uint32_t, 2 * Cavity::kCapacity> triangles;
  int count = 0;
};

/// Replaces the triangles of `cavity` by a star around a new free vertex at `p`.
///
/// ENSURES: false, and nothing has changed, if exact arithmetic finds a triangle of the star not
///          counter-clockwise. Swallowed vertices are dropped.
bool install_star(MutableMesh& mesh, const Cavity& cavity, Point p, Installed& installed);

/// Moves the vertex that `cavity`, begun with start_star, is the star of.
///
/// ENSURES: as install_star; the triangles and the loop remain those of the cavity
bool relocate(MutableMesh& mesh, const Cavity& cavity, Point p);

/// Replaces the triangles of `cavity` by those of `patch`.
///
/// ENSURES: as install_star; false, too, if the patch has not as many triangles as fill the cavity
bool install_patch(MutableMesh& mesh, const Cavity& cavity, const Patch& patch,
                   Installed& installed);

}  // namespace cover
