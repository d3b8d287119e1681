// A constrained Delaunay triangulation of all regions from which vertices are taken and to which
// they are added, and every such step can be taken back.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/numbers.hpp"
#include "cdt/search/delaunay_cavity.hpp"
#include "geom/topology/corner.hpp"
#include "mend/joined_mesh.hpp"

namespace cover {

/// What is asked of the triangles of a region.
struct WantedAngles {
  double largest_cot = 0;  ///< cotangent of the smallest angle that is allowed; 0: any
  double least_cot = 0;    ///< of the largest one, 90 degrees or more
  bool closed = false;     ///< no vertex is put among them
  /// Of an angle beyond which no triangle comes, whatever others become good for it.
  double worst_cot = -kInfinity;
};

/// Where a vertex may be put: inside of a triangle, or on its edge, which is a piece of a line.
struct Spot {
  Point at;
  std::uint32_t triangle = kNone;
  std::optional<Corner> edge = {};  ///< none: inside
};

/// The triangle that a new vertex makes with an edge of the hole around it.
struct RimEdge {
  std::uint32_t a, b;    ///< the vertex lies on the left
  std::uint32_t beyond;  ///< triangle on the right; kNone: void
  std::uint32_t line;
  std::uint32_t region;
};

/// A triangle is bad if it has an angle above what is asked of its region, above 90 degrees by more
/// than rounding of its coordinates can make; if it is obtuse by anything opposite to a piece of a
/// line, so that no coupling of the box method is negative; or if it has an angle below what is
/// asked. A mesh without obtuse angles is constrained Delaunay, and so is the mesh here, so a set
/// of vertices is good or bad by itself.
///
/// EXACT: topology is; costs and what is bad are rounded, towards bad.
class MeshWithUndo {
 public:
  /// `angles`: by region.
  /// REQUIRES: every edge with one triangle, or with triangles of two regions none of which is
  ///           closed, is a piece
  MeshWithUndo(const JoinedMesh& mesh, std::vector<WantedAngles> angles);

  struct Vertex {
    Point at;
    std::uint32_t line = JoinedMesh::kInside;
    std::uint32_t home = kNone;  ///< one of its triangles; kNone: not there
  };
  struct Triangle {
    std::array<std::uint32_t, 3> v{kNone, kNone, kNone};  ///< v[0] is kNone: not there
    std::array<std::uint32_t, 3> n{kNone, kNone, kNone};  ///< across the edge opposite to v
    std::array<std::uint32_t, 3> line{};  ///< of that edge; JoinedMesh::kInside: none
    std::uint32_t region = 0;
    float cost = 0;  ///< 0: not bad
  };

  [[nodiscard]] const std::vector<Vertex>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] Point at(std::uint32_t v) const { return vertices_[v].at; }
  [[nodiscard]] bool is_there(std::uint32_t v) const { return vertices_[v].home != kNone; }
  [[nodiscard]] bool is_movable(std::uint32_t v) const {
    return vertices_[v].line != JoinedMesh::kFixed && !only_goes(v);
  }
  [[nodiscard]] bool only_goes(std::uint32_t v) const {
    return vertices_[v].line == JoinedMesh::kMayGo;
  }
  [[nodiscard]] const std::vector<StraightLine>& lines() const { return lines_; }

  [[nodiscard]] std::size_t bad() const { return bad_; }  ///< triangles
  /// Those of them that are bad not only by the sign of an angle opposite to a piece.
  [[nodiscard]] std::size_t grave() const { return grave_; }
  [[nodiscard]] static bool is_grave(const Triangle& t);
  [[nodiscard]] std::size_t beyond_worst() const { return beyond_worst_; }  ///< triangles
  [[nodiscard]] static bool is_beyond_worst(const Triangle& t);
  [[nodiscard]] double cost() const { return cost_; }  ///< sum over bad triangles

  /// All steps up to here can be taken back together.
  [[nodiscard]] std::size_t mark() const { return journal_.size(); }
  void undo(std::size_t mark);
  /// What was done stays.
  void keep() { journal_.clear(), vertex_journal_.clear(); }
  /// The triangles that were written since `mark`, some of them more than once or not there.
  [[nodiscard]] std::vector<std::uint32_t> written_since(std::size_t mark) const;

