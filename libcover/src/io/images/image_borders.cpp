// Sides of pixels between two regions make up chains, from one place where three or more meet to
// the next, or around. Chains are smoothed one by one and then looked at together: those that cross
// or that change places around an end are smoothed less, until none does.
// Tested by tests/unit/io/images/image_borders_test.cpp.
#include "io/images/image_borders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/core.h>

#include "base/containers/order.hpp"
#include "base/containers/union_find.hpp"
#include "base/none.hpp"
#include "geom/curves/smooth_chain.hpp"
#include "geom/predicates.hpp"
#include "io/text/limits.hpp"

namespace cover {
namespace {

constexpr std::size_t kTiny = 4;

/// Directions from a corner: right, up, left, down.
constexpr std::array<std::array<int, 2>, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// A border between two regions.
struct Chain {
  PixelChain pixels;
  std::uint32_t left = kNone;  ///< region, kNone: void or outside
  std::uint32_t right = kNone;
  bool on_frame = false;
  Smoothing smoothing = Smoothing::none;
  std::vector<Point> curve;
};

/// Which region each pixel belongs to, in the order of their first pixels.
class Regions {
 public:
  explicit Regions(const LabelImage& image)
      : width_(static_cast<int>(image.width)),
        height_(static_cast<int>(image.height)),
        of_(image.labels.size()) {
    UnionFind sets(of_.size());
    for (std::size_t p = 0; p < of_.size(); ++p) {
      if (p % image.width > 0 && image.labels[p] == image.labels[p - 1])
        sets.unite(static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(p - 1));
      if (p >= image.width && image.labels[p] == image.labels[p - image.width])
        sets.unite(static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(p - image.width));
    }
    std::vector<std::uint32_t> number(of_.size(), kNone);
    for (std::size_t p = 0; p < of_.size(); ++p) {
      const std::uint32_t root = sets.find(static_cast<std::uint32_t>(p));
      const bool is_void = image.names[image.labels[p]].is_void;
      if (!is_void && number[root] == kNone) {
        number[root] = static_cast<std::uint32_t>(label.size());
        label.push_back(image.labels[p]);
        pixels.push_back(0);
      }
      of_[p] = is_void ? kNone : number[root];
      if (!is_void) ++pixels[of_[p]];
    }
  }

  [[nodiscard]] std::uint32_t at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return kNone;
    return of_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x)];
  }

  std::vector<std::uint32_t> label;  ///< by region
  std::vector<std::size_t> pixels;   ///< by region: how many

 private:
  int width_, height_;
  std::vector<std::uint32_t> of_;
};

/// Finds the chains.
class Tracer {
 public:
  Tracer(const LabelImage& image, const Regions& regions)
      : regions_(regions),
        width_(static_cast<int>(image.width)),
        height_(static_cast<int>(image.height)),
        used_(static_cast<std::size_t>(width_ + 1) * static_cast<std::size_t>(height_ + 1), 0) {}

  std::vector<Chain> trace() {
    for (const bool loops : {false, true}) {
      for (int y = 0; y <= height_; ++y)
        for (int x = 0; x <= width_; ++x) {
          if (!loops && !is_end(x, y)) continue;
          for (std::size_t d = 0; d < 4; ++d)
            if (is_border(x, y, d) && !is_used(x, y, d)) follow(x, y, d);
        }
    }
    return std::move(chains_);
  }

 private:
  /// The regions on the left and right of a side that leaves a corner.
  [[nodiscard]] std::array<std::uint32_t, 2> beside(int x, int y, std::size_t d) const {
    switch (d) {
      case 0:
        return {regions_.at(x, y), regions_.at(x, y - 1)};
      case 1:
        return {regions_.at(x - 1, y), regions_.at(x, y)};
      case 2:
        return {regions_.at(x - 1, y - 1), regions_.at(x - 1, y)};
      default:
        return {regions_.at(x, y - 1), regions_.at(x - 1, y - 1)};
    }
  }
  [[nodiscard]] bool is_border(int x, int y, std::size_t d) const {
    const auto [left, right] = beside(x, y, d);
    return left != right;
  }
  [[nodiscard]] bool on_frame(int x, int y, std::size_t d) const {
    return d % 2 == 0 ? y == 0 || y == height_ : x == 0 || x == width_;
  }

  /// Where chains end: not two sides of pixels meet, or the frame does not go straight on.
  [[nodiscard]] bool is_end(int x, int y) const {
    int count = 0, frame = 0;
    for (std::size_t d = 0; d < 4; ++d) {
      if (!is_border(x, y, d)) continue;
      ++count;
      frame += on_frame(x, y, d) ? 1 : 0;
    }
    const bool corner = (x == 0 || x == width_) && (y == 0 || y == height_);
    return count > 0 && (count != 2 || frame == 1 || (corner && frame > 0));
  }

