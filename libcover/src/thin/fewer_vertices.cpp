// Ruin and recreate: a few vertices that are near each other are taken away, one less is put back,
// and vertices around are moved until no triangle is bad. If that comes about, it stays; else
// everything is taken back. Places for vertices are found by projections: a vertex is good on the
// rim of its hole if it lies between the perpendiculars at the ends of every edge and outside
// of its diametral disk.
// Tested by tests/unit/thin/fewer_vertices_test.cpp.
#include "thin/fewer_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/random.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

constexpr std::size_t kMostNeighbours = 64;
constexpr std::array<int, 6> kMore{1, 2, 4, 8, 16, 32};  ///< vertices that mend a bad triangle
constexpr std::size_t kFew = 3;                          ///< of them, at first
constexpr std::size_t kForOneBeyond = 4;  ///< bad triangles in place of one beyond the worst
constexpr int kMostTaken = 12;            ///< vertices around a triangle that nothing else mends
constexpr std::size_t kMostAnew = 8;      ///< vertices near a triangle that are put elsewhere
constexpr double kRatherStays = 0.2;      ///< cost of a vertex that was put where it is on purpose
constexpr int kInVain = 8;  ///< steps that make nothing better, and one for each new vertex
constexpr int kLongestDrive = 1'000;   ///< cuts from wall to wall
constexpr std::uint64_t kRemoval = 4;  ///< places that could be tried meanwhile

/// What may be tuned.
struct Tuning {
  int projections = 4;   ///< rims on which a place is improved
  int cycles = 3;        ///< over the edges of one rim
  double beyond = 1.02;  ///< of a projection
  int movers = 8;        ///< vertices around a bad triangle that are moved
  std::size_t tabu = 3;  ///< steps for which a vertex that was moved stays
};

class Thinner {
 public:
  Thinner(MeshWithUndo& mesh, const ThinEffort& effort)
      : mesh_(mesh), effort_(effort), most_beyond_(mesh.beyond_worst()) {}

  Thinned run() {
    Thinned thinned{mesh_.bad(), 0};
    std::vector<std::uint32_t> vertices = movable();
    left_ = std::min<std::uint64_t>(effort_.places_at_most,
                                    effort_.places_per_vertex * vertices.size());
    left_to_mend_ = places_to_mend();
    mend();
    take_away();
    search();
    thinned.bad = mesh_.bad();
    return thinned;
  }

  Thinned run_on_what_is_left() {
    Thinned thinned{mesh_.bad(), 0};
    left_ = places_to_mend();
    mend_beyond_worst();
    for (std::size_t before = mesh_.bad() + 1; mesh_.bad() < before && !is_over();) {
      before = mesh_.bad();
      mend_with(kMore.size());
      for (std::uint32_t t = 0; t < mesh_.triangles().size() && !is_over(); ++t) {
        if (is_bad(t)) mend_in_any_way(t);
      }
    }
    focus_ = kNone;
    thinned.bad = mesh_.bad();
    return thinned;
  }

  Thinned run_on_grave_ones(std::uint64_t places_per_sign) {
    Thinned thinned{mesh_.bad(), 0};
    left_ = std::min<std::uint64_t>(
        effort_.places_to_mend_at_most,
        effort_.places_per_bad * mesh_.grave() + places_per_sign * (mesh_.bad() - mesh_.grave()));
    for (std::size_t before = mesh_.grave() + 1; mesh_.grave() < before && !is_over();) {
      before = mesh_.grave();
      for (std::uint32_t t = 0; t < mesh_.triangles().size() && !is_over(); ++t) {
        if (is_grave(t)) mend_one(t, places_per_sign);
      }
    }
    for (std::uint32_t t = 0; t < mesh_.triangles().size() && !is_over(); ++t) {
      if (is_bad_by_a_movable(t)) mend_one(t, places_per_sign);
    }
    thinned.bad = mesh_.bad();
    return thinned;
  }

 private:
  struct Action {
    double cost = kInfinite;       ///< of the mesh then
    std::uint32_t vertex = kNone;  ///< that is moved; kNone: one is added
    Spot spot;
  };

