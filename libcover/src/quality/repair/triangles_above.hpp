// Triangles with an angle above a goal, one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "quality/fault/merit.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Those that there are at first, then those that change into some, in the order in which they are
/// added.
class TrianglesAbove {
 public:
  /// REQUIRES: `mesh` and `goal` outlive this
  TrianglesAbove(const MutableMesh& mesh, const Goal& goal, std::vector<std::uint32_t> first)
      : mesh_(mesh), goal_(goal), queue_(std::move(first)) {}
  TrianglesAbove(const MutableMesh& mesh, const Goal& goal) : mesh_(mesh), goal_(goal) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) add(t);
  }

  [[nodiscard]] bool empty() const { return head_ == queue_.size(); }
  /// The next one; none if it is above the goal no more.
  ///
  /// REQUIRES: not empty
  std::optional<std::uint32_t> next() {
    const std::uint32_t t = queue_[head_++];
    return is_above(mesh_, t, goal_) ? std::optional(t) : std::nullopt;
  }
  void add(std::span<const std::uint32_t> changed) {
    for (const std::uint32_t t : changed) add(t);
  }

 private:
  void add(std::uint32_t t) {
    if (is_above(mesh_, t, goal_)) queue_.push_back(t);
  }

  const MutableMesh& mesh_;
  const Goal& goal_;
  std::vector<std::uint32_t> queue_;
  std::size_t head_ = 0;
};

}  // namespace cover
