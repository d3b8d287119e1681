// Where a vertex is best put: the elementary step of all that changes a mesh by its vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "base/numbers.hpp"
#include "mend/mesh_with_undo.hpp"

namespace cover {

/// Places that may still be tried, some 0.5 us each.
struct PlacesLeft {
  std::uint64_t count = 0;
  std::stop_token stop{};

  void spend(std::uint64_t places) { count -= std::min(count, places); }
  [[nodiscard]] bool is_over() const { return count == 0 || stop.stop_requested(); }
};

/// What a vertex that is taken away costs, in places.
constexpr std::uint64_t kRemoval = 4;

/// A vertex put somewhere.
struct VertexPlace {
  double cost = kInfinity;       ///< of the mesh then
  std::uint32_t vertex = kNone;  ///< that is moved; kNone: one is added
  Spot spot{};
};

/// Places are found by projections: a vertex is good on the rim of its hole if it lies between the
/// perpendiculars at the ends of every edge and outside of its diametral disk.
class PlaceSearch {
 public:
  PlaceSearch(MeshWithUndo& mesh, PlacesLeft& left) : mesh_(mesh), left_(left) {}

  /// A new vertex, near bad triangle `t` or on its pieces; from `starts`, too.
  void add_one(std::uint32_t t, std::span<const Point> starts, VertexPlace& best);
  /// A corner of `t` or of its neighbours moved, but none in `stays`.
  void move_one(std::uint32_t t, std::span<const std::uint32_t> stays, VertexPlace& best);

 private:
  [[nodiscard]] std::vector<Point> starts_around(std::uint32_t t) const;
  [[nodiscard]] std::vector<std::uint32_t> movers(std::uint32_t t) const;
  void try_all(std::span<const Point> starts, std::uint32_t from, std::uint32_t vertex,
               VertexPlace& best);
  void try_on_line(std::span<const Point> starts, std::uint32_t line, std::size_t mark,
                   std::uint32_t vertex, VertexPlace& best);
  void improve(Spot spot, std::uint32_t vertex, VertexPlace& best);
  [[nodiscard]] Point projected(const Spot& spot) const;
  [[nodiscard]] std::uint32_t a_triangle_written_since(std::size_t mark) const;

  MeshWithUndo& mesh_;
  PlacesLeft& left_;
};

}  // namespace cover
