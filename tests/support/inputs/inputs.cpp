#include "support/inputs/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <string>

namespace cover::testing {
namespace {

/// Adds points and chains of segments to an Input.
class Sketch {
 public:
  std::uint32_t point(Point p) {
    input.points.push_back(p);
    return static_cast<std::uint32_t>(input.points.size() - 1);
  }
  void segment(std::uint32_t a, std::uint32_t b) {
    InputSegment s;
    s.a = a;
    s.b = b;
    s.id = static_cast<long>(input.segments.size());
    input.segments.push_back(s);
  }
  void seed(Point at, std::uint64_t material) {
    RegionSeed s;
    s.at = at;
    s.material = std::to_string(material);
    s.id = static_cast<long>(input.seeds.size());
    input.seeds.push_back(s);
  }
  Input input;
};

/// A square that is cut into convex pieces.
class Cake {
 public:
  explicit Cake(std::uint64_t seed) : random_(seed) {
    for (const Point p : {Point{0, 0}, {1, 0}, {1, 1}, {0, 1}}) sketch_.point(p);
    pieces_ = {{0, 1, 2, 3}};
  }

  /// Cuts the piece with most corners through two of its sides.
  void cut() {
    std::uniform_real_distribution<double> part(0.3, 0.7);
    const auto largest = std::max_element(
        pieces_.begin(), pieces_.end(),
        [&](const auto& p, const auto& q) { return longest_side(p) < longest_side(q); });
    const std::size_t piece = static_cast<std::size_t>(largest - pieces_.begin());
    const std::size_t n = pieces_[piece].size();
    const std::size_t i = side_of(pieces_[piece]), j = (i + 1 + n / 2) % n;
    const std::uint32_t a = pieces_[piece][i], b = pieces_[piece][(i + 1) % n];
    const std::uint32_t c = pieces_[piece][j], d = pieces_[piece][(j + 1) % n];
    const std::uint32_t p = split(a, b, part(random_)), q = split(c, d, part(random_));
    std::vector<std::uint32_t> ring = pieces_[piece];
    std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), p), ring.end());
    const auto at = std::find(ring.begin(), ring.end(), q);
    std::vector<std::uint32_t> first(ring.begin(), at + 1), second(at, ring.end());
    second.push_back(p);
    pieces_[piece] = first;
    pieces_.push_back(second);
  }

  Input finish() {
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const auto& ring : pieces_) {
      Point centre;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::uint32_t a = ring[k], b = ring[(k + 1) % ring.size()];
        if (sides.insert({std::min(a, b), std::max(a, b)}).second) sketch_.segment(a, b);
        centre.x += at(a).x / static_cast<double>(ring.size());
        centre.y += at(a).y / static_cast<double>(ring.size());
      }
      sketch_.seed(centre, 1 + random_() % 3);
    }
    return sketch_.input;
  }

 private:
  [[nodiscard]] Point at(std::uint32_t v) const { return sketch_.input.points[v]; }

  /// The first corner of the longest side.
  [[nodiscard]] std::size_t side_of(const std::vector<std::uint32_t>& ring) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < ring.size(); ++k)
      if (length(ring, k) > length(ring, best)) best = k;
    return best;
  }
  [[nodiscard]] double length(const std::vector<std::uint32_t>& ring, std::size_t k) const {
    const Point a = at(ring[k]), b = at(ring[(k + 1) % ring.size()]);
    return std::hypot(b.x - a.x, b.y - a.y);
  }
  [[nodiscard]] double longest_side(const std::vector<std::uint32_t>& ring) const {
    return length(ring, side_of(ring));
  }

  /// A new corner on the side ab, in every piece that has it.
  std::uint32_t split(std::uint32_t a, std::uint32_t b, double t) {
    const std::uint32_t m =
        sketch_.point({at(a).x + t * (at(b).x - at(a).x), at(a).y + t * (at(b).y - at(a).y)});
    for (auto& ring : pieces_) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::uint32_t p = ring[k], q = ring[(k + 1) % ring.size()];
        if ((p != a || q != b) && (p != b || q != a)) continue;
        ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k) + 1, m);
        break;
      }
    }
    return m;
  }

  std::mt19937_64 random_;
  Sketch sketch_;
  std::vector<std::vector<std::uint32_t>> pieces_;  // counter-clockwise
};

}  // namespace

