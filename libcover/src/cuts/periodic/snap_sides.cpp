// Tested by tests/unit/cuts/periodic/periodic_sides_test.cpp.
#include "cuts/periodic/snap_sides.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "geom/isometry.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kRoundingOfDigits = 0x1p-49;  ///< of the largest coordinate: not told

/// Moves the points of each class to the images of one of them.
class Snapping {
 public:
  Snapping(Pslg& pslg, const std::vector<SidesMatch>& matches) : pslg_(pslg), matches_(matches) {
    untold_ = kRoundingOfDigits * largest_coordinate(pslg.points);
  }

  /// Whether anything moved. Changes beyond rounding are appended to `changes`.
  bool run(std::vector<Change>& changes) {
    link();
    std::vector<std::uint8_t> done(pslg_.points.size(), 0);
    bool has_moved = false;
    // A point that is no image first, or images would be rounded twice.
    for (const bool only_origins : {true, false}) {
      for (const auto& [v, links] : links_) {
        const bool is_image =
            std::any_of(links.begin(), links.end(), [](const Link& link) { return link.is_back; });
        if (done[v.index()] != 0 || (only_origins && is_image)) continue;
        has_moved |= spread(v, done, changes);
      }
    }
    return has_moved;
  }

 private:
  struct Link {
    VertexId to;
    std::size_t rule = 0;
    bool is_back = false;
  };

  void link() {
    for (std::size_t r = 0; r < matches_.size(); ++r) {
      for (const auto& [v, image] : matches_[r].vertices) {
        if (v == image) continue;
        links_[v].push_back({image, r, false});
        links_[image].push_back({v, r, true});
      }
    }
  }

  bool spread(VertexId root, std::vector<std::uint8_t>& done, std::vector<Change>& changes) {
    bool has_moved = false;
    std::vector<VertexId> queue{root};
    done[root.index()] = 1;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const VertexId v = queue[head];
      for (const Link& link : links_.at(v)) {
        if (done[link.to.index()] != 0) continue;
        done[link.to.index()] = 1;
        queue.push_back(link.to);
        const Isometry& map = matches_[link.rule].map;
        const Point image = image_of(link.is_back ? inverse_of(map) : map, pslg_.points[v.index()]);
        Point& p = pslg_.points[link.to.index()];
        if (p == image) continue;
        tell(link.to, image, changes);
        p = image;
        has_moved = true;
      }
    }
    return has_moved;
  }

  void tell(VertexId v, Point image, std::vector<Change>& changes) const {
    const Point p = pslg_.points[v.index()];
    const long id = pslg_.point_ids[v.index()];
    if (id < 0 || length(image - p) <= untold_) return;
    changes.push_back(
        {Change::Kind::welded,
         fmt::format("point {} at {} was moved by {} to {}, where the other periodic "
                     "side asks for it",
                     id, describe(p), describe_roughly(length(image - p)), describe(image)),
         {p, image},
         {{InputKind::point, id}}});
  }

  Pslg& pslg_;
  const std::vector<SidesMatch>& matches_;
  double untold_ = 0;
  std::map<VertexId, std::vector<Link>> links_;
};

}  // namespace

bool snap_sides(Pslg& pslg, const std::vector<SidesMatch>& matches, std::vector<Change>& changes) {
  return Snapping(pslg, matches).run(changes);
}

}  // namespace cover