  /// Takes a vertex away; false, and nothing has changed, if that cannot be.
  /// REQUIRES: is_movable(v) or only_goes(v)
  /// Cost:     O(k^2) for k neighbours, mostly
  bool remove(std::uint32_t v);

  /// The triangle with `p`, from `triangle` on without passing pieces. Where there is one between,
  /// the spot is on it, at the foot of `p`, if it may be cut; kNone: nowhere.
  [[nodiscard]] Spot locate(Point p, std::uint32_t triangle) const;
  /// The spot on the line of edge `edge` of `triangle` that is nearest to `p`.
  [[nodiscard]] Spot on_line(Point p, std::uint32_t triangle, Corner edge) const;

  /// By how much the cost would change with a vertex at `spot`; infinite if that cannot be. More
  /// than `most` is any number above it. The rim of the hole around it is in rim() then.
  double change_with(const Spot& spot, double most = kInfinity);
  [[nodiscard]] std::span<const RimEdge> rim() const { return rim_; }

  /// Puts a vertex there: `v`, which is not there, or a new one if that is kNone. Returns it;
  /// kNone, and nothing has changed, if that cannot be.
  std::uint32_t insert(const Spot& spot, std::uint32_t v = kNone);

  /// The mesh as it is; vertices keep their order.
  [[nodiscard]] JoinedMesh result(const JoinedMesh& before) const;

 private:
  struct Written {
    std::uint32_t triangle;
    Triangle old;
  };
  struct WrittenVertex {
    std::size_t mark;  ///< when
    std::uint32_t vertex;
    Vertex old;
  };
  struct HoleCorner {
    std::uint32_t vertex;
    std::uint32_t beyond, line;  ///< of the edge to the next corner
  };

  void link_all(const JoinedMesh& mesh);
  void make_delaunay();
  [[nodiscard]] double cost_of(const std::array<Point, 3>& p, const std::array<bool, 3>& is_piece,
                               std::uint32_t region) const;
  [[nodiscard]] double cost_of(const Triangle& t) const;
  void count(const Triangle& t);
  void discount(const Triangle& t);
  void write(std::uint32_t t, const Triangle& value);
  void save_vertex(std::uint32_t v);
  std::uint32_t new_triangle();
  void free_triangle(std::uint32_t t);
  void link(std::uint32_t beyond, std::uint32_t a, std::uint32_t b, std::uint32_t t);
  bool gather(const Spot& spot);
  [[nodiscard]] std::array<std::uint32_t, 2> ends_of(const Spot& spot) const;
  bool star_of(std::uint32_t v);
  [[nodiscard]] bool cuts_line(std::uint32_t v) const { return vertices_[v].line < lines_.size(); }
  bool turn_star_to_line(std::uint32_t v);
  std::size_t take_part(std::uint32_t v, std::size_t k);
  [[nodiscard]] std::uint32_t triangle_at_piece(std::span<const std::uint32_t> triangles,
                                                std::uint32_t a, std::uint32_t b,
                                                std::uint32_t line) const;
  bool fill(std::span<HoleCorner> corners, std::uint32_t region, std::vector<std::uint32_t>& slots);
  [[nodiscard]] bool is_ear(std::span<const HoleCorner> corners, std::size_t k,
                            bool delaunay) const;

  std::vector<WantedAngles> angles_;
  std::vector<StraightLine> lines_;
  std::vector<Vertex> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> free_;  ///< triangles, some of them not free any more
  std::vector<Written> journal_;
  std::vector<WrittenVertex> vertex_journal_;
  std::size_t bad_ = 0, grave_ = 0, beyond_worst_ = 0;
  double cost_ = 0;

  // Of the last hole or star.
  std::vector<RimEdge> rim_;
  DelaunayCavity cavity_;
  std::vector<std::uint32_t> star_;
  std::vector<HoleCorner> corners_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace cover