Input checker(int cells, int pieces, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> offset(-0.08, 0.08);
  Sketch sketch;
  const auto n = static_cast<std::size_t>(cells);
  const double side = 1.0 / cells;
  std::vector<std::uint32_t> corner((n + 1) * (n + 1));
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      corner[i * (n + 1) + j] =
          sketch.point({static_cast<double>(i) / cells, static_cast<double>(j) / cells});
    }
  }
  const auto chain = [&](std::size_t i, std::size_t j, bool horizontal, bool straight) {
    std::uint32_t last = corner[i * (n + 1) + j];
    for (int m = 1; m < pieces; ++m) {
      const double t = static_cast<double>(m) / pieces, o = straight ? 0 : offset(random);
      const double x = static_cast<double>(i) + (horizontal ? t : o);
      const double y = static_cast<double>(j) + (horizontal ? o : t);
      const std::uint32_t next = sketch.point({x * side, y * side});
      sketch.segment(last, next);
      last = next;
    }
    sketch.segment(last, horizontal ? corner[(i + 1) * (n + 1) + j] : corner[i * (n + 1) + j + 1]);
  };
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      if (i < n) chain(i, j, true, j == 0 || j == n);
      if (j < n) chain(i, j, false, i == 0 || i == n);
      if (i < n && j < n) {
        sketch.seed({(static_cast<double>(i) + 0.5) * side, (static_cast<double>(j) + 0.5) * side},
                    1 + (i + j) % 2);
      }
    }
  }
  return sketch.input;
}

Loop smooth_star(int n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> jitter(-0.35, 0.35), phase(0, 2 * std::numbers::pi),
      weight(0.5, 1);
  std::vector<double> t(static_cast<std::size_t>(n)), r(static_cast<std::size_t>(n), 1.0);
  for (int i = 0; i < n; ++i) {
    t[static_cast<std::size_t>(i)] = (i + jitter(random)) * 2 * std::numbers::pi / n;
  }
  for (int k = 2; k <= n / 8; k *= 2) {
    const double p = phase(random), w = weight(random);
    for (std::size_t i = 0; i < t.size(); ++i) r[i] += 0.35 / k * w * std::cos(k * t[i] + p);
  }
  Loop loop;
  for (std::size_t i = 0; i < t.size(); ++i)
    loop.push_back({r[i] * std::cos(t[i]), r[i] * std::sin(t[i])});
  return loop;
}

Input input_of(const Loop& loop) {
  Sketch sketch;
  for (const Point& p : loop) sketch.point(p);
  const auto n = static_cast<std::uint32_t>(loop.size());
  for (std::uint32_t i = 0; i < n; ++i) sketch.segment(i, (i + 1) % n);
  return sketch.input;
}

Input segments_between(const std::vector<Point>& points,
                       const std::vector<std::array<std::uint32_t, 2>>& ends) {
  Sketch sketch;
  for (const Point& p : points) sketch.point(p);
  for (const auto& [a, b] : ends) sketch.segment(a, b);
  return sketch.input;
}

Input pinch_out() {
  return segments_between({{0, -60},
                           {400, -60},
                           {400, 25},
                           {0, 25},
                           {100, 10},
                           {200, 10.007},
                           {300, 9.9},
                           {300, 10.7},
                           {200, 10.407}},
                          {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 4}});
}

Input random_cells(int cuts, std::uint64_t seed) {
  Cake cake(seed);
  for (int k = 0; k < cuts; ++k) cake.cut();
  return cake.finish();
}

Input nested_stars(int rings, int n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> radius(0.75, 1);
  Sketch sketch;
  double size = 1;
  for (int ring = 0; ring < rings; ++ring, size *= 0.6) {
    const auto first = static_cast<std::uint32_t>(sketch.input.points.size());
    for (int k = 0; k < n; ++k) {
      const double r = size * radius(random), angle = 2 * std::numbers::pi * k / n;
      sketch.point({r * std::cos(angle), r * std::sin(angle)});
    }
    for (int k = 0; k < n; ++k)
      sketch.segment(first + static_cast<std::uint32_t>(k),
                     first + static_cast<std::uint32_t>((k + 1) % n));
    // Beside the direction of a corner there is room between the rings: 0.6 < 0.66 < 0.75
    // cos(pi/n).
    sketch.seed({0.66 * size, 0.01 * size}, 1 + random() % 3);
  }
  return sketch.input;
}

