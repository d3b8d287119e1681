// A part of a triangulation, to be changed on trial at a cost that does not depend on the whole.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// The triangles nearest to `t`, by the number of edges between: `most` of them, if there are so
/// many. With `beyond`, by side: the triangle on the other side of its segment, or kNone, also over
/// sides.
std::vector<std::uint32_t> triangles_around(const MutableMesh& whole, std::uint32_t t,
                                            std::size_t most,
                                            std::span<const std::uint32_t> beyond = {});

/// Some triangles around one of them, as a mesh of its own whose border is locked.
///
/// Triangle 0 is the one in the middle. What an improvement makes of `mesh`, whatever its goal, can
/// be put in place of these triangles, as long as the whole has not changed there.
class Excerpt {
 public:
  /// These are triangles_around(). `spare` is a fixed vertex of the whole that no triangle has yet.
  ///
  /// REQUIRES: `t` is no hole
  /// Cost:     O(`most`), the number of triangles, if there are so many
  Excerpt(const MutableMesh& whole, std::uint32_t t, std::size_t most,
          std::span<const std::uint32_t> beyond = {}, std::uint32_t spare = kNone);

  MutableMesh mesh;

  /// By side of `mesh`: the triangle or side of the whole that it stands for. Sides that are added
  /// to a copy of `mesh` are to be added here before it is put back.
  std::vector<std::uint32_t> outside;
  /// The vertex of `mesh` that is the spare one.
  std::uint32_t spare = kNone;

  /// Puts `improved`, made from a copy of `mesh`, in place of these triangles.
  ///
  /// ENSURES: the places in `whole` that its triangles have now, whose excess is that by the goal
  ///          of the whole. The excerpt is of no use any more.
  std::vector<std::uint32_t> replace(MutableMesh& whole, const MutableMesh& improved) const;

 private:
  std::vector<std::uint32_t> triangles_;  ///< by local triangle: its place in the whole
  std::vector<std::uint32_t> vertices_;   ///< by local vertex: its place in the whole
};

}  // namespace cover
