// Abaqus' input deck, as CalculiX and Elmer read it too: nodes, elements in one set per region
// group, nodes of each group of lines or points in a set, and the edges of each group of lines as a
// surface. Names of sets are case-insensitive and begin with a letter. Both programs read the first
// 20 characters of a number and no more, so a coordinate that is longer would lose its exponent: it
// is rounded to the digits that fit. A mesh that has triangles too thin for that is refused.
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
#include "geom/topology/corner.hpp"
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

/// By line: three times the number of the triangle on its left, and which of its edges the line is,
/// from 0 for that of the first two corners on.
std::vector<std::size_t> faces_of_lines(const MeshView& view) {
  using Ends = std::array<std::uint32_t, 2>;
  const auto ends = [&](std::size_t l) { return Ends{view.lines[l][0], view.lines[l][1]}; };
  const auto order = sorted_numbers<std::size_t>(
      view.lines.size(), [&](std::size_t k, std::size_t l) { return ends(k) < ends(l); });
  std::vector<std::size_t> faces(order.size());
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    for (const Corner i : kCorners) {
      const Ends edge{view.triangles[t][i], view.triangles[t][i.next()]};
      const auto at =
          std::lower_bound(order.begin(), order.end(), edge,
                           [&](std::size_t l, const Ends& wanted) { return ends(l) < wanted; });
      if (at != order.end() && ends(*at) == edge) faces[*at] = 3 * t + i;
    }
  }
  return faces;
}

/// A surface for each group of lines, of one set of elements for each of the edges that they have
/// on it, as Abaqus/CAE writes them. CalculiX takes these sets for loads on edges.
void write_surfaces(const MeshView& view, TextWriter& out) {
  const std::vector<std::string> surfaces = abaqus_names(node_sets(view));
  std::vector<Group> groups = view.region_groups;
  for (const Group& lines : view.line_groups) {
    for (const Corner i : kCorners) {
      groups.push_back(lines);
      groups.back().name += fmt::format("_S{}", i + 1);
      groups.back().is_made_up = true;
    }
  }
  const std::vector<std::string> sets = abaqus_names(groups);
  const std::vector<std::size_t> faces = faces_of_lines(view);
  const Buckets lines(3 * view.line_groups.size(), faces.size(),
                      [&](std::size_t l) { return 3 * view.line_group[l] + faces[l] % 3; });
  for (std::size_t g = 0; g < view.line_groups.size(); ++g) {
    std::string surface;
    for (const Corner i : kCorners) {
      if (lines[3 * g + i].empty()) continue;
      const std::string& set = sets[view.region_groups.size() + 3 * g + i];
      out << "*ELSET, ELSET=" << set << '\n';
      for (const std::size_t l : lines[3 * g + i]) out << faces[l] / 3 + 1 << ",\n";
      surface += fmt::format("{}, S{}\n", set, i + 1);
    }
    if (!surface.empty()) out << "*SURFACE, TYPE=ELEMENT, NAME=" << surfaces[g] << '\n' << surface;
  }
}

}  // namespace

Point rounded_by_inp(Point p) { return {read_back(p.x), read_back(p.y)}; }

std::size_t points_rounded_by_inp(const Output& output, const WriteOptions& options) {
  const std::vector<Point> points = view_of_triangles(output, options).points;
  return static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const Point& p) { return rounded_by_inp(p) != p; }));
}

std::size_t points_beyond_axis(const Output& output, const WriteOptions& options) {
  if (options.inp_element != "CAX") return 0;
  const std::vector<Point> points = view_of_triangles(output, options).points;
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const Point& p) { return p.x < 0; }));
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
    // What edges of shells are called, Abaqus and CalculiX do not agree on.
    if (options.inp_element != "S") write_surfaces(view, out);
  });
}

}  // namespace cover