  std::uint8_t& used_at(int x, int y) {
    return used_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1) +
                 static_cast<std::size_t>(x)];
  }
  bool is_used(int x, int y, std::size_t d) { return (used_at(x, y) >> d & 1) != 0; }
  void use(int x, int y, std::size_t d) {
    used_at(x, y) = static_cast<std::uint8_t>(used_at(x, y) | 1U << d);
    const int to_x = x + kSteps[d][0], to_y = y + kSteps[d][1];
    used_at(to_x, to_y) = static_cast<std::uint8_t>(used_at(to_x, to_y) | 1U << (d + 2) % 4);
  }

  void follow(int x, int y, std::size_t d) {
    Chain chain;
    chain.left = beside(x, y, d)[0];
    chain.right = beside(x, y, d)[1];
    chain.on_frame = on_frame(x, y, d);
    const auto here = [&] { return Point{static_cast<double>(x), static_cast<double>(y)}; };
    chain.pixels.corners.push_back(here());
    while (d < 4) {
      use(x, y, d);
      x += kSteps[d][0];
      y += kSteps[d][1];
      chain.pixels.corners.push_back(here());
      d = 4;
      for (std::size_t next = 0; next < 4 && !is_end(x, y); ++next)
        if (is_border(x, y, next) && !is_used(x, y, next)) d = next;
    }
    chain.pixels.is_loop = !is_end(x, y);
    chains_.push_back(std::move(chain));
  }

  const Regions& regions_;
  int width_, height_;
  std::vector<std::uint8_t> used_;  ///< by corner, a bit for each direction
  std::vector<Chain> chains_;
};

/// Smooths chains together.
class Smoother {
 public:
  explicit Smoother(std::vector<Chain>& chains) : chains_(chains) {}

