// A mesh on the disk, in the pieces in which it was made.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <cover/point.hpp>
#include <cover/result.hpp>

#include "geom/topology/half_edges.hpp"
#include "io/files/spool_file.hpp"

namespace cover {

/// The triangles of regions, in a spool file.
/// Memory: 16 bytes for each region.
///
/// Vertices are numbered as in a Mesh: those of the input first, then the Steiner vertices of each
/// region. The numbers of the latter are known when all regions are there; until then, each region
/// counts its own from the last one of the input on.
class MeshSpool {
 public:
  /// `input` are the vertices that are points of the input.
  ///
  /// Errors: cannot_write, in the name of `target`
  static Result<MeshSpool> beside(const std::string& target, std::span<const Point> input,
                                  std::size_t regions);
  /// For some regions of a mesh with so many vertices of the input, which another spool has.
  static Result<MeshSpool> without_input(const std::string& target, std::size_t input_vertices,
                                         std::size_t regions);

  /// Adds a region, whose numbers of Steiner vertices begin with input_vertices().
  ///
  /// Threads: any, each with regions of its own
  void add(std::size_t region, std::span<const Point> steiner,
           std::span<const IndexTriple> triangles, std::span<const std::array<double, 2>> angles);
  /// Notes a region that is in another spool.
  ///
  /// Threads: as add()
  void add_elsewhere(std::size_t region, std::uint32_t steiner, std::uint32_t triangles) {
    places_[region] = {kElsewhere, steiner, triangles};
  }
  /// False once a region could not be added: then no more need be made.
  [[nodiscard]] bool is_good() const { return file_.is_good(); }
  /// Errors: cannot_write, for what an add() met
  [[nodiscard]] Status status() const { return file_.status(); }
  /// All regions are there.
  ///
  /// Errors: cannot_write, for what an add() met
  Status finish();

  // What there is, once it is finished.

  [[nodiscard]] std::size_t regions() const { return places_.size(); }
  [[nodiscard]] std::size_t input_vertices() const { return input_vertices_; }
  [[nodiscard]] bool has_input() const { return has_input_; }
  [[nodiscard]] bool has(std::size_t region) const { return places_[region].at != kElsewhere; }
  [[nodiscard]] bool has_all() const;
  [[nodiscard]] std::size_t vertices() const { return vertices_; }
  [[nodiscard]] std::size_t triangles() const { return triangles_; }
  [[nodiscard]] std::size_t triangles(std::size_t region) const {
    return places_[region].triangles;
  }
  [[nodiscard]] std::size_t steiner(std::size_t region) const { return places_[region].steiner; }
  /// The numbers of triangles before each region's; one more than there are regions.
  [[nodiscard]] std::vector<std::uint64_t> first_triangles() const;

  // Passes over the file, in the order of a Mesh. Errors of all: cannot_write
  // REQUIRES: has_all()

  using Points = std::function<void(std::span<const Point>)>;
  using Corners = std::function<void(std::size_t region, std::span<const IndexTriple>)>;
  using Angles = std::function<void(std::span<const double>)>;

  /// The vertices, some at a time.
  Status each_vertex(const Points& use) const;
  /// The triangles, region by region.
  Status each_triangle(const Corners& use) const;
  /// Those of some regions, in this order.
  Status triangles_of(std::span<const std::uint32_t> regions, const Corners& use) const;
  /// The largest angles of the triangles, or the smallest ones.
  Status each_angle(bool largest, const Angles& use) const;

  // Of the input alone.
  // REQUIRES: has_input()

  Status each_input_vertex(const Points& use) const;
  [[nodiscard]] Result<std::vector<Point>> input_points() const;

  // Some of what one region has, from its `first` on. Errors of all: cannot_write
  // REQUIRES: has(region); of what it has, there is as much

  Status read_steiner(std::size_t region, std::size_t first, std::span<Point> out) const;
  /// Steiner vertices get numbers from `first_steiner` on.
  Status read_corners(std::size_t region, std::uint32_t first_steiner, std::size_t first,
                      std::span<IndexTriple> out) const;
  Status read_angles(std::size_t region, bool largest, std::size_t first,
                     std::span<double> out) const;

 private:
  MeshSpool(SpoolFile file, std::size_t input, std::size_t regions)
      : file_(std::move(file)), input_vertices_(input), places_(regions) {}

  static constexpr std::uint64_t kElsewhere = ~std::uint64_t{0};

  /// Of a region: Steiner vertices, corners, largest angles, smallest angles.
  struct Place {
    std::uint64_t at = kElsewhere;
    std::uint32_t steiner = 0;
    std::uint32_t triangles = 0;
  };

  Status corners_of(std::size_t region, std::uint32_t first_steiner,
                    std::vector<IndexTriple>& room) const;

  SpoolFile file_;
  bool has_input_ = true;
  std::size_t input_vertices_ = 0;
  std::vector<Place> places_;
  std::vector<std::uint32_t> first_steiner_;  ///< by region, once finished
  std::size_t vertices_ = 0, triangles_ = 0;
};

}  // namespace cover
