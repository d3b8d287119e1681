// Eighteen families of shapes, each of which is awkward in a way of its own, on a coarse grid, so
// that much coincides; coordinates are then moved by some units in the last place, and all is
// turned, scaled and shifted. A family draws what it needs from the bytes, so that a fuzzer that
// changes one changes one thing.
#include "support/inputs/hostile_case.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/core.h>

namespace cover::testing {
namespace {

/// Draws from bytes.
class Choices {
 public:
  Choices(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  /// In [0, n), n at most 256.
  int below(int n) { return static_cast<int>(byte() % static_cast<unsigned>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool one_in(int n) { return below(n) == n - 1; }
  /// In [0, 1), in steps of 1/65536.
  double fraction() {
    const unsigned high = byte();
    return (256 * high + byte()) / 65536.0;
  }
  template <class T, std::size_t N>
  T of(const std::array<T, N>& values) {
    return values[static_cast<std::size_t>(below(static_cast<int>(N)))];
  }

 private:
  unsigned byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }

  const std::uint8_t* data_;
  std::size_t left_;
};

double moved(double x, int units) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  for (int k = 0; k < std::abs(units); ++k) x = std::nextafter(x, units > 0 ? kFar : -kFar);
  return x;
}

constexpr std::array<const char*, 4> kMaterials{"Si", "SiO2", "a b", "metal"};

/// One input while it is being made.
class Maker {
 public:
  Maker(Choices& choices) : c_(choices) {}

  HostileCase make() {
    struct Family {
      const char* name;
      void (Maker::*draw)();
    };
    static constexpr std::array<Family, 18> kFamilies{{
        {"near-collinear", &Maker::near_collinear},
        {"slits", &Maker::slits},
        {"pinches", &Maker::pinches},
        {"fan", &Maker::fan},
        {"spiral", &Maker::spiral},
        {"overlaps", &Maker::overlaps},
        {"needles", &Maker::needles},
        {"comb", &Maker::comb},
        {"nested", &Maker::nested},
        {"bow-tie", &Maker::bow_tie},
        {"cells", &Maker::cells},
        {"random segments", &Maker::random_segments},
        {"cocircular", &Maker::cocircular},
        {"thin layers", &Maker::thin_layers},
        {"scattered points", &Maker::scattered},
        {"shifted copies", &Maker::shifted_copies},
        {"T-junctions", &Maker::t_junctions},
        {"steps", &Maker::steps},
    }};
    const Family family = c_.of(kFamilies);
    out_.family = family.name;
    out_.input.source = "hostile";
    (this->*family.draw)();
    if (c_.one_in(4)) add_seeds();
    place();
    return std::move(out_);
  }

 private:
  int units() { return c_.one_in(3) ? c_.between(-3, 3) : 0; }
  Point grid(int n = 10) {
    const double x = c_.below(n + 1), y = c_.below(n + 1);
    return {moved(x, units()), moved(y, units())};
  }
  std::uint32_t add(Point p) {
    out_.input.points.push_back(p);
    return static_cast<std::uint32_t>(out_.input.points.size() - 1);
  }
  void join(std::uint32_t a, std::uint32_t b) {
    InputSegment segment;
    segment.a = a;
    segment.b = b;
    segment.id = static_cast<long>(out_.input.segments.size());
    out_.input.segments.push_back(segment);
  }
  void loop(const std::vector<Point>& points) {
    const auto first = static_cast<std::uint32_t>(out_.input.points.size());
    for (const Point& p : points) add(p);
    const auto n = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t k = 0; k < n; ++k) join(first + k, first + (k + 1) % n);
  }
  void paint(std::vector<std::vector<Point>> rings) {
    InputPolygon polygon;
    polygon.rings = std::move(rings);
    polygon.material = c_.of(kMaterials);
    if (c_.one_in(6)) polygon.priority = c_.below(3);
    polygon.id = static_cast<long>(out_.input.polygons.size());
    out_.input.polygons.push_back(std::move(polygon));
  }
  /// As a painted polygon or as segments.
  void outline(std::vector<Point> points, bool painted) {
    if (painted)
      paint({std::move(points)});
    else
      loop(points);
  }
  void box(double size = 10) { loop({{0, 0}, {size, 0}, {size, size}, {0, size}}); }