  void run() {
    std::vector<std::size_t> changed;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      chains_[c].smoothing = chains_[c].on_frame ? Smoothing::none : Smoothing::much;
      changed.push_back(c);
    }
    while (!changed.empty()) {
      for (const std::size_t c : changed)
        chains_[c].curve = smooth_chain(chains_[c].pixels, chains_[c].smoothing);
      changed.clear();
      std::vector<std::size_t> bad = crossing();
      const std::vector<std::size_t> turned = out_of_order();
      bad.insert(bad.end(), turned.begin(), turned.end());
      sort_unique(bad);
      for (const std::size_t c : bad) {
        if (chains_[c].smoothing == Smoothing::none) continue;
        chains_[c].smoothing = static_cast<Smoothing>(static_cast<int>(chains_[c].smoothing) - 1);
        changed.push_back(c);
      }
    }
  }

 private:
  /// A piece of a curve.
  struct Piece {
    Point a, b;
    std::uint32_t chain;
    std::uint32_t index;  ///< in its curve
  };

  /// Chains that meet others, or themselves, elsewhere than at their ends.
  [[nodiscard]] std::vector<std::size_t> crossing() const {
    std::vector<Piece> pieces;
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
      const std::vector<Point>& curve = chains_[c].curve;
      for (std::uint32_t k = 0; k + 1 < curve.size(); ++k)
        pieces.push_back({curve[k], curve[k + 1], c, k});
    }
    const auto cells = cells_of(pieces);
    std::vector<std::size_t> out;
    for (std::size_t first = 0; first < cells.size();) {
      std::size_t last = first;
      while (last < cells.size() && cells[last].first == cells[first].first) ++last;
      for (std::size_t i = first; i < last; ++i) {
        for (std::size_t j = i + 1; j < last; ++j) {
          const Piece &p = pieces[cells[i].second], &q = pieces[cells[j].second];
          if (!meet_wrongly(p, q)) continue;
          out.push_back(p.chain);
          out.push_back(q.chain);
        }
      }
      first = last;
    }
    return out;
  }

  /// The pixels that pieces pass, and maybe some beside them; sorted.
  static std::vector<std::pair<std::uint64_t, std::uint32_t>> cells_of(
      const std::vector<Piece>& pieces) {
    constexpr double kWider = 0x1p-16;  // than rounding
    std::vector<std::pair<std::uint64_t, std::uint32_t>> cells;
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      const Point a = std::min(pieces[k].a, pieces[k].b), b = std::max(pieces[k].a, pieces[k].b);
      const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
      for (double x = std::floor(a.x - kWider); x <= b.x + kWider; ++x) {
        const double from = std::clamp(x - kWider, a.x, b.x),
                     to = std::clamp(x + 1 + kWider, a.x, b.x);
        const bool steep = b.x - a.x < kWider;
        const double y0 = steep ? a.y : a.y + slope * (from - a.x);
        const double y1 = steep ? b.y : a.y + slope * (to - a.x);
        const double low = std::floor(std::min(y0, y1) - kWider), high = std::max(y0, y1) + kWider;
        for (double y = low; y <= high; ++y)
          cells.emplace_back(
              static_cast<std::uint64_t>(x + 1) << 32U | static_cast<std::uint64_t>(y + 1), k);
      }
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  /// Whether p is an end that chains of both may share there.
  [[nodiscard]] bool is_common_end(Point p, const Piece& s, const Piece& t) const {
    const Chain &c = chains_[s.chain], &d = chains_[t.chain];
    if (s.chain == t.chain) {
      const auto n = static_cast<std::uint32_t>(c.curve.size() - 1);
      const std::uint32_t low = std::min(s.index, t.index), high = std::max(s.index, t.index);
      return high - low == 1 || (high - low == n - 1 && c.curve.front() == c.curve.back());
    }
    const auto ends_at = [&](const Chain& chain) {
      const std::vector<Point>& corners = chain.pixels.corners;
      return !chain.pixels.is_loop && (corners.front() == p || corners.back() == p);
    };
    return ends_at(c) && ends_at(d);
  }

  /// Exact.
  [[nodiscard]] bool meet_wrongly(const Piece& s, const Piece& t) const {
    const std::array<Sign, 2> of_t{orientation(s.a, s.b, t.a), orientation(s.a, s.b, t.b)};
    for (const auto& [p, from_s] : {std::pair(s.a, s.b), std::pair(s.b, s.a)}) {
      for (const auto& [q, from_t] : {std::pair(t.a, t.b), std::pair(t.b, t.a)}) {
        if (p != q) continue;
        if (!is_common_end(p, s, t)) return true;
        const bool in_line = orientation(p, from_s, from_t) == Sign::zero;
        return in_line && (from_s < p) == (from_t < p);
      }
    }
    const std::array<Sign, 2> of_s{orientation(t.a, t.b, s.a), orientation(t.a, t.b, s.b)};
    if (of_t[0] == Sign::zero && of_t[1] == Sign::zero)
      return std::max(std::min(s.a, s.b), std::min(t.a, t.b)) <=
             std::min(std::max(s.a, s.b), std::max(t.a, t.b));
    return of_t[0] != of_t[1] && of_s[0] != of_s[1];
  }

  /// A chain that leaves an end.
  struct Spoke {
    std::size_t chain;
    Point pixel;  ///< the corner that is next on it
    Point curve;  ///< the point that is
  };

  /// Chains that do not leave an end in the order in which their pixels do.
  [[nodiscard]] std::vector<std::size_t> out_of_order() const {
    std::map<Point, std::vector<Spoke>> around;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      const Chain& chain = chains_[c];
      if (chain.pixels.is_loop) continue;
      const auto& pixels = chain.pixels.corners;
      around[pixels.front()].push_back({c, pixels[1], chain.curve[1]});
      around[pixels.back()].push_back(
          {c, pixels[pixels.size() - 2], chain.curve[chain.curve.size() - 2]});
    }
    std::vector<std::size_t> out;
    for (auto& [centre, spokes] : around) {
      if (spokes.size() < 3) continue;
      std::sort(spokes.begin(), spokes.end(), [&, at = centre](const Spoke& s, const Spoke& t) {
        return quarter(at, s.pixel) < quarter(at, t.pixel);
      });
      if (is_in_order(centre, spokes)) continue;
      for (const Spoke& spoke : spokes) out.push_back(spoke.chain);
    }
    return out;
  }

  static int quarter(Point centre, Point next) {
    return next.x > centre.x ? 0 : next.y > centre.y ? 1 : next.x < centre.x ? 2 : 3;
  }

  /// Whether the curves leave counter-clockwise in the order of the spokes: around three of them in
  /// turn there is one round, which three by three makes one round in all.
  static bool is_in_order(Point centre, const std::vector<Spoke>& spokes) {
    const auto ccw = [&](const Spoke& a, const Spoke& b, const Spoke& c) {
      const int ab = turn(centre, a, b), bc = turn(centre, b, c), ca = turn(centre, c, a);
      // At most one of the angles from one to the next is half a round or more.
      return (ab > 0) + (bc > 0) + (ca > 0) >= 2 && ab != 0 && bc != 0 && ca != 0;
    };
    for (std::size_t k = 1; k + 1 < spokes.size(); ++k) {
      const Spoke &a = spokes[0], &b = spokes[k], &c = spokes[k + 1];
      if (is_straight(centre, a, b, c)) continue;
      if (!ccw(a, b, c)) return false;
    }
    return true;
  }

  static int turn(Point centre, const Spoke& a, const Spoke& b) {
    const Sign sign = orientation(centre, a.curve, b.curve);
    return sign == Sign::positive ? 1 : sign == Sign::negative ? -1 : 0;
  }

  /// Two of three leave in opposite directions, as they always do on a frame: then the third,
  /// between them, is on its side.
  static bool is_straight(Point centre, const Spoke& a, const Spoke& b, const Spoke& c) {
    const std::array<const Spoke*, 3> s{&a, &b, &c};
    for (std::size_t k = 0; k < 3; ++k) {
      const Spoke &u = *s[k], &v = *s[(k + 1) % 3], &w = *s[(k + 2) % 3];
      if (turn(centre, u, v) != 0) continue;
      const bool opposite = (u.curve.x - centre.x) * (v.curve.x - centre.x) < 0 ||
                            (u.curve.y - centre.y) * (v.curve.y - centre.y) < 0;
      // From v to w to u is the other half of the round.
      return opposite && turn(centre, v, w) > 0 && turn(centre, w, u) > 0;
    }
    return false;
  }

  std::vector<Chain>& chains_;
};

