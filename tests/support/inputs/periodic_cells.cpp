#include "support/inputs/periodic_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include <fmt/core.h>

#include <cover/mesh.hpp>
#include <cover/verify.hpp>

#include "geom/vector.hpp"
#include "support/inputs/shapes.hpp"

namespace cover::testing {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Points along a line from 0 to 1, with their heights above it; those that lie on a straight part,
/// between their neighbours, are marked.
struct Wave {
  struct Node {
    double along = 0, height = 0;
    bool straight = false;
  };
  std::vector<Node> nodes;  ///< without the ends
};

Wave random_wave(Random& random, double height, bool gaps) {
  const auto n = static_cast<int>(random() % 5);
  std::vector<Wave::Node> nodes{{0, 0, false}};
  for (int k = 0; k < n; ++k) {
    nodes.push_back({(k + uniform(random, 0.25, 0.75)) / n,
                     random() % 3 == 0 ? 0 : uniform(random, -height, height), false});
  }
  nodes.push_back({1, 0, false});
  Wave wave;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    if (k > 0) wave.nodes.push_back(nodes[k]);
    if (!gaps || random() % 2 == 0) continue;
    const double t = uniform(random, 0.2, 0.8);
    wave.nodes.push_back({nodes[k].along + t * (nodes[k + 1].along - nodes[k].along),
                          nodes[k].height + t * (nodes[k + 1].height - nodes[k].height), true});
  }
  return wave;
}

/// Adds points and named segments.
class Drawing {
 public:
  std::uint32_t add(Point p) {
    const auto [at, is_new] = index_.emplace(p, static_cast<std::uint32_t>(input.points.size()));
    if (is_new) input.points.push_back(p);
    return at->second;
  }

  void chain(const std::vector<Point>& points, const std::string& name) {
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const std::uint32_t a = add(points[k]), b = add(points[k + 1]);
      input.segments.push_back({a, b, 0, static_cast<long>(input.segments.size()), 0, name});
    }
  }

  void star(Point centre, double radius, Random& random) {
    Loop loop = random_star(5 + static_cast<int>(random() % 8), 0.5, random, centre, radius);
    loop.push_back(loop[0]);
    chain(loop, "");
  }

  Input input;

 private:
  std::map<Point, std::uint32_t> index_;
};

/// Some points of straight parts are left out on either side.
bool leaves_out(const Wave::Node& node, Random& random) {
  return node.straight && random() % 2 == 0;
}

}  // namespace

Input random_cell(std::uint64_t seed, bool gaps) {
  Random random(seed);
  Drawing drawing;
  const double w = uniform(random, 0.5, 3), h = uniform(random, 0.5, 3);
  const Point o{uniform(random, -2, 2), uniform(random, -2, 2)};
  const Wave side = random_wave(random, 0.1 * w, gaps), floor = random_wave(random, 0.1 * h, gaps);
  const Point corners[] = {o, {o.x + w, o.y}, {o.x + w, o.y + h}, {o.x, o.y + h}};
  const auto vertical = [&](double shift, Point from, Point to, const char* name) {
    std::vector<Point> points{from};
    for (const Wave::Node& n : side.nodes) {
      if (!leaves_out(n, random)) points.push_back({o.x + n.height + shift, o.y + n.along * h});
    }
    points.push_back(to);
    drawing.chain(points, name);
  };
  const auto horizontal = [&](double shift, Point from, Point to, const char* name) {
    std::vector<Point> points{from};
    for (const Wave::Node& n : floor.nodes) {
      if (!leaves_out(n, random)) points.push_back({o.x + n.along * w, o.y + n.height + shift});
    }
    points.push_back(to);
    drawing.chain(points, name);
  };
  vertical(0, corners[0], corners[3], "left");
  vertical(w, corners[1], corners[2], "right");
  horizontal(0, corners[0], corners[1], "bottom");
  horizontal(h, corners[3], corners[2], "top");
  const auto inclusions = random() % 3;
  for (std::size_t k = 0; k < inclusions; ++k)
    drawing.star({o.x + w * (0.3 + 0.4 * static_cast<double>(k)), o.y + 0.5 * h},
                 0.15 * std::min(w, h), random);
  drawing.input.periodic.push_back({"left", "right", PeriodicRule::Map::translation, {}, {}});
  drawing.input.periodic.push_back({"bottom", "top", PeriodicRule::Map::translation, {}, {}});
  return drawing.input;
}