  void near_collinear() {
    const int n = c_.between(4, 20);
    std::vector<std::uint32_t> on;
    const double slope = c_.between(0, 3);
    for (int k = 0; k < n; ++k)
      on.push_back(add({moved(k, units()), moved(slope * k, c_.between(-4, 4))}));
    for (std::size_t k = 0; k + 1 < on.size(); ++k) {
      if (!c_.one_in(5)) join(on[k], on[k + 1]);
    }
    const std::uint32_t top = add({1.0 * c_.below(n), 3 * slope * n + 5}), bottom = add(grid());
    join(on.front(), top);
    join(top, on.back());
    join(on.front(), c_.one_in(2) ? bottom : on.back());
    if (c_.one_in(2)) join(bottom, on.back());
  }
  void slits() {
    box();
    for (int k = c_.between(1, 8); k > 0; --k) {
      const std::uint32_t a = add(grid());
      join(a,
           c_.one_in(3) ? static_cast<std::uint32_t>(c_.below(static_cast<int>(a))) : add(grid()));
    }
  }
  void pinches() {
    const Point hub = grid();
    const bool painted = c_.one_in(2);
    for (int k = c_.between(2, 7); k > 0; --k) {
      const Point a = grid(), b = grid();
      outline({{moved(hub.x, units()), moved(hub.y, units())}, a, b}, painted);
    }
  }
  void fan() {
    const int n = c_.between(3, 24);
    const std::uint32_t hub = add({0, 0});
    std::uint32_t before = 0;
    const double step = c_.one_in(3) ? 1e-9 : c_.one_in(2) ? 0x1p-40 : 0.05;
    for (int k = 0; k < n; ++k) {
      const double t = step * k;
      const std::uint32_t p = add({moved(10 * std::cos(t), units()), 10 * std::sin(t)});
      join(hub, p);
      if (k > 0 && !c_.one_in(6)) join(before, p);
      before = p;
    }
  }
  void spiral() {
    const int n = c_.between(6, 26);
    const double growth = c_.one_in(3) ? 1.02 : 1.1 + c_.fraction() / 2;
    std::vector<Point> inner, outer;
    double r = 1;
    for (int k = 0; k < n; ++k, r *= growth) {
      const double t = k * (std::numbers::pi / c_.between(4, 5));
      inner.push_back({r * std::cos(t), r * std::sin(t)});
      const double width = c_.one_in(4) ? 1e-12 : 0.01;
      outer.push_back({r * (1 + width) * std::cos(t), r * (1 + width) * std::sin(t)});
    }
    inner.insert(inner.end(), outer.rbegin(), outer.rend());
    outline(inner, c_.one_in(2));
  }
  void overlaps() {
    for (int k = c_.between(2, 12); k > 0; --k) {
      const Point a = grid(), b = grid(), c = grid();
      if (c_.one_in(2))
        paint({{a, b, c}});
      else
        paint({{a, {b.x, a.y}, b, {a.x, b.y}}});
    }
  }
  void needles() {
    for (int k = c_.between(1, 8); k > 0; --k) {
      const Point a = grid();
      const double length = std::ldexp(1.0, c_.between(-4, 10)), turn = 7 * c_.fraction();
      const double width = std::ldexp(1.0, -c_.between(6, 50));
      const Point b{a.x + length * std::cos(turn), a.y + length * std::sin(turn)};
      paint(
          {{a, b, {b.x - length * width * std::sin(turn), b.y + length * width * std::cos(turn)}}});
    }
  }
  void comb() {
    const int teeth = c_.between(2, 12);
    std::vector<Point> points{{0, 0}};
    const double gap = std::ldexp(1.0, -c_.below(45));
    for (int k = 0; k < teeth; ++k) {
      const double x = teeth - k;
      points.push_back({x, moved(1.0 * c_.between(3, 8), units())});
      points.push_back({x - gap, c_.one_in(3) ? moved(0, units()) : 1});
    }
    if (c_.one_in(2)) points[0].y = -1;
    points.insert(points.begin() + 1, {teeth + 1.0, 0});
    outline(points, c_.one_in(2));
  }
  void nested() {
    const bool painted = c_.one_in(2);
    double low = 0, high = 16;
    for (int k = c_.between(2, 8); k > 0 && low < high; --k) {
      outline({{low, low}, {high, low}, {high, high}, {low, high}}, painted);
      const double step = c_.one_in(3) ? 0 : c_.one_in(3) ? 0x1p-49 : 1;
      low = moved(low + step, units());
      high = moved(high - (c_.one_in(4) ? 0 : step), units());
    }
  }
  void bow_tie() {
    for (int k = c_.between(1, 4); k > 0; --k) {
      std::vector<Point> points;
      for (int m = c_.between(4, 9); m > 0; --m) points.push_back(grid());
      outline(points, c_.one_in(2));
    }
  }
  void cells() {
    const int n = c_.between(1, 4);
    std::vector<std::uint32_t> at;
    for (int i = 0; i <= n; ++i) {
      for (int k = 0; k <= n; ++k)
        at.push_back(add({moved(i, units()) + (c_.one_in(3) ? 0.4 * c_.fraction() : 0),
                          moved(k, units()) + (c_.one_in(3) ? 0.4 * c_.fraction() : 0)}));
    }
    const auto width = static_cast<std::size_t>(n) + 1;
    for (std::size_t i = 0; i < width; ++i) {
      for (std::size_t k = 0; k < width; ++k) {
        const std::size_t v = i * width + k;
        if (k + 1 < width && !c_.one_in(9)) join(at[v], at[v + 1]);
        if (i + 1 < width && !c_.one_in(9)) join(at[v], at[v + width]);
        if (i + 1 < width && k + 1 < width && c_.one_in(5)) join(at[v], at[v + width + 1]);
      }
    }
  }
  void random_segments() {
    const int n = c_.between(4, 24);
    for (int k = 0; k < n; ++k) add(grid(c_.one_in(2) ? 4 : 16));
    for (int k = c_.between(3, 20); k > 0; --k)
      join(static_cast<std::uint32_t>(c_.below(n)), static_cast<std::uint32_t>(c_.below(n)));
  }
  void cocircular() {
    const int n = c_.between(3, 20);
    std::vector<Point> points;
    for (int k = 0; k < n; ++k) {
      const double t = 2 * std::numbers::pi * k / n;
      points.push_back({moved(5 * std::cos(t), units()), moved(5 * std::sin(t), units())});
    }
    loop(points);
    if (c_.one_in(2)) add({0, 0});
    for (int k = c_.below(4); k > 0; --k)
      join(static_cast<std::uint32_t>(c_.below(n)), static_cast<std::uint32_t>(c_.below(n)));
  }
  void thin_layers() {
    double y = 0;
    const bool painted = c_.one_in(2);
    for (int k = c_.between(1, 7); k > 0; --k) {
      const double top = y + std::ldexp(1.0, -c_.below(52));
      const double x = c_.one_in(3) ? c_.below(3) : 0;
      outline({{x, y}, {10, y}, {10, top}, {5 + 5 * c_.fraction(), top}, {x, top}}, painted);
      y = c_.one_in(5) ? moved(top, units()) : top;
    }
  }
  void scattered() {
    for (int k = c_.between(3, 20); k > 0; --k) add(grid(c_.one_in(2) ? 3 : 10));
    const auto n = static_cast<int>(out_.input.points.size());
    for (int k = c_.below(4); k > 0; --k)
      join(static_cast<std::uint32_t>(c_.below(n)), static_cast<std::uint32_t>(c_.below(n)));
  }
  void shifted_copies() {
    std::vector<Point> points;
    for (int k = c_.between(3, 6); k > 0; --k) points.push_back(grid());
    const bool painted = c_.one_in(2);
    for (int k = c_.between(2, 8); k > 0; --k) {
      outline(points, painted);
      for (Point& p : points) p = {moved(p.x, units()), moved(p.y, units())};
    }
  }
  void t_junctions() {
    const int n = c_.between(1, 6);
    paint({{{0, 0}, {6.0 * n, 0}, {6.0 * n, 5}, {0, 5}}});
    for (int k = 0; k < n; ++k) {
      const double top = moved(5, units());
      paint({{{6.0 * k, top}, {6.0 * k + 6, moved(5, units())}, {6.0 * k + 6, 9}, {6.0 * k, 9}}});
    }
  }
  void steps() {
    std::vector<Point> points;
    double x = 0, y = 0;
    for (int k = c_.between(2, 12); k > 0; --k) {
      points.push_back({x, y});
      x += std::ldexp(1.0, -c_.below(30));
      points.push_back({x, y});
      y += std::ldexp(1.0, -c_.below(30));
    }
    points.push_back({0, y});
    outline(points, c_.one_in(2));
  }