Input rectangles(int columns, int rows, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> width(-3, 0);
  const auto lines = [&](int n) {
    std::vector<double> at{0};
    for (int k = 0; k < n; ++k) at.push_back(at.back() + std::pow(10.0, width(random)));
    return at;
  };
  const std::vector<double> x = lines(columns), y = lines(rows);
  Sketch sketch;
  for (const double yj : y)
    for (const double xi : x) sketch.point({xi, yj});
  const auto at = [&](std::size_t i, std::size_t j) {
    return static_cast<std::uint32_t>(j * x.size() + i);
  };
  for (std::size_t j = 0; j < y.size(); ++j) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (i + 1 < x.size()) sketch.segment(at(i, j), at(i + 1, j));
      if (j + 1 < y.size()) sketch.segment(at(i, j), at(i, j + 1));
      if (i + 1 == x.size() || j + 1 == y.size() || random() % 8 == 0) continue;
      sketch.seed({(x[i] + x[i + 1]) / 2, (y[j] + y[j + 1]) / 2}, 1 + random() % 3);
    }
  }
  sketch.input.void_rule = VoidRule::unseeded_faces;
  return sketch.input;
}

Input planar_graph(int n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1), sign(-1, 1);
  std::normal_distribution<double> normal;
  const auto small = [&] { return std::pow(10, -8 * unit(random)); };
  const double flat = small();
  const auto kind = random() % 7;
  std::vector<Point> points;
  for (int k = 0; k < n; ++k) {
    const double turn = 2 * std::numbers::pi * k / n;
    switch (kind) {
      case 0:
        points.push_back({unit(random), unit(random)});
        break;
      case 1:
        points.push_back({std::floor(12 * unit(random)), std::floor(12 * unit(random))});
        break;
      case 2:
        points.push_back({unit(random), flat * unit(random)});
        break;
      case 3:
        points.push_back(
            {std::copysign(small(), sign(random)), std::copysign(small(), sign(random))});
        break;
      case 4:
        points.push_back({k + 1e-9 * unit(random), k % 7 + 1e-9 * unit(random)});
        break;
      case 5:
        points.push_back(k % 4 == 0 ? Point{0.5 + 1e-6 * unit(random), 0.5 + 1e-6 * unit(random)}
                                    : Point{std::cos(turn), std::sin(turn)});
        break;
      default: {
        const double size = std::pow(10, -1 - k % 4);
        points.push_back({k % 3 + size * normal(random), size * normal(random)});
      }
    }
  }
  const double scale[] = {1, 1, 0x1p40, 0x1p-60, 1e-6}, shift[] = {0, 0, 1000, 1e6};
  const double factor = scale[random() % 5], far = factor * shift[random() % 4];
  for (Point& p : points) p = {p.x * factor + far, p.y * factor - far};
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());

  Sketch sketch;
  for (const Point& p : points) sketch.point(p);
  const double kept = 0.4 + 0.2 * static_cast<double>(random() % 4);
  for (const Triangle& t : triangulate_hull(points, {}).triangulation.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t.v[i], b = t.v[(i + 1) % 3];
      const bool is_first = a < b || t.n[(i + 2) % 3] == kNone;
      if (is_first && unit(random) < kept) sketch.segment(a, b);
    }
  }
  return sketch.input;
}

Input shuffled(const Input& input, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> order(input.points.size()), place(order.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), random);
  Input out = input;
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    out.points[k] = input.points[order[k]];
    if (!input.point_ids.empty()) out.point_ids[k] = input.point_ids[order[k]];
    if (!input.point_markers.empty()) out.point_markers[k] = input.point_markers[order[k]];
  }
  for (InputSegment& s : out.segments) {
    s.a = place[s.a];
    s.b = place[s.b];
    if (random() % 2 == 0) std::swap(s.a, s.b);
  }
  std::shuffle(out.segments.begin(), out.segments.end(), random);
  std::shuffle(out.seeds.begin(), out.seeds.end(), random);
  return out;
}

Input transformed(const Input& input, double factor, Point shift) {
  Input out = input;
  const auto move = [&](Point& p) { p = {p.x * factor + shift.x, p.y * factor + shift.y}; };
  for (Point& p : out.points) move(p);
  for (RegionSeed& s : out.seeds) move(s.at);
  for (HoleSeed& h : out.holes) move(h.at);
  for (InputPolygon& polygon : out.polygons) {
    for (auto& ring : polygon.rings) {
      for (Point& p : ring) move(p);
    }
  }
  for (InputLine& line : out.lines) {
    for (Point& p : line.points) move(p);
  }
  return out;
}

}  // namespace cover::testing
