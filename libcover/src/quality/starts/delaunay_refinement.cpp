// See delaunay_refinement.hpp. The triangles of a Delaunay cavity, unlike those of `Cavity`, may be
// many: the first vertex inside a long loop sees most of it.
// Tested by tests/unit/quality/starts/delaunay_refinement_test.cpp.
#include "quality/starts/delaunay_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "base/containers/bucket_queue.hpp"
#include "base/containers/stamped_set.hpp"
#include "geom/cotangent.hpp"
#include "geom/predicates.hpp"
#include "geom/subdivision/rounds.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// Circumradius allowed, times the size. An equilateral triangle has 0.577; what refinement leaves
/// is smaller on average than what it may leave, and with this factor the number of triangles is
/// that of equilateral ones, within 10 % on squares and discs.
constexpr double kRadius = 0.78;

/// The shortest edges come first, but not over the whole mesh: every bucket would be a way through
/// all of the memory. Of those as long as each other within a factor of 16, a block of neighbours
/// is worked off before the next one.
constexpr int kBlock = 4096;          ///< triangles
constexpr int kBucketsPerBlock = 16;  ///< two per factor of two, in squared lengths

/// Of a centre's distance from a corner, squared: rounding may take or add an eighth.
constexpr double kMostMoved = 1.0 / 64;

/// Parts are smaller than where a mesh is improved, until there are enough: their triangles become
/// some three times as many, and what waits at their borders is for one thread.
constexpr std::size_t kLeastPart = 12'500;  ///< triangles
constexpr std::size_t kEnoughParts = 32;

constexpr std::size_t kSpare = 4;  ///< one in so many may be added before lists move

constexpr std::size_t kRoom = 32;        ///< triangles of a cavity: nearly all have fewer
constexpr std::size_t kLargeFan = 1024;  ///< triangles around a new vertex, queued in rounds

class Refinement {
 public:
  /// REQUIRES: all outlive this
  Refinement(MutableMesh& mesh, const RefineLimits& limits, SizeField& sizes,
             const std::stop_token& stop, const Team& team = {})
      : mesh_(mesh), limits_(limits), sizes_(sizes), stop_(stop), team_(team) {
    const double kappa = angle_of_cot(limits.smallest_cot);
    off_centre_ = 0.4 / std::tan(kappa / 2);  // 0.5: the new angle is kappa
    const std::size_t count = mesh_.triangles.size();
    in_cavity_.reserve(count + count / kSpare);
    guarded_.reserve(count + count / kSpare);
    in_cavity_.resize(count);
    guarded_.assign(count, 0);
    cavity_.reserve(kRoom);
    loop_.reserve(kRoom);
    open_.reserve(kRoom);
    guard_forced();
    shortest_ = shortest_edge();
  }

