// A part of a triangulation, to be changed on trial at a cost that does not depend on the whole.
#pragma once

#include <cstdint>
#include <vector>

#include "quality/mutable_mesh.hpp"

namespace cover {

/// Some triangles around one of them, as a mesh of its own whose border is locked.
///
/// Triangle 0 is the one in the middle. What an improvement makes of `mesh`, whatever its goal, can
/// be put in place of these triangles, as long as the whole has not changed there.
class Excerpt {
 public:
  /// REQUIRES: `t` is no hole
  /// Cost:     O(`limit`), the number of triangles, if there are so many
  Excerpt(const MutableMesh& whole, std::uint32_t t, std::size_t limit);

  MutableMesh mesh;

  /// Puts `part`, made from a copy of `mesh`, in place of these triangles.
  ///
  /// ENSURES: the places in `whole` that its triangles have now, whose excess is that by the goal
  ///          of the whole. The excerpt is of no use any more.
  std::vector<std::uint32_t> replace(MutableMesh& whole, const MutableMesh& part) const;

 private:
  std::vector<std::uint32_t> triangles_;  ///< by local triangle: its place in the whole
  std::vector<std::uint32_t> vertices_;   ///< by local vertex: its place in the whole
  std::vector<std::uint32_t> outside_;    ///< by local side: what is beyond it in the whole
};

}  // namespace cover
