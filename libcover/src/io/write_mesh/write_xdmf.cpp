// XDMF with the numbers inside the XML: no HDF5 file, no library. Two grids, because dolfinx reads
// the triangles from one and the tags of edges from another; it takes the first attribute of each.
//
// Tested by tests/unit/io/write_mesh/write_xdmf_test.cpp and, in dolfinx, by tests/solvers.
#include <cover/mesh_view.hpp>
#include <cover/text.hpp>
#include "io/files/text_writer.hpp"

namespace cover {
namespace {

class XdmfWriter {
 public:
  XdmfWriter(const MeshView& view, TextWriter& out) : view_(view), out_(out) {}

  void write() {
    out_ << "<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n"
            "<Xdmf Version=\"3.0\">\n<Domain>\n";
    begin_grid("mesh", view_.second_order() ? "Triangle_6" : "Triangle", view_.triangles);
    // dolfinx takes the first.
    const bool groups_first = view_.has_ids;
    if (groups_first) group_attribute();
    attribute("MaterialID", view_.triangles, [&](std::size_t t) { return view_.material[t]; });
    attribute("RegionId", view_.triangles, [&](std::size_t t) { return view_.region[t].value(); });
    if (!groups_first) group_attribute();
    end_grid(view_.region_groups);
    begin_grid("lines", view_.second_order() ? "Edge_3" : "PolyLine", view_.lines);
    attribute("LineID", view_.lines, [&](std::size_t l) { return view_.group_of_line(l).tag; });
    attribute("Marker", view_.lines, [&](std::size_t l) { return view_.marker[l]; });
    end_grid(view_.line_groups);
    out_ << "</Domain>\n</Xdmf>\n";
  }

 private:
  void begin_grid(std::string_view name, std::string_view type, const Cells& cells) {
    out_ << "<Grid Name=\"" << name << "\" GridType=\"Uniform\">\n<Topology TopologyType=\"" << type
         << "\" NumberOfElements=\"" << cells.size() << "\" NodesPerElement=\"" << cells.nodes_each
         << "\">\n";
    begin_numbers(cells.size(), cells.nodes_each, "Int");
    for (std::size_t k = 0; k < cells.size(); ++k) {
      for (const std::uint32_t node : cells[k]) out_ << node << ' ';
      out_ << '\n';
    }
    out_ << "</DataItem>\n</Topology>\n<Geometry GeometryType=\"XY\">\n";
    begin_numbers(view_.points.size(), 2, "Float");
    for (const Point& p : view_.points) out_ << p.x << ' ' << p.y << '\n';
    out_ << "</DataItem>\n</Geometry>\n";
  }

  void group_attribute() {
    attribute("GroupID", view_.triangles,
              [&](std::size_t t) { return view_.group_of_triangle(t).tag; });
  }

  /// Names with their numbers, for people and scripts; readers skip them.
  void end_grid(const std::vector<Group>& groups) {
    for (const Group& group : groups)
      out_ << "<Information Name=\"" << escaped_markup(group.label) << "\" Value=\"" << group.tag
           << "\"/>\n";
    out_ << "</Grid>\n";
  }

  template <class Value>
  void attribute(std::string_view name, const Cells& cells, Value value) {
    out_ << "<Attribute Name=\"" << name << "\" AttributeType=\"Scalar\" Center=\"Cell\">\n";
    begin_numbers(cells.size(), 1, "Int");
    for (std::size_t k = 0; k < cells.size(); ++k) out_ << value(k) << '\n';
    out_ << "</DataItem>\n</Attribute>\n";
  }

  void begin_numbers(std::size_t rows, std::size_t columns, std::string_view type) {
    out_ << "<DataItem Dimensions=\"" << rows << ' ' << columns << "\" NumberType=\"" << type
         << "\" Precision=\"8\" Format=\"XML\">\n";
  }

  const MeshView& view_;
  TextWriter& out_;
};

}  // namespace

Status write_xdmf(const Output& output, const std::string& path, const WriteOptions& options) {
  const MeshView view = view_of(output, options);
  return write_text(path, options.stop, [&](TextWriter& out) { XdmfWriter(view, out).write(); });
}

}  // namespace cover
