// XDMF, with the numbers inside the XML, which asks for no library, or in an HDF5 file beside it,
// as large meshes want it. Two grids, because dolfinx reads the triangles from one and the tags of
// edges from another; it takes the first attribute of each, and looks for X.h5 beside X.xdmf
// whatever stands in the XML.
//
// Tested by tests/unit/io/write_mesh/solver_formats/write_xdmf_test.cpp, with arrays of the input
// by tests/unit/io/read_mesh/carried_arrays_test.cpp and, in dolfinx, by tests/solvers.
#include <array>
#include <filesystem>

#include <fmt/core.h>

#include <cover/mesh_view.hpp>
#include <cover/text.hpp>

#include "base/content_hash.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/text_writer.hpp"
#include "io/hdf5/hdf5_writer.hpp"
#include "io/text/array_names.hpp"
#include "io/write_mesh/check_format.hpp"
#include "io/write_mesh/solver_formats/xdmf_file.hpp"

namespace cover {
namespace {

/// The arrays of a file.
struct Item {
  enum Kind {
    nodes,
    places,
    group,
    material,
    region,
    line_nodes,
    line_group,
    line_marker,
    attribute,  ///< the k-th of MeshView::attributes
    field       ///< the k-th of MeshView::fields
  };
  Kind kind;
  std::size_t k = 0;
};

/// The XML; where the numbers are, is for others to say.
class XdmfWriter {
 public:
  /// `view`: as XdmfSource::view.
  XdmfWriter(const MeshView& view, std::size_t points, std::size_t triangles,
             std::size_t nodes_each, TextWriter& out)
      : view_(view), points_(points), triangles_(triangles), nodes_each_(nodes_each), out_(out) {}
  XdmfWriter(const XdmfWriter&) = delete;
  XdmfWriter& operator=(const XdmfWriter&) = delete;
  virtual ~XdmfWriter() = default;

  /// The grids; end() ends the file.
  void write() {
    out_ << "<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n"
            "<Xdmf Version=\"3.0\">\n<Domain>\n";
    begin_grid("mesh", nodes_each_ == 6 ? "Triangle_6" : "Triangle", triangles_, nodes_each_,
               {Item::nodes});
    // dolfinx takes the first.
    const bool groups_first = view_.has_ids;
    if (groups_first) attribute("GroupID", triangles_, {Item::group});
    attribute("MaterialID", triangles_, {Item::material});
    attribute("RegionId", triangles_, {Item::region});
    if (!groups_first) attribute("GroupID", triangles_, {Item::group});
    for (std::size_t k = 0; k < view_.attributes.size(); ++k)
      attribute(view_.attributes[k].name, triangles_, {Item::attribute, k});
    for (std::size_t k = 0; k < view_.fields.size(); ++k)
      attribute(view_.fields[k].name, points_, {Item::field, k});
    end_grid(view_.region_groups);
    const std::size_t lines = view_.lines.size(), each = view_.lines.nodes_each;
    begin_grid("lines", each == 3 ? "Edge_3" : "PolyLine", lines, each, {Item::line_nodes});
    attribute("LineID", lines, {Item::line_group});
    attribute("Marker", lines, {Item::line_marker});
    end_grid(view_.line_groups);
  }
  void end() { out_ << "</Domain>\n</Xdmf>\n"; }
  /// Tells readers whether a file with the numbers is the one that was written with this one.
  void put_hash(const ContentHash& of_numbers) {
    out_ << "<Information Name=\"" << kXdmfHash << "\" Value=\"" << of_numbers.text() << "\"/>\n";
  }

 protected:
  /// How an item says where its numbers are: Precision and Format.
  [[nodiscard]] virtual std::string attributes(Item item) const = 0;
  /// What stands in it.
  virtual void content(Item item, std::size_t rows, std::size_t columns) = 0;

  TextWriter& out() { return out_; }
  [[nodiscard]] const MeshView& view() const { return view_; }

  /// Numbers of words are whole, as are those of groups.
  [[nodiscard]] bool is_real(Item item) const {
    return item.kind == Item::places || item.kind == Item::field ||
           (item.kind == Item::attribute && !view_.attributes[item.k].is_text);
  }
  /// What a triangle has of an attribute.
  [[nodiscard]] double of_triangle(const Attribute& attribute, std::size_t t) const {
    return attribute.values[place_of(view_.region[t])];
  }

 private:
  void begin_grid(std::string_view name, std::string_view type, std::size_t cells, std::size_t each,
                  Item nodes) {
    out_ << "<Grid Name=\"" << name << "\" GridType=\"Uniform\">\n<Topology TopologyType=\"" << type
         << "\" NumberOfElements=\"" << cells << "\" NodesPerElement=\"" << each << "\">\n";
    numbers(nodes, cells, each, "Int");
    out_ << "</Topology>\n<Geometry GeometryType=\"XY\">\n";
    numbers({Item::places}, points_, 2, "Float");
    out_ << "</Geometry>\n";
  }

