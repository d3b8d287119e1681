// What all .msh files have, whether of a whole mesh or of a part: names, entities, heads of blocks
// and of data.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <cover/mesh_view.hpp>

#include "base/containers/buckets.hpp"
#include "geom/box.hpp"
#include "io/files/text_writer.hpp"
#include "io/write_mesh/cell_source.hpp"

namespace cover {

/// Sections of gmsh's format, and lines of them. Numbers are those of the file, from 1 on.
class MshSections {
 public:
  /// All outlive this object.
  MshSections(const MeshView& view, const CellSource& cells, const RegionTable& table,
              TextWriter& out)
      : view_(view), cells_(cells), table_(table), out_(out) {}

 protected:
  /// Format, names and entities of 4.1; `curves`: lines by their groups.
  void head_4(const Buckets& curves);
  /// Names of the groups that have elements.
  void names();
  /// The head of a block of elements of 4.1.
  void block(int dimension, int tag, int type, std::size_t cells);
  /// The head of values at nodes or elements: the time 0, the step 0, one number for each.
  void begin_data(std::string_view of, const std::string& name, std::size_t count);

  void coordinates(const Point& p) { out_ << p.x << ' ' << p.y << " 0\n"; }
  /// The nodes of an element, to the end of its line.
  void nodes(std::span<const std::uint32_t> nodes);
  void corners(const Box& box);

  [[nodiscard]] bool second_order() const { return view_.lines.nodes_each == 3; }
  static constexpr int kPointType = 15;
  [[nodiscard]] int line_type() const { return second_order() ? 8 : 1; }
  [[nodiscard]] int triangle_type() const { return second_order() ? 9 : 2; }
  [[nodiscard]] std::size_t used_surfaces() const;
  static std::size_t used(const Buckets& entities);
  /// The region on the line's left; kVoid for a side of the hull.
  [[nodiscard]] RegionId region_of_line(std::size_t l) const;

  const MeshView& view_;
  const CellSource& cells_;
  const RegionTable& table_;
  TextWriter& out_;

 private:
  void name(int dimension, const Group& group);
  /// Tag, bounding box, physical group; not what bounds it.
  void entity(int tag, const Box& box);
  /// One for each group, at its first point.
  void point_entities();
  void curve_entities(const Buckets& members);
};

}  // namespace cover
