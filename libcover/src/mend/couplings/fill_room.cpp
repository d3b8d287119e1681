// Tested by tests/unit/mend/couplings/delaunay_within_bound_test.cpp.
#include "mend/couplings/fill_room.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "base/containers/order.hpp"
#include "base/numbers.hpp"
#include "base/random.hpp"
#include "mend/effort.hpp"

namespace cover {
namespace {

/// Of costs, for other ways than the first one; a bad triangle is 0.4.
constexpr double kNoise = 0.4;

class RoomFiller {
 public:
  RoomFiller(MeshWithUndo& mesh, const HalfDiscRoom& room) : mesh_(mesh), room_(room) {
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
      if (is_grave(t)) first_.push_back(t);
    }
  }

  bool run(std::size_t most_grave, int most_circles, const std::stop_token& stop) {
    for (int k = 0; k < effort::mend::kFillings && !is_hopeless_ && circles_ < most_circles &&
                    !stop.stop_requested();
         ++k) {
      int added = 0;
      while (mesh_.grave() > most_grave && added < effort::mend::kMostFilled &&
             add(k == 0 ? 0 : kNoise))
        ++added;
      if (mesh_.grave() <= most_grave) {
        mesh_.keep();
        return true;
      }
      is_hopeless_ = is_hopeless_ || added == 0;
      mesh_.undo(0);
    }
    return false;
  }

 private:
  [[nodiscard]] bool is_grave(std::uint32_t t) const {
    const MeshWithUndo::Triangle& triangle = mesh_.triangles()[t];
    return triangle.v[0] != kNone && MeshWithUndo::is_grave(triangle);
  }

  /// One of those that there are.
  std::uint32_t a_grave_triangle() {
    std::vector<std::uint32_t> found;
    for (const std::vector<std::uint32_t>& list : {first_, mesh_.written_since(0)}) {
      for (const std::uint32_t t : list) {
        if (is_grave(t)) found.push_back(t);
      }
    }
    sort_unique(found);
    return found.empty() ? kNone : found[random_.below(found.size())];
  }

  /// Attempts begin alike, so what was found for a circle is kept.
  const std::vector<Point>& places_in(const std::array<Point, 3>& corners) {
    const auto [it, is_new] = found_.try_emplace(corners);
    if (is_new) it->second = room_.within_circle(corners, effort::mend::kPlacesInCircle).places;
    return it->second;
  }

  /// A vertex in the circle of a triangle that is gravely bad, without which it stays.
  bool add(double noise) {
    const std::uint32_t t = a_grave_triangle();
    if (t == kNone) return false;
    ++circles_;
    const auto& v = mesh_.triangles()[t].v;
    std::vector<Point> places = places_in({mesh_.at(v[0]), mesh_.at(v[1]), mesh_.at(v[2])});
    for (std::size_t k = 0; k < std::min(effort::mend::kPlacesInCircle, places.size()); ++k)
      std::swap(places[k], places[k + random_.below(places.size() - k)]);
    if (places.size() > effort::mend::kPlacesInCircle) places.resize(effort::mend::kPlacesInCircle);
    Spot best;
    double least = kInfinity;
    for (const Point& place : places) {
      const Spot spot = mesh_.locate(place, t);
      if (spot.triangle == kNone || spot.edge) continue;
      const double cost = mesh_.change_with(spot) + noise * random_.unit();
      if (cost < least) least = cost, best = spot;
    }
    return best.triangle != kNone && mesh_.insert(best) != kNone;
  }

  MeshWithUndo& mesh_;
  const HalfDiscRoom& room_;
  Random random_;
  std::map<std::array<Point, 3>, std::vector<Point>> found_;  ///< by the corners on a circle
  std::vector<std::uint32_t> first_;                          ///< gravely bad at first
  int circles_ = 0;                                           ///< searched so far
  bool is_hopeless_ = false;
};

}  // namespace

bool fill_room(MeshWithUndo& mesh, const HalfDiscRoom& room, std::size_t most_grave,
               int most_circles, const std::stop_token& stop) {
  mesh.keep();
  return RoomFiller(mesh, room).run(most_grave, most_circles, stop);
}

}  // namespace cover