  void add_seeds() {
    for (int k = c_.between(1, 3); k > 0; --k) {
      RegionSeed seed;
      seed.at = {10 * c_.fraction(), 10 * c_.fraction()};
      seed.material = c_.of(kMaterials);
      if (c_.one_in(3)) seed.size = std::ldexp(1.0, c_.between(-3, 3));
      out_.input.seeds.push_back(seed);
    }
    if (c_.one_in(3)) out_.input.holes.push_back({{10 * c_.fraction(), 10 * c_.fraction()}, 0, 0});
    if (c_.one_in(2)) out_.input.void_rule = VoidRule::unseeded_faces;
  }

  /// Turns, scales and shifts.
  void place() {
    static constexpr std::array kScales{1.0, 1.0, 1.0, 1.0,   1.0,    1.0,  1.0,   1e-9,
                                        0.1, 3.0, 1e6, 1e-30, 1e-120, 1e50, 1e-200};
    static constexpr std::array kShifts{0.0, 0.0, 0.0, 0.0, 0.0,  0.0, 0.0,
                                        1.0, 1e3, 1e6, 1e9, 1e12, 1e15};
    const double scale = c_.of(kScales);
    const double shift_x = c_.of(kShifts) * scale,
                 shift_y = c_.one_in(2) ? 0 : c_.of(kShifts) * scale;
    const double turn = c_.one_in(4) ? 7 * c_.fraction() : 0;
    const double cos = std::cos(turn), sin = std::sin(turn);
    const auto put = [&](Point& p) {
      p = {scale * (cos * p.x - sin * p.y) + shift_x, scale * (sin * p.x + cos * p.y) + shift_y};
    };
    for (Point& p : out_.input.points) put(p);
    for (InputPolygon& polygon : out_.input.polygons) {
      for (auto& ring : polygon.rings) {
        for (Point& p : ring) put(p);
      }
    }
    for (RegionSeed& seed : out_.input.seeds) {
      put(seed.at);
      if (seed.size) *seed.size *= scale;
    }
    for (HoleSeed& hole : out_.input.holes) put(hole.at);
    out_.input.scale = 1;
    scale_ = scale;
  }