Input random_sector(std::uint64_t seed, bool gaps, bool mirror) {
  Random random(seed);
  Drawing drawing;
  const int parts = 3 + static_cast<int>(random() % 10);
  const double degrees = 360.0 / parts, angle = 2 * std::numbers::pi / parts;
  const double inner = random() % 3 == 0 ? 0 : uniform(random, 0.4, 1), outer = inner + 1;
  const Point o{uniform(random, -2, 2), uniform(random, -2, 2)};
  const double height = 0.1 * std::max(inner, 0.3) * std::sin(angle / 2);
  const Wave side = random_wave(random, inner == 0 ? 0 : height, gaps);
  const auto place = [&](double radius, double across, double turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    return Point{o.x + radius * c - across * s, o.y + radius * s + across * c};
  };
  const auto radial = [&](double turn, double sign, const char* name) {
    std::vector<Point> points{place(inner, 0, turn)};
    for (const Wave::Node& n : side.nodes) {
      if (!leaves_out(n, random)) points.push_back(place(inner + n.along, sign * n.height, turn));
    }
    points.push_back(place(outer, 0, turn));
    drawing.chain(points, name);
  };
  const auto rim = [&](double radius) {
    const int chords = 2 + static_cast<int>(random() % 5);
    std::vector<Point> points;
    for (int k = 0; k <= chords; ++k) points.push_back(place(radius, 0, angle * k / chords));
    drawing.chain(points, "");
  };
  radial(0, 1, "start");
  radial(angle, mirror ? -1 : 1, "end");
  rim(outer);
  if (inner > 0) rim(inner);
  drawing.star(place(inner + 0.6, 0, angle / 2), 0.3 * inner * std::sin(angle / 2) + 0.05, random);
  PeriodicRule rule{"start", "end", PeriodicRule::Map::rotation, o, Angle::degrees(degrees)};
  if (mirror) rule = {"start", "end", PeriodicRule::Map::mirror, {}, {}};
  drawing.input.periodic.push_back(rule);
  return drawing.input;
}

namespace {

/// The vertices of the mesh on a named line, and its edges.
struct NamedLine {
  std::set<std::uint32_t> vertices;
  std::set<std::array<std::uint32_t, 2>> edges;
};

NamedLine line_of(const Output& output, const std::string& name) {
  NamedLine line;
  const TriMesh& tri = output.mesh.tri();
  for (const auto e : tri.edges()) {
    const InterfaceId id = output.mesh.interface(e);
    if (id == kNoInterface || output.table.interface(id).name != name) continue;
    const auto h = tri.halfedge_handle(e, 0);
    const auto a = static_cast<std::uint32_t>(tri.from_vertex_handle(h).idx());
    const auto b = static_cast<std::uint32_t>(tri.to_vertex_handle(h).idx());
    line.vertices.insert({a, b});
    line.edges.insert({std::min(a, b), std::max(a, b)});
  }
  return line;
}

}  // namespace

std::string unpaired(const Output& output) {
  const TriangleSoup soup = triangle_soup(output.mesh);
  double size = 0;
  for (const Point& p : soup.points) size = std::max(size, length(p - soup.points[0]));
  for (const PeriodicNodes& nodes : output.periodic) {
    const std::string where = nodes.rule.from + " and " + nodes.rule.to + ": ";
    const NamedLine from = line_of(output, nodes.rule.from), to = line_of(output, nodes.rule.to);
    if (from.edges.empty()) return where + "no edges";
    std::map<std::uint32_t, std::uint32_t> image;
    std::set<std::uint32_t> reached;
    // The map anew, from the rule and the first pair.
    for (const auto& [u, v] : nodes.vertices) {
      const Point p = soup.points[u], q = soup.points[v];
      if (!image.emplace(u, v).second || !reached.insert(v).second)
        return where + fmt::format("vertex {} or {} has two partners", u, v);
      double off = 0;
      if (nodes.rule.map == PeriodicRule::Map::rotation) {
        const Vector r = p - nodes.rule.centre;
        const double t = nodes.rule.angle.in_radians();
        const Point turned = nodes.rule.centre + Vector{std::cos(t) * r.x - std::sin(t) * r.y,
                                                        std::sin(t) * r.x + std::cos(t) * r.y};
        off = length(turned - q);
      } else if (nodes.rule.map == PeriodicRule::Map::translation) {
        const Vector by = soup.points[nodes.vertices[0][1]] - soup.points[nodes.vertices[0][0]];
        off = length((q - p) - by);
      } else {  // both are as far from any fixed pair's middle line
        const auto& [u0, v0] = nodes.vertices.back();
        off = std::max(std::abs(length(p - soup.points[u0]) - length(q - soup.points[v0])),
                       std::abs(length(p - soup.points[v0]) - length(q - soup.points[u0])));
      }
      if (off > 1e-9 * size)
        return where + fmt::format("vertices {} and {} are off by {}", u, v, off);
    }
    for (const std::uint32_t v : from.vertices) {
      if (image.count(v) == 0) return where + fmt::format("vertex {} has no partner", v);
    }
    for (const std::uint32_t v : to.vertices) {
      if (reached.count(v) == 0) return where + fmt::format("vertex {} is no partner", v);
    }
    if (image.size() != from.vertices.size() || reached.size() != to.vertices.size())
      return where + "pairs of vertices that are not on the lines";
    if (from.edges.size() != to.edges.size() || nodes.edges.size() != from.edges.size())
      return where + "numbers of edges differ";
    for (const auto& [a, b] : from.edges) {
      const std::uint32_t a2 = image[a], b2 = image[b];
      if (to.edges.count({std::min(a2, b2), std::max(a2, b2)}) == 0)
        return where + fmt::format("the edge from {} to {} has no image", a, b);
    }
  }
  return "";
}

}  // namespace cover::testing