  /// Names with their numbers, for people and scripts; readers skip them.
  void end_grid(const std::vector<Group>& groups) {
    for (const Group& group : groups)
      out_ << "<Information Name=\"" << escaped_markup(group.label) << "\" Value=\"" << group.tag
           << "\"/>\n";
    out_ << "</Grid>\n";
  }

  void attribute(std::string_view name, std::size_t rows, Item item) {
    out_ << "<Attribute Name=\"" << escaped_markup(name) << "\" AttributeType=\"Scalar\" Center=\""
         << (item.kind == Item::field ? "Node" : "Cell") << "\">\n";
    numbers(item, rows, 1, is_real(item) ? "Float" : "Int");
    out_ << "</Attribute>\n";
  }

  void numbers(Item item, std::size_t rows, std::size_t columns, std::string_view type) {
    out_ << "<DataItem Dimensions=\"" << rows << ' ' << columns << "\" NumberType=\"" << type
         << "\" " << attributes(item) << '>';
    content(item, rows, columns);
    out_ << "</DataItem>\n";
  }

  const MeshView& view_;
  std::size_t points_, triangles_, nodes_each_;
  TextWriter& out_;
};

/// Numbers inside the XML.
class InlineXdmf final : public XdmfWriter {
 public:
  InlineXdmf(const MeshView& view, TextWriter& out)
      : XdmfWriter(view, view.points.size(), view.triangles.size(), view.triangles.nodes_each,
                   out) {}

 private:
  [[nodiscard]] std::string attributes(Item) const override {
    return "Precision=\"8\" Format=\"XML\"";
  }

  void content(Item item, std::size_t rows, std::size_t) override {
    const MeshView& mesh = view();
    out() << '\n';
    switch (item.kind) {
      case Item::nodes:
        return nodes(mesh.triangles);
      case Item::line_nodes:
        return nodes(mesh.lines);
      case Item::places:
        for (const Point& p : mesh.points) out() << p.x << ' ' << p.y << '\n';
        return;
      case Item::group:
        return values(rows, [&](std::size_t t) { return mesh.group_of_triangle(t).tag; });
      case Item::material:
        return values(rows, [&](std::size_t t) { return mesh.material[t]; });
      case Item::region:
        return values(rows, [&](std::size_t t) { return mesh.region[t].value(); });
      case Item::line_group:
        return values(rows, [&](std::size_t l) { return mesh.group_of_line(l).tag; });
      case Item::line_marker:
        return values(rows, [&](std::size_t l) { return mesh.marker[l]; });
      case Item::attribute:
        return values(rows, [&](std::size_t t) { return of_triangle(mesh.attributes[item.k], t); });
      case Item::field:
        return values(rows, [&](std::size_t p) { return mesh.fields[item.k].values[p]; });
    }
  }

  void nodes(const Cells& cells) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      for (const std::uint32_t node : cells[k]) out() << node << ' ';
      out() << '\n';
    }
  }
  template <class Value>
  void values(std::size_t rows, Value value) {
    for (std::size_t k = 0; k < rows; ++k) out() << value(k) << '\n';
  }
};

/// Numbers in a file beside it.
class HeavyXdmf final : public XdmfWriter {
 public:
  HeavyXdmf(const XdmfSource& source, std::string file, TextWriter& out)
      : XdmfWriter(source.view, source.points, source.triangles, source.nodes_each, out),
        source_(source),
        file_(std::move(file)) {
    content_.groups = {"/mesh", "/lines"};
  }

  /// REQUIRES: write() was called
  [[nodiscard]] const Hdf5Content& numbers() const { return content_; }

 private:
  struct Place {
    std::string path;
    NumberType type;
  };

  /// Arrays of the input are numbered: in the name of an array in HDF5 a colon, say, would end the
  /// name of the file.
  [[nodiscard]] Place place_of(Item item) const {
    if (item.kind == Item::field)
      return {fmt::format("/mesh/field_{}", item.k + 1), NumberType::float64};
    if (item.kind == Item::attribute)
      return {fmt::format("/mesh/attribute_{}", item.k + 1),
              is_real(item) ? NumberType::float64 : NumberType::int32};
    struct Known {
      const char* path;
      NumberType type;
    };
    constexpr std::array<Known, 8> kPlaces{{{"/mesh/topology", NumberType::int64},
                                            {"/mesh/geometry", NumberType::float64},
                                            {"/mesh/GroupID", NumberType::int32},
                                            {"/mesh/MaterialID", NumberType::int32},
                                            {"/mesh/RegionId", NumberType::int32},
                                            {"/lines/topology", NumberType::int64},
                                            {"/lines/LineID", NumberType::int32},
                                            {"/lines/Marker", NumberType::int32}}};
    const Known& known = kPlaces[static_cast<std::size_t>(item.kind)];
    return {known.path, known.type};
  }