 public:
  [[nodiscard]] double scale() const { return scale_; }

 private:
  Choices& c_;
  HostileCase out_;
  double scale_ = 1;
};

Options draw_options(Choices& c, double scale) {
  Options o;
  o.threads = 1;
  const int method = c.below(8);
  if (method == 5 || method == 6) o.method = Method::almond;
  if (method == 7) o.method = Method::nonobtuse;
  if (c.one_in(4)) o.fill = Fill::disks;
  if (o.method == Method::almond && c.one_in(3)) {
    o.paper = true;
    if (c.one_in(2)) o.pieces = c.between(2, 12);
  }
  if (o.method != Method::nonobtuse && c.one_in(4)) o.hull = true;
  if (o.method == Method::quality && c.one_in(3)) o.max_angle = Angle::degrees(c.between(61, 170));
  if (o.method == Method::quality && c.one_in(4)) o.min_angle = Angle::degrees(c.between(0, 40));
  if (c.one_in(3)) o.split_interfaces = Angle::degrees(c.one_in(2) ? 90 : c.between(60, 150));
  if (o.method == Method::quality && c.one_in(5)) {
    o.sizes.push_back({"", scale * std::ldexp(1 + c.fraction(), c.between(-2, 8)), false});
    if (c.one_in(2)) o.sizes.push_back({"Si", scale * (0.5 + c.fraction()), false});
  }
  if (o.method == Method::quality && c.one_in(6)) o.growth = 1.05 + c.fraction();
  if (c.one_in(4)) o.weld = c.one_in(2) ? 0 : std::ldexp(1.0, -c.between(10, 50));
  if (c.one_in(5)) o.overlap = c.one_in(3) ? Overlap::error : Overlap::first;
  if (c.one_in(5)) o.merge_materials = true;
  if (c.one_in(12)) o.strict = true;
  return o;
}

std::string list_of(const std::vector<Point>& points) {
  std::string text;
  for (const Point& p : points)
    text += fmt::format("{}[{:.17g}, {:.17g}]", text.empty() ? "" : ", ", p.x, p.y);
  return text;
}

}  // namespace

HostileCase hostile_case(const std::uint8_t* data, std::size_t size) {
  Choices choices(data, size);
  Maker maker(choices);
  HostileCase made = maker.make();
  made.options = draw_options(choices, maker.scale());
  return made;
}

std::vector<std::uint8_t> bytes_of_seed(std::uint64_t seed) {
  std::vector<std::uint8_t> bytes(1024);
  std::uint64_t state = seed;
  for (std::uint8_t& byte : bytes) {  // splitmix64
    state += 0x9E3779B97F4A7C15U;
    std::uint64_t mixed = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBU;
    byte = static_cast<std::uint8_t>((mixed ^ (mixed >> 31)) >> 24);
  }
  return bytes;
}

std::string json_of(const Input& input) {
  std::string text = "{\n";
  if (!input.points.empty()) {
    text += "\"points\": [" + list_of(input.points) + "],\n\"segments\": [";
    for (std::size_t s = 0; s < input.segments.size(); ++s)
      text +=
          fmt::format("{}[{}, {}]", s == 0 ? "" : ", ", input.segments[s].a, input.segments[s].b);
    text += "]";
  }
  if (!input.polygons.empty()) {
    text += text.size() > 2 ? ",\n" : "";
    text += "\"polygons\": [";
    for (std::size_t k = 0; k < input.polygons.size(); ++k) {
      const InputPolygon& polygon = input.polygons[k];
      text += fmt::format("{}\n{{\"material\": \"{}\"", k == 0 ? "" : ",", polygon.material);
      if (polygon.priority) text += fmt::format(", \"priority\": {}", *polygon.priority);
      text += ", \"rings\": [";
      for (std::size_t r = 0; r < polygon.rings.size(); ++r)
        text += fmt::format("{}[{}]", r == 0 ? "" : ", ", list_of(polygon.rings[r]));
      text += "]}";
    }
    text += "]";
  }
  if (!input.seeds.empty()) {
    text += ",\n\"regions\": [";
    for (std::size_t k = 0; k < input.seeds.size(); ++k) {
      const RegionSeed& seed = input.seeds[k];
      text += fmt::format("{}{{\"x\": {:.17g}, \"y\": {:.17g}, \"material\": \"{}\"",
                          k == 0 ? "" : ", ", seed.at.x, seed.at.y, seed.material);
      if (seed.size) text += fmt::format(", \"size\": {:.17g}", *seed.size);
      text += "}";
    }
    text += "]";
  }
  if (!input.holes.empty()) {
    text += ",\n\"holes\": [";
    for (std::size_t k = 0; k < input.holes.size(); ++k)
      text += (k == 0 ? "" : ", ") + list_of({input.holes[k].at});
    text += "]";
  }
  return text + "\n}\n";
}

std::vector<std::string> arguments_of(const Options& o) {
  std::vector<std::string> out;
  const auto number = [](double x) { return fmt::format("{:.17g}", x); };
  const auto put = [&](const char* option, const std::string& value) {
    out.emplace_back(option);
    out.push_back(value);
  };
  if (o.method == Method::almond) put("--method", "almond");
  if (o.method == Method::nonobtuse) put("--method", "nonobtuse");
  if (o.fill == Fill::disks) put("--fill", "disks");
  if (o.paper) out.emplace_back("--paper");
  if (o.pieces != Options{}.pieces) put("--pieces", fmt::format("{}", o.pieces));
  if (o.hull) out.emplace_back("--hull");
  if (o.max_angle != Options{}.max_angle) put("--max-angle", number(o.max_angle.in_degrees()));
  if (o.min_angle != Options{}.min_angle) put("--min-angle", number(o.min_angle.in_degrees()));
  if (o.split_interfaces) put("--split-interfaces", number(o.split_interfaces->in_degrees()));
  for (const SizeRule& rule : o.sizes)
    put("--size", (rule.name.empty() ? "" : rule.name + "=") + number(rule.size));
  if (o.growth) put("--growth", number(*o.growth));
  if (o.weld) put("--weld", number(*o.weld));
  if (o.overlap == Overlap::first) put("--overlap", "first");
  if (o.overlap == Overlap::error) put("--overlap", "error");
  if (o.merge_materials) out.emplace_back("--merge-materials");
  if (o.strict) out.emplace_back("--strict");
  put("-j", fmt::format("{}", o.threads));
  return out;
}

}  // namespace cover::testing
