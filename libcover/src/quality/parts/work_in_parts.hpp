// A large mesh as parts that are worked on apart, at the same time.
//
// The parts depend on the mesh alone, never on who works on them, and each is a mesh of its own,
// whose border is locked: nothing is shared, and what comes out is the same for any number of
// threads. What the borders were in the way of is done afterwards.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "base/team.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Who works on a mesh, and how large parts are.
struct Sharing {
  Team team{};
  std::size_t part_size = 50'000;  ///< triangles: some tenths of a second of work, half a cache
  std::stop_token stop{};          ///< once requested, work ends early, and the mesh is of no use

  [[nodiscard]] bool divides(const MutableMesh& mesh) const {
    return mesh.triangle_count() >= 2 * part_size;
  }
};

/// A part of a mesh, for whoever works on it.
struct Part {
  MutableMesh mesh;  ///< see MutableMesh::part_of()
  /// By triangle and by vertex of `mesh`: places in the whole. While it is worked on, of those
  /// that it had at first; kNone for holes.
  std::vector<std::uint32_t> triangles, vertices;
  bool tells_places = false;  ///< to be set by whoever needs these when it is done
  /// Sides of `mesh` from this one on are edges to other parts.
  std::uint32_t first_border = 0;
  std::size_t index = 0;
};

/// The triangles near the borders of parts, as places in the whole.
struct Borders {
  std::vector<std::uint32_t> triangles;  ///< with an edge to another part
  std::vector<std::uint32_t> vertices;   ///< of such edges, sorted

  /// The triangles with such a vertex, and those beside them, sorted.
  [[nodiscard]] std::vector<std::uint32_t> triangles_near(const MutableMesh& whole,
                                                          const Team& team = {}) const;
};

/// How many parts a mesh has at the most.
std::size_t part_count(const MutableMesh& whole, const Sharing& sharing);

/// Divides `whole` into parts (part_labels.hpp), calls `work` with every part, and puts in place
/// what it has made of Part::mesh. Parts that wait once a stop is requested stay as they are.
/// `done` is called with every part in turn whose places were asked for, which are now those that
/// it has.
///
/// Memory: the parts that are worked on, and of the others what they have more than at first.
///
/// `work` may change the mesh by whatever keeps its sides; with inner couplings it makes none worse
/// across a border than they may be together.
///
/// REQUIRES: sharing.divides(whole)
/// ENSURES:  the same result for any team
/// Cost:     O(triangles) for cutting and putting back: some 0.1 us each
/// Threads:  `work` runs in several threads at a time
Borders work_in_parts(MutableMesh& whole, const Sharing& sharing,
                      const std::function<void(Part&)>& work,
                      const std::function<void(const Part&)>& done = {});

}  // namespace cover