  [[nodiscard]] std::uint64_t places_to_mend() const {
    return std::min<std::uint64_t>(effort_.places_to_mend_at_most,
                                   effort_.places_per_bad * mesh_.bad());
  }

  /// No more than `allowed` triangles are bad, no more gravely than before, and no more of them
  /// worse than any may be.
  [[nodiscard]] bool is_fine(std::size_t allowed) const {
    return mesh_.bad() <= allowed && mesh_.grave() <= most_grave_ &&
           mesh_.bad() - mesh_.grave() <= most_signs_ && mesh_.beyond_worst() <= most_beyond_;
  }

  /// What was mended among the worst ones does not come back.
  void keep() {
    mesh_.keep();
    most_beyond_ = std::min(most_beyond_, mesh_.beyond_worst());
  }

  [[nodiscard]] bool is_over() const { return left_ == 0 || effort_.stop.stop_requested(); }

  [[nodiscard]] std::vector<std::uint32_t> movable() const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t v = 0; v < mesh_.vertices().size(); ++v) {
      if (mesh_.is_there(v) && mesh_.is_movable(v)) found.push_back(v);
    }
    return found;
  }

  /// Vertices that are not needed at all.
  void take_away() {
    for (bool changed = true; changed && !is_over();) {
      changed = false;
      const std::vector<std::uint32_t> vertices = movable();
      for (auto v = vertices.rbegin(); v != vertices.rend() && !is_over(); ++v) {
        const std::size_t before = mesh_.bad();
        most_grave_ = mesh_.grave();
        spend(kRemoval);
        if (!mesh_.remove(*v)) continue;
        if (!is_fine(before)) {
          mesh_.undo(0);
          continue;
        }
        keep();
        changed = true;
      }
    }
  }

  /// Triangles that are worse than any may be, for a few more that are only bad: there are some
  /// where the mesh before was not Delaunay.
  void mend_beyond_worst() {
    for (std::uint32_t t = 0; most_beyond_ > 0 && t < mesh_.triangles().size() && !is_over(); ++t) {
      const MeshWithUndo::Triangle& triangle = mesh_.triangles()[t];
      if (triangle.v[0] == kNone || !MeshWithUndo::is_beyond_worst(triangle)) continue;
      --most_beyond_;
      most_grave_ = mesh_.grave() + kForOneBeyond;
      if (!repair_with(t, mesh_.bad() + kForOneBeyond, kMore.size())) ++most_beyond_;
      keep();
    }
    focus_ = kNone;
  }

  /// Bad triangles, where a few more vertices help: first those that few help, as they may be many.
  void mend() {
    std::swap(left_, left_to_mend_);
    for (const std::size_t more : {kFew, kMore.size()}) mend_with(more);
    mend_beyond_worst();
    std::swap(left_, left_to_mend_);
  }

  /// `tries`: how many of kMore.
  void mend_with(std::size_t tries) {
    for (std::uint32_t t = 0; mesh_.bad() > 0 && t < mesh_.triangles().size() && !is_over(); ++t) {
      if (!is_bad(t)) continue;
      const std::size_t before = mesh_.bad();
      most_grave_ = mesh_.grave();
      repair_with(t, before - 1, tries);
      keep();
    }
    focus_ = kNone;
  }

  /// From triangle `t` on, with ever more vertices; changes nothing if that is not enough.
  bool repair_with(std::uint32_t t, std::size_t allowed, std::size_t tries) {
    spares_.clear();
    starts_.clear();
    for (std::size_t k = 0; k < tries; ++k) {
      focus_ = t;
      if (repair(allowed, kMore[k], 12 + 6 * kMore[k])) return true;
      mesh_.undo(0);
    }
    return false;
  }

  [[nodiscard]] bool is_grave(std::uint32_t t) const {
    const MeshWithUndo::Triangle& triangle = mesh_.triangles()[t];
    return triangle.v[0] != kNone && MeshWithUndo::is_grave(triangle);
  }

  [[nodiscard]] bool is_bad(std::uint32_t t) const {
    return mesh_.triangles()[t].v[0] != kNone && mesh_.triangles()[t].cost > 0;
  }

  /// The corner that sees a piece opposite to it at more than a right angle; nothing if none does.
  [[nodiscard]] std::optional<Corner> corner_over_a_piece(std::uint32_t t) const {
    const MeshWithUndo::Triangle& triangle = mesh_.triangles()[t];
    for (const Corner i : kCorners) {
      const Point apex = mesh_.at(triangle.v[i]), a = mesh_.at(triangle.v[i.next()]),
                  b = mesh_.at(triangle.v[i.previous()]);
      if (triangle.line[i] != ConformingMesh::kInside && dot(a - apex, b - apex) < 0) return i;
    }
    return std::nullopt;
  }

  /// Whether it is a vertex inside that a piece is seen from at more than a right angle.
  [[nodiscard]] bool is_bad_by_a_movable(std::uint32_t t) const {
    if (!is_bad(t) || is_grave(t)) return false;
    const auto corner = corner_over_a_piece(t);
    return corner && mesh_.is_movable(mesh_.triangles()[t].v[*corner]);
  }

  /// Mends a triangle. One that is gravely bad may at worst become one whose coupling at a piece
  /// has the wrong sign.
  void mend_one(std::uint32_t t, std::uint64_t places_per_sign) {
    const std::size_t before = mesh_.bad(), grave = is_grave(t) ? 1 : 0;
    most_grave_ = mesh_.grave() - grave;
    focus_ = t;
    bool mended = false;
    for (std::size_t more = 0; more <= grave; ++more) {
      const std::size_t allowed = before + more - 1;
      most_signs_ = more == 0 ? before - mesh_.grave() : before;
      for (std::size_t k = 0; k <= kFew && !mended; ++k) {
        spares_.clear();
        starts_.clear();
        mended =
            k < kFew ? repair(allowed, kMore[k], 12 + 6 * kMore[k]) : take_away_around(t, allowed);
        if (!mended) mesh_.undo(0);
      }
      mended =
          mended || make_anew(t, allowed, more == 0 ? places_per_sign : effort_.places_per_bad);
    }
    keep();
    focus_ = kNone;
    most_signs_ = kNone;
  }

  /// By cuts through whole layers, or else by others in place of vertices that are near.
  void mend_in_any_way(std::uint32_t t) {
    const std::size_t allowed = mesh_.bad() - 1;
    most_grave_ = mesh_.grave();
    focus_ = t;
    if (!drive_out(allowed)) make_anew(t, allowed, effort_.places_per_bad);
    keep();
  }

  /// Cuts pieces at the feet of the blunt corners opposite to them, then what that makes blunt, and
  /// so on: through thin layers, wall by wall, to where there is room. If that and a few vertices
  /// more leave no more than `allowed` bad triangles, it stays.
  bool drive_out(std::size_t allowed) {
    spares_.clear();
    starts_.clear();
    for (int step = 0; step < kLongestDrive && !is_over(); ++step) {
      if (is_fine(allowed)) return true;
      const std::optional<Spot> foot = foot_of_a_blunt_corner();
      if (!foot || mesh_.insert(*foot) == kNone) break;
    }
    if (repair(allowed, kMore.back(), 6 * kMore.back())) return true;
    mesh_.undo(0);
    return false;
  }

  /// Of the worst bad triangle that has one opposite to a piece, among those of this attempt.
  std::optional<Spot> foot_of_a_blunt_corner() {
    std::vector<std::uint32_t> places = mesh_.written_since(0);
    places.push_back(focus_);
    std::optional<Spot> foot;
    double worst = 0;
    for (const std::uint32_t t : places) {
      if (!is_bad(t) || mesh_.triangles()[t].cost <= worst) continue;
      const auto corner = corner_over_a_piece(t);
      if (!corner) continue;
      const Point apex = mesh_.at(mesh_.triangles()[t].v[*corner]);
      const Spot spot = mesh_.on_line(apex, t, *corner);
      spend(1);
      if (spot.triangle == kNone || !(mesh_.change_with(spot) < kInfinite)) continue;
      worst = mesh_.triangles()[t].cost;
      foot = spot;
    }
    return foot;
  }

  /// Takes some vertices near a triangle away and puts others there, many times.
  bool make_anew(std::uint32_t t, std::size_t allowed, std::uint64_t most_places) {
    const std::array<std::uint32_t, 3> corners = mesh_.triangles()[t].v;
    const std::uint64_t spent = left_ - std::min(left_, most_places);
    while (left_ > spent && !is_over()) {
      spares_.clear();
      starts_.clear();
      spend(kRemoval);
      for (const std::uint32_t v : near(corners[random_.below(3)], 1 + random_.below(kMostAnew))) {
        const Point p = mesh_.at(v);
        if (!mesh_.is_movable(v) || !mesh_.remove(v)) continue;
        spares_.push_back(v);
        starts_.push_back(p);
      }
      const int more = static_cast<int>(spares_.size() + random_.below(3));
      if (repair(allowed, more, 12 + 4 * more)) return true;
      mesh_.undo(0);
    }
    return false;
  }

  /// Takes vertices away, the one that helps most each time, until what is bad is less.
  bool take_away_around(std::uint32_t focus, std::size_t allowed) {
    for (int step = 0; step < kMostTaken && !is_over(); ++step) {
      std::vector<std::uint32_t> places = mesh_.written_since(0), around;
      places.push_back(focus);
      for (const std::uint32_t t : places) {
        if (!is_bad(t) || (t != focus && !is_grave(t))) continue;
        for (const std::uint32_t s : mesh_.triangles()[t].n) {
          if (s != kNone) add_removable(s, around);
        }
        add_removable(t, around);
      }
      std::sort(around.begin(), around.end());
      std::uint32_t best = kNone;
      double least = kInfinite;
      for (const std::uint32_t v : around) {
        const std::size_t mark = mesh_.mark();
        spend(kRemoval);
        if (!mesh_.remove(v)) continue;
        const double cost = static_cast<double>(mesh_.grave()) + mesh_.cost() +
                            (mesh_.only_goes(v) ? kRatherStays : 0);
        if (cost < least) least = cost, best = v;
        mesh_.undo(mark);
      }
      if (best == kNone || !mesh_.remove(best)) return false;
      if (is_fine(allowed)) return true;
    }
    return false;
  }

  void add_removable(std::uint32_t t, std::vector<std::uint32_t>& found) const {
    for (const std::uint32_t v : mesh_.triangles()[t].v) {
      if ((mesh_.is_movable(v) || mesh_.only_goes(v)) &&
          std::find(found.begin(), found.end(), v) == found.end())
        found.push_back(v);
    }
  }

  /// Rounds over all vertices, each with its neighbours.
  void search() {
    std::vector<std::uint32_t> vertices;
    for (int round = 0; !is_over(); ++round) {
      if (round > 0 && mesh_.bad() > 0) mend();
      vertices = movable();
      if (vertices.empty()) return;
      for (std::size_t k = vertices.size(); k > 1; --k)
        std::swap(vertices[k - 1], vertices[random_.below(k)]);
      for (const std::uint32_t v : vertices) {
        if (is_over()) return;
        if (!mesh_.is_there(v)) continue;
        attempt(v, round);
      }
    }
  }

  void attempt(std::uint32_t v, int round) {
    const std::size_t before = mesh_.bad();
    most_grave_ = mesh_.grave();
    const std::size_t count =
        1 + random_.below(std::min<std::size_t>(4, 2 + static_cast<std::size_t>(round) / 2));
    const std::vector<std::uint32_t> taken = near(v, count);
    spares_.clear();
    starts_.clear();
    spend(kRemoval);  // so that rounds end where nothing can be done
    for (const std::uint32_t u : taken) {
      const Point p = mesh_.at(u);
      if (!mesh_.remove(u)) continue;
      spares_.push_back(u);
      starts_.push_back(p);
    }
    if (spares_.empty()) return;
    if (spares_.size() > 1) {
      Vector sum{0, 0};
      for (const Point& p : starts_) sum = sum + (p - starts_[0]);
      starts_.push_back(starts_[0] + (1 / static_cast<double>(spares_.size())) * sum);
    }
    // Now and then as many as before, in other places.
    const bool shake = round > 0 && random_.below(3) == 0;
    const int more = static_cast<int>(spares_.size()) - (shake ? 0 : 1);
    const int steps = 6 + 4 * static_cast<int>(spares_.size()) + 4 * std::min(round, 6);
    if (repair(before, more, steps)) {
      keep();
    } else {
      mesh_.undo(0);
    }
  }

  /// `v` and those nearest to it that may be moved.
  std::vector<std::uint32_t> near(std::uint32_t v, std::size_t count) {
    std::vector<std::uint32_t> found{v}, seen{v};
    for (std::size_t head = 0; head < seen.size() && seen.size() < 40 && found.size() < 2 * count;
         ++head) {
      std::vector<std::uint32_t> around = neighbours(seen[head]);
      const std::size_t turn = around.empty() ? 0 : random_.below(around.size());
      std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(turn), around.end());
      for (const std::uint32_t u : around) {
        if (std::find(seen.begin(), seen.end(), u) != seen.end()) continue;
        seen.push_back(u);
        if (mesh_.is_movable(u)) found.push_back(u);
      }
    }
    if (found.size() > count) found.resize(count);
    return found;
  }

  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t v) const {
    std::vector<std::uint32_t> found;
    const std::uint32_t start = mesh_.vertices()[v].home;
    const auto turn = [&](std::uint32_t t, bool left) {
      const MeshWithUndo::Triangle& triangle = mesh_.triangles()[t];
      const Corner i = corner_of(triangle, v);
      found.push_back(triangle.v[left ? i.previous() : i.next()]);
      return triangle.n[left ? i.next() : i.previous()];
    };
    std::uint32_t t = start;
    do {
      t = turn(t, true);
    } while (t != kNone && t != start && found.size() < kMostNeighbours);
    if (t == kNone) {
      for (t = start; t != kNone && found.size() < kMostNeighbours;) t = turn(t, false);
    }
    return found;
  }

  static Corner corner_of(const MeshWithUndo::Triangle& t, std::uint32_t v) {
    return t.v[0] == v ? 0U : t.v[1] == v ? 1U : 2U;
  }

  void spend(std::uint64_t places) { left_ -= std::min(left_, places); }

  /// Adds up to `more` vertices and moves others until no more than `allowed` triangles are bad.
  /// REQUIRES: spares_ holds vertices that are not there; more of them are made if need be
  bool repair(std::size_t allowed, int more, int steps) {
    tabu_.clear();
    double best = mesh_.cost();
    int in_vain = 0;
    const int most_in_vain = kInVain + more;
    for (int step = 0; step < steps; ++step) {
      if (is_fine(allowed)) return true;
      if (is_over()) return false;
      const std::uint32_t t = a_bad_triangle();
      if (t == kNone) return false;
      Action action;
      const std::array<std::uint32_t, 3> v = mesh_.triangles()[t].v;
      std::vector<Point> starts = around({mesh_.at(v[0]), mesh_.at(v[1]), mesh_.at(v[2])});
      if (more > 0) {
        std::vector<Point> all = starts;
        all.insert(all.end(), starts_.begin(), starts_.end());
        best_spot(all, t, kNone, action);
        const MeshWithUndo::Triangle now = mesh_.triangles()[t];
        for (const Corner i : kCorners) {
          if (now.line[i] != ConformingMesh::kInside)
            improve(mesh_.on_line(mesh_.at(now.v[i]), t, i), kNone, action);
        }
      }
      starts.insert(starts.begin(), Point{});
      for (const std::uint32_t u : movers(t)) {
        if (std::find(tabu_.begin(), tabu_.end(), u) != tabu_.end()) continue;
        const std::size_t mark = mesh_.mark();
        const MeshWithUndo::Vertex old = mesh_.vertices()[u];
        spend(kRemoval);
        if (mesh_.remove(u)) {
          starts[0] = old.at;
          const std::uint32_t from = written_since(mark);
          if (old.line == ConformingMesh::kInside) {
            best_spot(starts, from, u, action);
          } else {
            best_on_line(starts, old.line, mark, u, action);
          }
        }
        mesh_.undo(mark);
      }
      if (!(action.cost < kInfinite)) return false;
      if (!apply(action, more)) return false;
      if (mesh_.cost() < best - 1e-9) {
        best = mesh_.cost();
        in_vain = 0;
      } else if (++in_vain > most_in_vain) {
        return is_fine(allowed);
      }
    }
    return is_fine(allowed);
  }

  bool apply(const Action& action, int& more) {
    std::uint32_t v = action.vertex;
    Spot spot = action.spot;
    if (v != kNone) {
      mesh_.remove(v);
      tabu_.push_back(v);
      if (tabu_.size() > tuning_.tabu) tabu_.erase(tabu_.begin());
    } else {
      --more;
      if (!spares_.empty()) {
        v = spares_.back();
        spares_.pop_back();
      }
    }
    return mesh_.insert(spot, v) != kNone;
  }

  /// One of those that this attempt has made, mostly the worst one.
  std::uint32_t a_bad_triangle() {
    if (focus_ != kNone) {
      const auto& t = mesh_.triangles()[focus_];
      if (t.v[0] != kNone && t.cost > 0) return focus_;
    }
    bad_.clear();
    for (const std::uint32_t t : mesh_.written_since(0)) {
      if (mesh_.triangles()[t].v[0] != kNone && mesh_.triangles()[t].cost > 0) bad_.push_back(t);
    }
    if (bad_.empty()) return kNone;
    std::sort(bad_.begin(), bad_.end());
    bad_.erase(std::unique(bad_.begin(), bad_.end()), bad_.end());
    if (random_.below(3) == 0) return bad_[random_.below(bad_.size())];
    return *std::max_element(bad_.begin(), bad_.end(), [&](std::uint32_t s, std::uint32_t t) {
      return mesh_.triangles()[s].cost < mesh_.triangles()[t].cost;
    });
  }

  /// Corners of `t` and of its neighbours that may be moved.
  std::vector<std::uint32_t> movers(std::uint32_t t) const {
    std::vector<std::uint32_t> found;
    const auto add = [&](std::uint32_t s) {
      for (const std::uint32_t v : mesh_.triangles()[s].v) {
        if (mesh_.is_movable(v) && std::find(found.begin(), found.end(), v) == found.end())
          found.push_back(v);
      }
    };
    add(t);
    for (const std::uint32_t n : mesh_.triangles()[t].n) {
      if (n != kNone) add(n);
    }
    if (found.size() > static_cast<std::size_t>(tuning_.movers))
      found.resize(static_cast<std::size_t>(tuning_.movers));
    return found;
  }

  /// The foot of the blunt corner, the centroid, two places over the middle of the longest edge.
  [[nodiscard]] static std::vector<Point> around(std::array<Point, 3> p) {
    const auto across = [&](Corner i) { return squared_length(p[i.previous()] - p[i.next()]); };
    const Corner i = across(0) >= across(1) && across(0) >= across(2) ? 0U
                     : across(1) >= across(2)                         ? 1U
                                                                      : 2U;
    const Point a = p[i.next()], b = p[i.previous()], c = p[i];
    const Vector ab = b - a;
    const Point foot = a + (dot(c - a, ab) / squared_length(ab)) * ab;
    const Point centroid = c + (1.0 / 3) * ((a - c) + (b - c));
    // On the perpendicular bisector of the longest edge, seen at a right angle from beyond.
    const Vector n = left_normal(ab);
    const Point m = midpoint(a, b);
    const double side = cross(ab, c - a) > 0 ? -0.5 : 0.5;
    return {foot, centroid, m + side * n, m};
  }

  /// A triangle that is there and was written since `mark`.
  [[nodiscard]] std::uint32_t written_since(std::size_t mark) const {
    for (const std::uint32_t t : mesh_.written_since(mark)) {
      if (mesh_.triangles()[t].v[0] != kNone) return t;
    }
    return kNone;
  }

  /// The best place from any of `starts`, in `action` if it is better than what stands there.
  void best_spot(const std::vector<Point>& starts, std::uint32_t from, std::uint32_t vertex,
                 Action& action) {
    for (const Point& start : starts) improve(mesh_.locate(start, from), vertex, action);
  }

  /// The same on the piece of `line` that was made whole since `mark`.
  void best_on_line(const std::vector<Point>& starts, std::uint32_t line, std::size_t mark,
                    std::uint32_t vertex, Action& action) {
    std::vector<std::uint32_t> all = mesh_.written_since(mark);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (const std::uint32_t t : all) {
      const MeshWithUndo::Triangle triangle = mesh_.triangles()[t];
      if (triangle.v[0] == kNone) continue;
      for (const Corner i : kCorners) {
        if (triangle.line[i] != line) continue;
        for (const Point& start : starts) improve(mesh_.on_line(start, t, i), vertex, action);
        improve(mesh_.on_line(mesh_.at(triangle.v[i]), t, i), vertex, action);
        return;
      }
    }
  }

  /// Moves a place to where fewer triangles around it are bad.
  void improve(Spot spot, std::uint32_t vertex, Action& action) {
    const double cost = mesh_.cost();
    for (int k = 0; k <= tuning_.projections && spot.triangle != kNone; ++k) {
      spend(1);
      const double then = cost + mesh_.change_with(spot);
      if (!(then < kInfinite)) return;
      if (then < action.cost - 1e-12) action = {then, vertex, spot};
      if (then < 1e-12 || k == tuning_.projections) return;
      const Point p = projected(spot);
      spot = spot.edge.has_value() ? mesh_.on_line(p, spot.triangle, *spot.edge)
                                   : mesh_.locate(p, spot.triangle);
    }
  }

  /// `spot`, moved towards where all triangles on its rim would be good.
  [[nodiscard]] Point projected(const Spot& spot) const {
    Point p = spot.at;
    const bool on_line = spot.edge.has_value();
    for (int cycle = 0; cycle < tuning_.cycles; ++cycle) {
      for (const RimEdge& e : mesh_.rim()) {
        const Point a = mesh_.at(e.a), b = mesh_.at(e.b);
        const Vector ab = b - a;
        const double length2 = squared_length(ab), along = dot(p - a, ab) / length2;
        if (along < 0) p = p + (-along * tuning_.beyond) * ab;
        if (along > 1) p = p + ((1 - along) * tuning_.beyond) * ab;
        const Point m = midpoint(a, b);
        const double far2 = squared_length(p - m);
        if (far2 < length2 / 4 && far2 > 0)
          p = m + (tuning_.beyond * std::sqrt(length2 / 4 / far2)) * (p - m);
      }
      if (on_line) p = mesh_.on_line(p, spot.triangle, *spot.edge).at;
    }
    return p;
  }

  MeshWithUndo& mesh_;
  const ThinEffort& effort_;
  Tuning tuning_;
  Random random_;
  std::uint64_t left_ = 0, left_to_mend_ = 0;
  std::size_t most_beyond_;  ///< triangles that may be worse than any should be
  std::size_t most_grave_ = 0;
  std::size_t most_signs_ = kNone;     ///< triangles that are bad, but not gravely
  std::uint32_t focus_ = kNone;        ///< a triangle that is to be mended
  std::vector<std::uint32_t> spares_;  ///< vertices that were taken away
  std::vector<Point> starts_;          ///< where they had been
  std::vector<std::uint32_t> tabu_, bad_;
};

}  // namespace

Thinned thin_mesh(MeshWithUndo& mesh, const ThinEffort& effort) {
  return Thinner(mesh, effort).run();
}

Thinned mend_what_is_left(MeshWithUndo& mesh, const ThinEffort& effort) {
  return Thinner(mesh, effort).run_on_what_is_left();
}

Thinned mend_mesh(MeshWithUndo& mesh, const ThinEffort& effort, std::uint64_t places_per_sign) {
  return Thinner(mesh, effort).run_on_grave_ones(places_per_sign);
}

}  // namespace cover