/// Puts the chains around each region together to rings.
class RingMaker {
 public:
  RingMaker(const std::vector<Chain>& chains, std::size_t regions)
      : chains_(chains), used_(2 * chains.size()) {
    from_.resize(regions);
    for (std::size_t c = 0; c < chains.size(); ++c) {
      if (chains[c].left != kNone) from_[chains[c].left].emplace(start(2 * c), 2 * c);
      if (chains[c].right != kNone) from_[chains[c].right].emplace(start(2 * c + 1), 2 * c + 1);
    }
  }

  std::vector<std::vector<Point>> rings(std::size_t region) {
    std::vector<std::vector<Point>> out;
    for (const auto& [begin, first] : from_[region]) {
      if (used_[first]) continue;
      std::vector<Point> ring;
      std::size_t way = first;
      while (true) {
        used_[way] = true;
        append(way, ring);
        const Point end = start(way ^ 1U);
        if (end == begin) break;
        way = next(region, end);
      }
      out.push_back(std::move(ring));
    }
    return out;
  }

 private:
  /// A way is a chain, 2 c, or the same backwards, 2 c + 1: with the region on its left.
  [[nodiscard]] Point start(std::size_t way) const {
    const std::vector<Point>& corners = chains_[way / 2].pixels.corners;
    return way % 2 == 0 ? corners.front() : corners.back();
  }

  /// As many ways leave an end as arrive there, so there is one.
  [[nodiscard]] std::size_t next(std::size_t region, Point from) const {
    auto [at, end] = from_[region].equal_range(from);
    while (at != end && used_[at->second]) ++at;
    return at->second;
  }

  void append(std::size_t way, std::vector<Point>& ring) const {
    const std::vector<Point>& curve = chains_[way / 2].curve;
    // The last point is the first one of what follows.
    if (way % 2 == 0) ring.insert(ring.end(), curve.begin(), curve.end() - 1);
    if (way % 2 != 0) ring.insert(ring.end(), curve.rbegin(), curve.rend() - 1);
  }

  const std::vector<Chain>& chains_;
  std::vector<bool> used_;                               ///< by way
  std::vector<std::multimap<Point, std::size_t>> from_;  ///< by region: ways by where they begin
};

}  // namespace

Result<ImageBorders> borders_of(const LabelImage& image, bool smooth, const std::string& source) {
  const Regions regions(image);
  if (regions.label.size() > kImageRegions)
    return Error{
        ErrorCode::unsupported_format,
        fmt::format("{}: {} sets of equal pixels; a picture of labels has at most {}: is this "
                    "a photograph?",
                    source, regions.label.size(), kImageRegions),
        {},
        {}};
  std::vector<Chain> chains = Tracer(image, regions).trace();
  ImageBorders out;
  if (smooth) {
    Smoother(chains).run();
  } else {
    for (Chain& chain : chains) chain.curve = smooth_chain(chain.pixels, Smoothing::none);
  }
  for (const Chain& chain : chains) {
    out.smoothed += smooth && !chain.on_frame ? 1 : 0;
    out.less_smoothed += smooth && !chain.on_frame && chain.smoothing != Smoothing::much ? 1 : 0;
  }
  RingMaker rings(chains, regions.label.size());
  for (std::size_t r = 0; r < regions.label.size(); ++r) {
    InputPolygon polygon;
    polygon.rings = rings.rings(r);
    polygon.material = image.names[regions.label[r]].name;
    polygon.id = static_cast<long>(r);
    out.polygons.push_back(std::move(polygon));
    out.tiny += regions.pixels[r] < kTiny ? 1 : 0;
  }
  return out;
}

}  // namespace cover
