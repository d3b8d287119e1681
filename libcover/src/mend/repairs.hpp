// Changes of a mesh near one place that stay only if nothing is worse afterwards.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "mend/mesh_with_undo.hpp"
#include "mend/place_search.hpp"

namespace cover {

inline constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

/// How many triangles may be bad in some way.
struct MostBad {
  std::size_t bad = 0;
  std::size_t grave = 0;                  ///< MeshWithUndo::grave()
  std::size_t by_sign_only = kAnyNumber;  ///< all others that are bad
  std::size_t beyond_worst = 0;           ///< MeshWithUndo::beyond_worst()

  /// Those that are: the mesh may not become worse.
  static MostBad in(const MeshWithUndo& mesh) {
    return {mesh.bad(), mesh.grave(), kAnyNumber, mesh.beyond_worst()};
  }
};

/// How many vertices come in place of some that went, and in how many steps.
struct Others {
  int count = 0;
  int steps = 0;
};

/// Ruin and recreate: a few vertices that are near each other are taken away, others are put there,
/// and vertices around are moved until no more triangles are bad than may be. All that changes the
/// mesh returns whether that came about; else the mesh is as it was at the last keep(). What came
/// about stays for good with the next keep(), which is the caller's.
///
/// ENSURES: the same mesh for the same input, whatever the machine
class Repairs {
 public:
  Repairs(MeshWithUndo& mesh, PlacesLeft left)
      : mesh_(mesh), left_(std::move(left)), places_(mesh, left_) {}
  Repairs(const Repairs&) = delete;
  Repairs& operator=(const Repairs&) = delete;

  [[nodiscard]] MeshWithUndo& mesh() { return mesh_; }
  [[nodiscard]] PlacesLeft& left() { return left_; }
  [[nodiscard]] Random& random() { return random_; }

  [[nodiscard]] bool is_bad(std::uint32_t t) const;
  [[nodiscard]] bool is_grave(std::uint32_t t) const;
  [[nodiscard]] bool is_beyond_worst(std::uint32_t t) const;
  /// Whether triangle `t` is bad, but not gravely, by a vertex inside from which a piece is seen at
  /// more than a right angle.
  [[nodiscard]] bool is_bad_by_a_movable(std::uint32_t t) const;

  /// Without `v`.
  bool without(std::uint32_t v, const MostBad& most);
  /// With more vertices near bad triangle `t`: one, then ever more, so many times.
  ///
  /// REQUIRES: tries <= effort::mend::kMostTries
  bool with_more_vertices(std::uint32_t t, const MostBad& most, std::size_t tries);
  /// Without vertices around `t`, the one that helps most each time.
  bool with_fewer_vertices(std::uint32_t t, const MostBad& most);
  /// With others in place of some vertices near `t`, again and again, for so many places; false at
  /// once where none near it can be put elsewhere, as between two arcs.
  bool with_other_vertices(std::uint32_t t, const MostBad& most, std::uint64_t places);
  /// With pieces cut at the feet of the blunt corners opposite to them, then of what that makes
  /// blunt, and so on: through thin layers, wall by wall, to where there is room.
  bool with_cuts(std::uint32_t t, const MostBad& most);

  /// With others in place of those of `vertices` that can be taken away. `others_for` says how many
  /// come in place of so many, and is not asked if none can.
  bool with_others_in_place_of(std::span<const std::uint32_t> vertices, const MostBad& most,
                               const std::function<Others(int taken)>& others_for);

  /// `v` and those nearest to it that may be moved, `count` at most.
  std::vector<std::uint32_t> near(std::uint32_t v, std::size_t count);

 private:
  [[nodiscard]] bool is_fine(const MostBad& most) const;
  [[nodiscard]] std::optional<Corner> corner_over_a_piece(std::uint32_t t) const;
  [[nodiscard]] bool is_near_a_movable(std::uint32_t t) const;
  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t v) const;
  void begin_at(std::uint32_t t);
  bool take(std::uint32_t v);
  bool repair(int more, int steps, const MostBad& most);
  bool apply(const VertexPlace& placement, int& more);
  std::uint32_t a_bad_triangle();
  std::optional<Spot> foot_of_a_blunt_corner();
  [[nodiscard]] std::vector<std::uint32_t> removable_around(std::uint32_t t) const;
  std::uint32_t most_helpful_removal(std::uint32_t t);

  MeshWithUndo& mesh_;
  PlacesLeft left_;
  PlaceSearch places_;
  Random random_;
  std::uint32_t focus_ = kNone;        ///< a triangle that is to be mended
  std::vector<std::uint32_t> spares_;  ///< vertices that were taken away
  std::vector<Point> starts_;          ///< where they had been
  std::vector<std::uint32_t> stay_;    ///< vertices that were moved in the last steps
  std::vector<std::uint32_t> bad_;
};

}  // namespace cover