  void run() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) enqueue(t);
    work_off();
  }
  /// Begins with these triangles alone.
  void run(std::span<const std::uint32_t> triangles) {
    for (const std::uint32_t t : triangles) enqueue(t);
    work_off();
  }

  /// The triangles that wait for what is beyond the borders of this part.
  [[nodiscard]] std::vector<std::uint32_t> waiting() const {
    std::vector<std::uint32_t> waiting;
    for (const auto& [t, v] : stopped_) {
      if (mesh_.triangles[t].v == v) waiting.push_back(t);
    }
    return waiting;
  }

 private:
  void work_off() {
    std::size_t inserted = 0;
    const auto goes_on = [&] { return inserted < limits_.budget && !stop_.stop_requested(); };
    while (goes_on() && take_block()) {
      while (goes_on() && !block_.empty()) {
        const Entry entry = block_.pop();
        if (mesh_.triangles[entry.triangle].v != entry.v) continue;
        is_stopped_ = false;
        if (insert_near(entry.triangle)) ++inserted;
        if (is_stopped_) stopped_.emplace_back(entry.triangle, entry.v);
      }
    }
  }

  struct Entry {
    std::uint32_t triangle;
    std::array<std::uint32_t, 3> v;
    int bucket;  ///< in a block
  };
  struct LoopEdge {
    std::uint32_t a, b, outer;
  };
  /// An edge of a triangle of the cavity, beyond which nobody has looked yet.
  struct OpenEdge {
    std::uint32_t triangle;
    Corner edge;
  };

  /// Marks the triangles on sides whose apex angle is forced, and on edges of such triangles.
  void guard_forced() {
    std::vector<std::vector<std::uint32_t>> on_sides(
        Team::ranges(mesh_.triangles.size(), kItemsAtATime));
    team_.each_range(mesh_.triangles.size(), kItemsAtATime,
                     [&](std::size_t first, std::size_t last) {
                       for (std::size_t t = first; t < last; ++t) {
                         if (is_forced(static_cast<std::uint32_t>(t)))
                           on_sides[first / kItemsAtATime].push_back(static_cast<std::uint32_t>(t));
                       }
                     });
    std::vector<std::uint32_t> stack;
    for (const std::vector<std::uint32_t>& some : on_sides) {
      stack.insert(stack.end(), some.begin(), some.end());
      while (!stack.empty()) {
        const std::uint32_t t = stack.back();
        stack.pop_back();
        if (guarded_[t] != 0 || !is_forced(t)) continue;
        guarded_[t] = 1;
        for (const std::uint32_t other : mesh_.triangles[t].n) {
          if (!is_side(other)) stack.push_back(other);
        }
      }
    }
  }

  /// Whether a side, or a triangle that is guarded, sees its corner opposite at more than the goal.
  [[nodiscard]] bool is_forced(std::uint32_t t) const {
    if (mesh_.is_hole(t)) return false;
    for (const Corner i : kCorners) {
      const std::uint32_t n = mesh_.triangles[t].n[i];
      if (is_side(n) ? is_border(n) : guarded_[n] == 0) continue;
      const Corners k(mesh_.corner(t, i), mesh_.corner(t, i.next()), mesh_.corner(t, i.previous()));
      if (-k.dot[0] > mesh_.goal().large * k.cross) return true;
    }
    return false;
  }

  [[nodiscard]] bool is_border(std::uint32_t n) const {
    return is_side(n) && side_index(n) >= limits_.first_border;
  }
  [[nodiscard]] bool is_own_side(std::uint32_t n) const { return is_side(n) && !is_border(n); }

  /// Queues `t` if it has an angle that is too small, or is too large. Those with the shortest
  /// edges come first: what is put near them improves the longer ones around for nothing.
  void enqueue(std::uint32_t t) {
    if (guarded_[t] != 0) return;
    const auto& v = mesh_.triangles[t].v;
    const Point* const points = mesh_.points.data();
    const Corners k(points[v[0]], points[v[1]], points[v[2]]);
    if (!has_small_angle(t, k) && !is_too_large(t, k)) return;
    // The dot products at the ends of an edge add up to its squared length.
    const double shortest2 =
        std::min({k.dot[0] + k.dot[1], k.dot[1] + k.dot[2], k.dot[2] + k.dot[0]});
    const int bucket = half_octave(shortest2) - shortest_;
    BucketQueue<Entry>& queue = bucket < block_end_ ? block_ : waiting_;
    queue.push(&queue == &block_ ? bucket : bucket / kBucketsPerBlock, {t, v, bucket});
  }

  /// Fills the empty block from those that wait; false if there are none.
  bool take_block() {
    if (waiting_.empty()) return false;
    const int first = waiting_.first();
    block_end_ = (first + 1) * kBucketsPerBlock;
    for (int k = 0; k < kBlock && !waiting_.empty() && waiting_.first() == first; ++k) {
      const Entry entry = waiting_.pop();
      block_.push(entry.bucket, entry);
    }
    return true;
  }

  /// An angle below the limit that is not one between two sides.
  [[nodiscard]] bool has_small_angle(std::uint32_t t, const Corners& k) const {
    const auto& n = mesh_.triangles[t].n;
    for (const Corner i : kCorners) {
      if (k.dot[i] <= limits_.smallest_cot * k.cross) continue;
      if (!is_own_side(n[i.next()]) || !is_own_side(n[i.previous()])) return true;
    }
    return false;
  }

  /// A circumradius above what the size allows: at the circumcentre, as far as the corners tell,
  /// and at the centroid.
  [[nodiscard]] bool is_too_large(std::uint32_t t, const Corners& k) const {
    if (!sizes_.is_active() && limits_.largest_radius == kInverted) return false;
    const double squared = (k.dot[0] + k.dot[1]) * (k.dot[1] + k.dot[2]) * (k.dot[2] + k.dot[0]);
    const double radius = std::sqrt(squared) / (2 * k.cross);
    if (radius > limits_.largest_radius) return true;
    if (!sizes_.is_active()) return false;
    const auto& v = mesh_.triangles[t].v;
    const Point a = mesh_.points[v[0]], b = mesh_.points[v[1]], c = mesh_.points[v[2]];
    double size = sizes_.largest_at({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
    for (const std::uint32_t u : v) size = std::min(size, sizes_.near(u, radius));
    for (const std::uint32_t u : v) size = std::max(size, sizes_.least_near(u, radius));
    return radius > kRadius * size;
  }

  /// The squared length of the shortest edge, as half_octave() measures it.
  [[nodiscard]] int shortest_edge() const {
    std::vector<double> shortest2(Team::ranges(mesh_.triangles.size(), kItemsAtATime), kInverted);
    team_.each_range(
        mesh_.triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
          double& own = shortest2[first / kItemsAtATime];
          for (std::size_t k = first; k < last; ++k) {
            const auto t = static_cast<std::uint32_t>(k);
            if (mesh_.is_hole(t)) continue;
            for (const Corner i : kCorners) {
              own = std::min(
                  own, squared_length(mesh_.corner(t, i.previous()) - mesh_.corner(t, i.next())));
            }
          }
        });
    if (shortest2.empty()) return half_octave(kInverted);
    return half_octave(*std::min_element(shortest2.begin(), shortest2.end()));
  }

  /// The circumcentre of `t`, or the off-centre of its shortest edge where that is nearer. Nothing
  /// where doubles are so far apart that rounding moves it: in a column of points with the same x,
  /// far from 0, it would halve the edge, and so would all that come after it. Nor where squares of
  /// lengths are no normal numbers, which tell nothing of that.
  [[nodiscard]] std::optional<Point> centre_of(std::uint32_t t) const {
    Corner shortest;
    double length2 = kInverted;
    for (const Corner i : kCorners) {
      const double l = squared_length(mesh_.corner(t, i.previous()) - mesh_.corner(t, i.next()));
      if (l < length2) {
        length2 = l;
        shortest = i;
      }
    }
    const Point a = mesh_.corner(t, shortest.next()), b = mesh_.corner(t, shortest.previous());
    const Vector e = b - a, u = mesh_.corner(t, shortest) - a;
    const Vector w = mesh_.corner(t, shortest) - b;
    // The circumcentre is at height |e| cot(apex) / 2 above the middle of e.
    const double height = std::min(0.5 * dot(u, w) / cross(e, u), off_centre_);
    const Vector wished = 0.5 * e + height * left_normal(e);
    const Point p = a + wished;
    const double distance2 = squared_length(wished);
    if (distance2 < std::numeric_limits<double>::min()) return {};
    if (squared_length((p - a) - wished) > kMostMoved * distance2) return {};
    return p;
  }

  /// The triangle that contains `p`, from `t` on; kNone if a side is in the way.
  [[nodiscard]] std::uint32_t locate(std::uint32_t t, Point p) {
    const MeshTriangle* const triangles = mesh_.triangles.data();
    const Point* const points = mesh_.points.data();
    std::uint32_t from = kNone;
    for (;;) {
      std::uint32_t go = kNone;
      const auto& [v, across] = triangles[t];
      for (const Corner i : kCorners) {
        const std::uint32_t n = across[i];
        if (n == from) continue;
        if (orientation(points[v[i.next()]], points[v[i.previous()]], p) == Sign::negative) {
          if (is_border(n)) is_stopped_ = true;
          if (is_side(n)) return kNone;
          go = n;
          break;
        }
      }
      if (go == kNone) return t;
      from = t;
      t = go;
    }
  }

  /// Takes a triangle into the cavity; false if it is guarded.
  bool take(std::uint32_t t) {
    in_cavity_.insert(t);
    cavity_.push_back(t);
    return guarded_[t] == 0;
  }

  /// Collects the triangles whose circle contains `p`, and their loop in order. False if one of
  /// them is guarded or a side would be seen from `p` at too large an angle.
  bool find_cavity(std::uint32_t start, Point p) {
    in_cavity_.clear();
    cavity_.clear();
    loop_.clear();
    if (!take(start)) return false;
    const MeshTriangle* const triangles = mesh_.triangles.data();
    const Point* const points = mesh_.points.data();
    open_ = {{start, 2}, {start, 1}, {start, 0}};  // depth first, counter-clockwise
    while (!open_.empty()) {
      const auto [t, i] = open_.back();
      open_.pop_back();
      const MeshTriangle& own = triangles[t];
      const std::uint32_t n = own.n[i];
      if (!is_side(n) && in_cavity_.contains(n)) continue;
      const std::uint32_t va = own.v[i.next()], vb = own.v[i.previous()];
      if (!is_side(n)) {
        const MeshTriangle& other = triangles[n];
        const auto& corners = other.v;
        if (in_circle(points[corners[0]], points[corners[1]], points[corners[2]], p) ==
            Sign::positive) {
          if (!take(n)) return false;
          const Corner entry = other.edge_from(vb);
          open_.push_back({n, entry.previous()});
          open_.push_back({n, entry.next()});
          continue;
        }
      }
      if (is_border(n)) {
        is_stopped_ = true;
        return false;
      }
      const Point a = points[va], b = points[vb];
      if (is_side(n)) {
        const Corners c(p, a, b);
        if (!(c.dot[0] >= limits_.apex_cot * c.cross)) return false;
        if (limits_.keeps_couplings && c.dot[0] < mesh_.allowance(n)->least_cot * c.cross)
          return false;
      }
      if (orientation(a, b, p) != Sign::positive) return false;
      loop_.push_back({va, vb, n});
    }
    return true;
  }

  bool insert_near(std::uint32_t t) {
    const std::optional<Point> p = centre_of(t);
    if (!p) return false;
    const std::uint32_t start = locate(t, *p);
    if (start == kNone || !find_cavity(start, *p)) return false;
    const std::uint32_t apex = mesh_.add_vertex(*p);
    while (cavity_.size() < loop_.size()) cavity_.push_back(mesh_.add_triangle());
    in_cavity_.resize(mesh_.triangles.size());
    guarded_.resize(mesh_.triangles.size(), 0);
    std::uint32_t before = cavity_[loop_.size() - 1];
    for (std::size_t k = 0; k < loop_.size(); ++k) {
      const LoopEdge& e = loop_[k];
      const std::uint32_t s = cavity_[k], after = cavity_[k + 1 < loop_.size() ? k + 1 : 0];
      mesh_.triangles[s] = {{e.a, e.b, apex}, {after, before, e.outer}};
      mesh_.link(e.outer, e.a, e.b, s);
      mesh_.home[e.a] = s;
      before = s;
    }
    mesh_.home[apex] = cavity_[0];
    if (sizes_.is_active()) set_size(apex);
    enqueue_fan();
    return true;
  }

  /// A vertex that was put beside a triangle of a large fan replaces all of the fan that its
  /// circles reach, which may be all; and so do those beside its neighbours, one after the other,
  /// if they come next. In rounds they divide the fan.
  void enqueue_fan() {
    if (loop_.size() <= kLargeFan) {
      for (std::size_t k = 0; k < loop_.size(); ++k) enqueue(cavity_[k]);
    } else {
      for (const std::uint32_t k : rounds(loop_.size())) enqueue(cavity_[k]);
    }
  }

  /// Gives a new vertex its size, from the vertices of the loop around it.
  void set_size(std::uint32_t vertex) {
    const Point p = mesh_.points[vertex];
    double size = sizes_.largest_at(p), least = 0;
    for (const LoopEdge& e : loop_) {
      const double distance = length(mesh_.points[e.a] - p);
      size = std::min(size, sizes_.near(e.a, distance));
      least = std::max(least, sizes_.least_near(e.a, distance));
    }
    sizes_.set(vertex, size, least);
  }

  MutableMesh& mesh_;
  RefineLimits limits_;
  SizeField& sizes_;
  const std::stop_token& stop_;
  const Team team_;
  double off_centre_ = 0;
  BucketQueue<Entry> waiting_;  ///< whole blocks apart, in the order in which they came
  BucketQueue<Entry> block_;    ///< what is worked on, with all that comes from it
  int block_end_ = 0;           ///< bucket; from there on entries wait
  int shortest_ = 0;
  StampedSet in_cavity_;
  std::vector<std::uint8_t> guarded_;
  std::vector<std::uint32_t> cavity_;
  std::vector<LoopEdge> loop_;
  std::vector<OpenEdge> open_;
  bool is_stopped_ = false;  ///< what was tried last reaches a border
  std::vector<std::pair<std::uint32_t, std::array<std::uint32_t, 3>>> stopped_;
};

