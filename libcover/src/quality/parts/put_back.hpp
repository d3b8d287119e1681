// What became of the parts of a large mesh, in its place: for work_in_parts alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quality/mutable/mutable_mesh.hpp"
#include "quality/parts/part_in_work.hpp"

namespace cover {

/// Puts parts back into the mesh that they were cut from. A part keeps the places of its triangles
/// and free vertices. What it has more is kept apart until all are done, and goes to the end of the
/// whole, part after part; until then it is told by numbers beyond those of the whole. So each
/// writes places that are its own.
class PutBack {
 public:
  /// REQUIRES: both outlive this; `owners` says which vertices several parts have
  PutBack(MutableMesh& whole, const VertexOwners& owners)
      : whole_(whole),
        owners_(owners),
        triangles_(static_cast<std::uint32_t>(whole.triangles.size())),
        vertices_(static_cast<std::uint32_t>(whole.points.size())) {}

  /// Puts what has a place there, and the rest beside it.
  ///
  /// Threads: any, with parts of their own
  void put(PartInWork& part);
  /// Gives every part places of its own for what it has more than before, and takes those of which
  /// it has fewer. To be called once, when all parts were put back.
  void make_room(std::span<PartInWork> parts, const Team& team);
  /// Puts the rest there.
  ///
  /// Threads: as put()
  void put_extras(PartInWork& part);

 private:
  [[nodiscard]] bool is_extra_triangle(std::uint32_t t) const { return t >= triangles_; }
  std::vector<std::uint32_t> place_triangles(PartInWork& part) const;
  void place_vertices(PartInWork& part) const;
  void put_vertices(PartInWork& part, std::span<const std::uint32_t> place);
  void put_triangles(PartInWork& part, std::span<const std::uint32_t> place);
  MeshTriangle placed(PartInWork& part, std::uint32_t t, std::span<const std::uint32_t> place,
                      bool& tells_extras) const;

  MutableMesh& whole_;
  const VertexOwners& owners_;
  const std::uint32_t triangles_, vertices_;  ///< that there were at first
};

}  // namespace cover