  [[nodiscard]] std::string attributes(Item item) const override {
    return "Precision=\"" + std::to_string(size_of(place_of(item).type)) + "\" Format=\"HDF\"";
  }

  void content(Item item, std::size_t rows, std::size_t columns) override {
    const Place place = place_of(item);
    out() << escaped_markup(file_) << ':' << place.path;
    if (item.kind == Item::places && has_places_) return;  // both grids have the same
    has_places_ = has_places_ || item.kind == Item::places;
    content_.numbers.push_back({place.path, place.type, {rows, columns}, writer_of(item)});
  }

  [[nodiscard]] ArrayWriter writer_of(Item item) const {
    const MeshView& lines = view();
    const auto of_lines = [&lines](auto value) {
      return [&lines, value](BinaryWriter& out) {
        for (std::size_t l = 0; l < lines.lines.size(); ++l)
          out.put(static_cast<std::int32_t>(value(l)));
      };
    };
    switch (item.kind) {
      case Item::nodes:
        return source_.nodes;
      case Item::places:
        return source_.places;
      case Item::group:
        return source_.group;
      case Item::material:
        return source_.material;
      case Item::region:
        return source_.region;
      case Item::line_group:
        return of_lines([&lines](std::size_t l) { return lines.group_of_line(l).tag; });
      case Item::line_marker:
        return of_lines([&lines](std::size_t l) { return lines.marker[l]; });
      case Item::attribute:
        return attribute(lines.attributes[item.k]);
      case Item::field:
        return [&values = lines.fields[item.k].values](BinaryWriter& out) {
          for (const double value : values) out.put(value);
        };
      case Item::line_nodes:
        break;
    }
    return [&lines](BinaryWriter& out) {
      for (const std::uint32_t node : lines.lines.nodes) out.put(static_cast<std::int64_t>(node));
    };
  }

  [[nodiscard]] ArrayWriter attribute(const Attribute& of) const {
    return [this, &of](BinaryWriter& out) {
      for (std::size_t t = 0; t < source_.triangles; ++t) {
        if (of.is_text)
          out.put(static_cast<std::int32_t>(of_triangle(of, t)));
        else
          out.put(of_triangle(of, t));
      }
    };
  }

  const XdmfSource& source_;
  std::string file_;
  Hdf5Content content_;
  bool has_places_ = false;
};

/// The source of a mesh in memory; refers to `view`.
XdmfSource source_of(const MeshView& view) {
  const auto of_triangles = [&view](auto value) {
    return [&view, value](BinaryWriter& out) {
      for (std::size_t t = 0; t < view.triangles.size(); ++t)
        out.put(static_cast<std::int32_t>(value(t)));
    };
  };
  return {view,
          view.points.size(),
          view.triangles.size(),
          view.triangles.nodes_each,
          [&view](BinaryWriter& out) {
            for (const Point& p : view.points) {
              out.put(p.x);
              out.put(p.y);
            }
          },
          [&view](BinaryWriter& out) {
            for (const std::uint32_t node : view.triangles.nodes)
              out.put(static_cast<std::int64_t>(node));
          },
          of_triangles([&view](std::size_t t) { return view.material[t]; }),
          of_triangles([&view](std::size_t t) { return view.region[t].value(); }),
          of_triangles([&view](std::size_t t) { return view.group_of_triangle(t).tag; })};
}

}  // namespace

Status write_xdmf_file(const XdmfSource& source, const std::string& path,
                       const std::stop_token& stop, const std::function<Status()>& status) {
  const std::filesystem::path heavy = std::filesystem::path(path).replace_extension(".h5");
  Result<AtomicFile> numbers = AtomicFile::create(heavy.string(), stop);
  if (!numbers) return std::move(numbers).error();
  Result<TextWriter> text = TextWriter::create(path, stop);
  if (!text) return std::move(text).error();
  HeavyXdmf xdmf(source, heavy.filename().string(), *text);
  xdmf.write();
  ContentHash hash;
  Status done = write_hdf5(xdmf.numbers(), [&](std::string_view bytes) {
    hash.add(bytes);
    numbers->write(bytes);
  });
  xdmf.put_hash(hash);
  xdmf.end();
  if (done) done = status();
  if (done) done = numbers->prepare();
  if (done) done = text->prepare();
  if (!done) return done;
  return commit_together(std::array{&*numbers, &text->file()});
}

Status write_xdmf(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".xdmf", output, path, options); !status) return status;
  const MeshView view = view_of(output, options);
  if (options.xdmf == "hdf5")
    return write_xdmf_file(source_of(view), path, options.stop, [] { return ok(); });
  return write_text(path, options.stop, [&](TextWriter& out) {
    InlineXdmf xdmf(view, out);
    xdmf.write();
    xdmf.end();
  });
}

}  // namespace cover
