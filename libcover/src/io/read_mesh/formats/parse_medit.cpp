// Keywords with a count and as many rows. Keywords that are not known are passed over with their
// numbers.
#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "io/read_mesh/mesh_collector.hpp"
#include "io/read_mesh/mesh_formats.hpp"
#include "io/text/token_reader.hpp"

namespace cover {
namespace {

class MeditParser {
 public:
  MeditParser(std::string_view text, const std::string& source) : tokens_(text, source) {}

  Result<MeshFile> parse() {
    tokens_.expect("MeshVersionFormatted");
    tokens_.integer("the version of the format");
    while (!tokens_.failed()) {
      const std::string_view keyword = tokens_.word();
      if (keyword.empty() || keyword == "End") break;
      read_section(keyword);
    }
    if (tokens_.failed()) return tokens_.error();
    std::vector<NodeSet> sets;
    for (auto& [reference, vertices] : vertices_of_)
      sets.push_back({fmt::format("point_{}", reference), std::move(vertices)});
    collector_.name_points_apart(sets);
    return collector_.finish();
  }

 private:
  void read_section(std::string_view keyword) {
    if (keyword == "Dimension") {
      dimension_ = tokens_.integer("the dimension");
      if (dimension_ != 2 && dimension_ != 3)
        tokens_.fail(ErrorCode::unsupported_format, "the dimension is neither 2 nor 3");
    } else if (keyword == "Vertices") {
      read_vertices();
    } else if (keyword == "Edges" || keyword == "EdgesP2") {
      read_cells(keyword == "Edges" ? 2 : 3, false);
    } else if (keyword == "Triangles" || keyword == "TrianglesP2") {
      read_cells(keyword == "Triangles" ? 3 : 6, true);
    }
  }

  void read_vertices() {
    auto& points = collector_.mesh.soup.points;
    const std::size_t n = tokens_.count("vertices");
    for (std::size_t k = 0; k < n && !tokens_.failed(); ++k) {
      const double x = tokens_.real("a coordinate"), y = tokens_.real("a coordinate");
      if (dimension_ == 3 && tokens_.real("a coordinate") != 0)
        tokens_.fail(ErrorCode::unsupported_format, "the mesh is not in the plane z = 0");
      const long reference = tokens_.integer("the reference of a vertex");
      if (reference != 0)
        vertices_of_[reference].push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back({x, y});
    }
  }

  void read_cells(std::size_t nodes_each, bool triangles) {
    MeshFile& mesh = collector_.mesh;
    std::array<std::uint32_t, 6> nodes{};
    const std::size_t n = tokens_.count("cells");
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < nodes_each; ++i) nodes.at(i) = vertex();
      const long reference = tokens_.integer("the reference of a cell");
      if (tokens_.failed()) return;
      const auto cell = std::span<const std::uint32_t>(nodes).first(nodes_each);
      if (triangles) {
        collector_.add_triangle(cell);
        mesh.soup.material.push_back(reference);
      } else {
        collector_.add_line(cell, reference);
      }
    }
  }

  std::uint32_t vertex() {
    const long number = tokens_.integer("a vertex of a cell");
    const auto n = static_cast<long>(collector_.mesh.soup.points.size());
    if (number >= 1 && number <= n) return static_cast<std::uint32_t>(number - 1);
    tokens_.fail(ErrorCode::id_out_of_range,
                 fmt::format("vertex {} of a cell, but vertices are 1 to {}", number, n));
    return 0;
  }

  TokenReader tokens_;
  long dimension_ = 3;
  std::map<long, std::vector<std::uint32_t>>
      vertices_of_;  ///< by their references, if these are not 0
  MeshCollector collector_;
};

}  // namespace

Result<MeshFile> parse_medit(std::string_view text, const std::string& source) {
  return MeditParser(text, source).parse();
}

}  // namespace cover