void refine_in_blocks(MutableMesh& mesh, const RefineLimits& limits, SizeField& sizes,
                      const Sharing& sharing) {
  struct PartResult {
    SizeField sizes;
    std::vector<std::uint32_t> waiting;
  };
  std::vector<PartResult> results(part_count(mesh, sharing));
  const auto points = static_cast<double>(mesh.points.size());
  const auto work = [&](Part& part) {
    PartResult& result = results[part.index];
    RefineLimits own = limits;
    own.first_border = part.first_border;
    if (!sizes.is_active()) {
      const double share = static_cast<double>(part.mesh.points.size()) / points;
      own.budget = static_cast<std::size_t>(share * static_cast<double>(limits.budget)) + 1;
    }
    result.sizes = sizes.part(part.vertices);
    Refinement refinement(part.mesh, own, result.sizes, sharing.stop);
    refinement.run();
    result.waiting = refinement.waiting();
    part.tells_places = true;
  };
  std::vector<std::uint32_t> waiting;
  const auto collect = [&](const Part& part) {
    PartResult& result = results[part.index];
    for (const std::uint32_t t : result.waiting) waiting.push_back(part.triangles[t]);
    if (sizes.is_active()) {
      for (std::uint32_t v = 0; v < part.vertices.size(); ++v) {
        if (part.vertices[v] != kNone) sizes.take(part.vertices[v], result.sizes, v);
      }
    }
    result = {};
  };
  work_in_parts(mesh, sharing, work, collect);
  Refinement(mesh, limits, sizes, sharing.stop, sharing.team).run(waiting);
}

}  // namespace

void refine(MutableMesh& mesh, const RefineLimits& limits, SizeField sizes,
            const Sharing& sharing) {
  Sharing parts = sharing;
  parts.part_size =
      std::min(parts.part_size, std::max(kLeastPart, mesh.triangle_count() / kEnoughParts));
  if (parts.divides(mesh)) {
    refine_in_blocks(mesh, limits, sizes, parts);
  } else {
    Refinement(mesh, limits, sizes, sharing.stop).run();
  }
  mesh.arrange(sharing.team);
}

}  // namespace cover
