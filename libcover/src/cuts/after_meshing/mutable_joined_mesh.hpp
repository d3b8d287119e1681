// A joined mesh in the form of the quality method: its sides know what lies beyond them.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <cover/pslg.hpp>

#include "cuts/cut_segments.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "quality/parts/excerpt.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"
#include "target/local_frame.hpp"

namespace cover {

/// The meshes of all regions in one, to be changed over segments, which may be cut.
///
/// Vertices are the points of the PSLG, room for as many cuts, and Steiner vertices; points and
/// triangles in the order of their coordinates, so that what is done does not depend on that of the
/// input.
class MutableJoinedMesh {
 public:
  /// REQUIRES: `boundaries` and `meshes` are of the regions of `pslg`, in their order; no hull
  ///           sides
  /// Cost:     O(n log n)
  MutableJoinedMesh(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
                    std::span<const RegionMesh> meshes, const Goal& goal);

  [[nodiscard]] const MutableMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Goal& goal() const { return goal_; }

  /// The triangles with an angle above the goal, in the order of their coordinates: it does not
  /// depend on the order of the input.
  [[nodiscard]] std::vector<std::uint32_t> triangles_above() const;

  /// The longest segments beside the region's triangles around each of triangles_above(), with
  /// those nearly as long, in order.
  [[nodiscard]] std::vector<SegmentId> segments_to_halve() const;

  /// The side on the other side of the segment; kNone: the void.
  [[nodiscard]] std::uint32_t partner(std::uint32_t s) const { return partner_[s]; }

  /// Whether the segment of side `s` may be cut where it is: periodic ones and chords of arcs may
  /// not.
  [[nodiscard]] bool is_free(std::uint32_t s) const { return is_bound_[segment_[s]] == 0; }

  [[nodiscard]] bool may_cut() const { return cuts_ < points_; }
  [[nodiscard]] bool has_changed() const { return has_changed_; }

  /// Triangles around `t`, over segments too; its spare vertex is for a cut, if there may be one.
  [[nodiscard]] Excerpt excerpt_around(std::uint32_t t, std::size_t triangles) const;

  /// Puts `improved`, made of `excerpt.mesh`, in its place. With `side`, that side of the excerpt
  /// was cut at the excerpt's spare vertex: then the sides that were added for its second half, and
  /// for that of its partner if it has one, follow all others. Returns the triangles that changed.
  std::vector<std::uint32_t> put_back(Excerpt& excerpt, const MutableMesh& improved,
                                      std::uint32_t side);

  /// The new points, by segment.
  [[nodiscard]] std::vector<SegmentCut> segment_cuts(const Pslg& pslg) const;
  /// Whether rounding on the way back to the plane turns no triangle over.
  [[nodiscard]] bool is_valid() const;
  /// The meshes of the regions, over the boundaries that `pslg` has after the cuts.
  void separate(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
                std::vector<RegionMesh>& meshes) const;

 private:
  /// A side of a region, by the vertices of the joined mesh.
  struct Side {
    IndexPair ends;
    std::uint32_t region, segment;
    SideLimit limit;
  };
  /// Makes the mesh, and joins what lies on both sides of each segment; `sides` are in order.
  void join(const Triangulation& all, std::span<const Side> sides);
  std::uint32_t add_side(std::uint32_t parent, Excerpt& excerpt);
  [[nodiscard]] std::vector<std::uint32_t> regions_of_triangles() const;
  [[nodiscard]] std::vector<std::uint32_t> ids_of_vertices(const Pslg& pslg) const;

  Goal goal_;
  std::vector<std::uint32_t> by_place_;  ///< points of the PSLG in the order of the mesh
  LocalFrame frame_;
  bool has_changed_ = false;
  std::size_t points_;  ///< of the PSLG; then come cuts, then Steiner vertices
  std::size_t first_steiner_ = 0;
  std::size_t cuts_ = 0;
  MutableMesh mesh_;
  std::vector<std::uint32_t> region_;   ///< by side: the index of its region
  std::vector<std::uint32_t> segment_;  ///< by side: the segment that it is a piece of
  std::vector<std::uint8_t> is_bound_;  ///< by segment: see is_free()
  std::vector<std::uint32_t> partner_;  ///< by side: the one on the other side; kNone: void
  std::vector<std::uint32_t> beyond_;   ///< by side: the triangle there; kNone: void
  std::vector<PointOnSegment> cut_points_;
};

}  // namespace cover
