// Tables of numbers, each headed by a line with its counts; rows count from 0 or 1, as the .node
// does.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <utility>

#include "io/read_mesh/mesh_collector.hpp"
#include "io/read_mesh/mesh_formats.hpp"
#include "io/text/field_reader.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

/// One of the files.
class Table : public FieldReader {
 public:
  Table(std::string_view text, const std::string& source) : FieldReader(text, source, '#') {
    if (FieldReader::next()) {
      rows_ = integer(0);
    } else {
      fail(ErrorCode::truncated, "the file is empty");
    }
  }

  /// Goes on to the next of the rows that the header announces.
  bool next() {
    if (failed() || row_ >= rows_) return false;
    ++row_;
    if (!FieldReader::next())
      fail(ErrorCode::truncated, fmt::format("the file ends before row {}", row_));
    return !failed();
  }

 private:
  long rows_ = 0;
  long row_ = 0;
};

class TriangleReader {
 public:
  explicit TriangleReader(const std::string& path) : path_(path) {}

  Result<MeshFile> read() {
    for (const auto& [extension, part] : {std::pair{".node", &TriangleReader::read_nodes},
                                          {".ele", &TriangleReader::read_elements},
                                          {".edge", &TriangleReader::read_edges}}) {
      const bool is_given = extension == std::string_view(".ele");  // in any case of letters
      const std::string file =
          is_given ? path_ : fs::path(path_).replace_extension(extension).string();
      if (extension == std::string_view(".edge") && !fs::is_regular_file(file)) continue;
      const Result<std::string> text = read_file(file);
      if (!text) return text.error();
      Table table(*text, file);
      if (!table.failed()) (this->*part)(table);
      if (table.failed()) return table.error();
    }
    return collector_.finish();
  }

 private:
  void read_nodes(Table& table) {
    auto& points = collector_.mesh.soup.points;
    while (table.next()) {
      const long number = table.integer(0);
      if (points.empty()) base_ = number;
      if (number != base_ + static_cast<long>(points.size()))
        table.fail(ErrorCode::syntax, "the numbers of the points have a gap");
      points.push_back({table.real(1), table.real(2)});
    }
  }

  void read_elements(Table& table) {
    const long nodes_each = table.integer(1), attributes = table.integer(2);
    if (nodes_each != 3 && nodes_each != 6)
      return table.fail(ErrorCode::unsupported_format, "triangles have 3 or 6 nodes");
    const auto n = static_cast<std::size_t>(nodes_each);
    std::array<std::uint32_t, 6> nodes{};
    while (table.next()) {
      for (std::size_t k = 0; k < n; ++k) nodes.at(k) = vertex(table, k + 1);
      if (table.failed()) return;
      // Triangle names the midpoint opposite the first corner first.
      if (n == 6) std::rotate(nodes.begin() + 3, nodes.begin() + 5, nodes.end());
      collector_.add_triangle(std::span<const std::uint32_t>(nodes).first(n));
      if (attributes >= 1)
        collector_.mesh.soup.material.push_back(table.integer(n + (attributes == 3 ? 3 : 1)));
      if (attributes >= 2) collector_.mesh.soup.region.push_back(table.integer(n + 2));
    }
  }

  void read_edges(Table& table) {
    while (table.next()) {
      const std::array ends{vertex(table, 1), vertex(table, 2)};
      const long marker = table.fields().size() > 3 ? table.integer(3) : 0;
      if (table.failed()) return;
      collector_.add_line(ends, marker);
    }
  }

  std::uint32_t vertex(Table& table, std::size_t field) {
    const long number = table.integer(field) - base_;
    const auto n = static_cast<long>(collector_.mesh.soup.points.size());
    if (number >= 0 && number < n) return static_cast<std::uint32_t>(number);
    table.fail(ErrorCode::id_out_of_range, fmt::format("there is no point {}", number + base_));
    return 0;
  }

  std::string path_;
  long base_ = 1;
  MeshCollector collector_;
};

}  // namespace

Result<MeshFile> read_triangle(const std::string& path) { return TriangleReader(path).read(); }

}  // namespace cover
