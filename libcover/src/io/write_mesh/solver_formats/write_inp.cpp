// Abaqus' input deck, as CalculiX and Elmer read it too: nodes, elements in one set per region
// group, nodes of each group of lines or points in a set. Names of sets are case-insensitive and
// begin with a letter. Both programs read the first 20 characters of a number and no more, so a
// coordinate that is longer would lose its exponent: it is rounded to the digits that fit. A mesh
// that has triangles too thin for that is refused.
//
// Tested by tests/unit/io/write_mesh/solver_formats/write_inp_test.cpp and, in CalculiX, by
// tests/solvers.
#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <fmt/core.h>

#include <cover/mesh_view.hpp>
#include <cover/text.hpp>

#include "base/containers/buckets.hpp"
#include "base/containers/order.hpp"
#include "geom/predicates.hpp"
#include "io/files/text_writer.hpp"
#include "io/write_mesh/check_format.hpp"

namespace cover {
namespace {

constexpr std::size_t kLongestNumber = 20;

constexpr std::size_t kMostPlaces = 10;  ///< places in an error

/// `x` in at most kLongestNumber characters: exactly if it fits, else as precisely as it does.
std::string coordinate(double x) {
  std::array<char, 32> digits;
  char* const begin = digits.data();
  const auto text = [&](std::to_chars_result end) { return std::string(begin, end.ptr); };
  std::string out = text(std::to_chars(begin, begin + digits.size(), x));
  for (int precision = 17; out.size() > kLongestNumber; --precision) {
    out =
        text(std::to_chars(begin, begin + digits.size(), x, std::chars_format::general, precision));
  }
  return out;
}

/// The coordinate that is read back.
double read_back(double x) {
  const std::string text = coordinate(x);
  double out = x;
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}

/// Whether readers see every triangle the way round that it is.
///
/// Errors: cannot_write, with the places of triangles that rounding flattens or turns over
Status check_rounding(const MeshView& view, const std::string& path) {
  std::vector<Point> seen;
  seen.reserve(view.points.size());
  for (const Point& p : view.points) seen.push_back(rounded_by_inp(p));
  if (seen == view.points) return ok();
  std::size_t count = 0;
  std::vector<Point> where;
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const auto nodes = view.triangles[t];
    const auto turn = [&](const std::vector<Point>& points) {
      return orientation(points[nodes[0]], points[nodes[1]], points[nodes[2]]);
    };
    if (turn(seen) == turn(view.points)) continue;
    if (++count <= kMostPlaces) where.push_back(view.points[nodes[0]]);
  }
  if (count == 0) return ok();
  return Error{
      ErrorCode::cannot_write,
      fmt::format(
          "cannot write {}: its readers take 20 characters of a number, and rounded to them {} "
          "flat or turned over, the first at {}; other formats keep all digits",
          path, counted(count, "triangle") + (count == 1 ? " is" : " are"),
          describe(where.front())),
      std::move(where),
      {}};
}

void write_elements(const MeshView& view, const std::string& family, TextWriter& out) {
  const std::vector<std::string> names = abaqus_names(view.region_groups);
  const Buckets sets(view.region_groups.size(), view.triangles.size(),
                     [&](std::size_t t) { return view.region_group[place_of(view.region[t])]; });
  for (std::size_t g = 0; g < sets.size(); ++g) {
    out << "*ELEMENT, TYPE=" << family << view.triangles.nodes_each << ", ELSET=" << names[g]
        << '\n';
    for (const std::size_t t : sets[g]) {
      out << t + 1;
      for (const std::uint32_t node : view.triangles[t]) out << ", " << node + 1;
      out << '\n';
    }
  }
}

void write_node_sets(const MeshView& view, TextWriter& out) {
  const std::vector<std::string> names = abaqus_names(node_sets(view));
  const auto write = [&](const std::string& name, const std::vector<std::uint32_t>& nodes) {
    out << "*NSET, NSET=" << name << '\n';
    for (const std::uint32_t node : nodes) out << node + 1 << ",\n";
  };
  const Buckets sets(view.line_groups.size(), view.lines.size(),
                     [&](std::size_t l) { return view.line_group[l]; });
  for (std::size_t g = 0; g < sets.size(); ++g) {
    if (sets[g].empty()) continue;
    std::vector<std::uint32_t> nodes;
    for (const std::size_t l : sets[g]) {
      nodes.insert(nodes.end(), view.lines[l].begin(), view.lines[l].end());
    }
    sort_unique(nodes);
    write(names[g], nodes);
  }
  std::vector<std::vector<std::uint32_t>> named(view.point_groups.size());
  for (std::size_t k = 0; k < view.named.size(); ++k)
    named[view.named_group[k]].push_back(view.named[k]);
  for (std::size_t g = 0; g < named.size(); ++g) write(names[sets.size() + g], named[g]);
}

}  // namespace

Point rounded_by_inp(Point p) { return {read_back(p.x), read_back(p.y)}; }

std::size_t points_rounded_by_inp(const Output& output, const WriteOptions& options) {
  const std::vector<Point> points = view_of_triangles(output, options).points;
  return static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const Point& p) { return rounded_by_inp(p) != p; }));
}

Status write_inp(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".inp", output, path, options); !status) return status;
  const MeshView view = view_of(output, options);
  if (Status status = check_rounding(view, path); !status) return status;
  return write_text(path, options.stop, [&](TextWriter& out) {
    out << "*NODE, NSET=" << kAllNodes << '\n';
    for (std::size_t p = 0; p < view.points.size(); ++p) {
      out << p + 1 << ", " << coordinate(view.points[p].x) << ", " << coordinate(view.points[p].y)
          << ", 0\n";
    }
    write_elements(view, options.inp_element, out);
    write_node_sets(view, out);
  });
}

}  // namespace cover
