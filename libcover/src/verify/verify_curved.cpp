// Tested by tests/unit/verify/verify_curved_test.cpp.
#include <cover/text.hpp>
#include <cover/verify_curved.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "geom/curves/arc.hpp"
#include "geom/topology/corner.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr std::size_t kMostListed = 10;
constexpr double kOffMiddle = 0x1p-40;  ///< of an edge and its place

class CurvedVerifier {
 public:
  CurvedVerifier(const Pslg& pslg, const TriangleSoup& mesh,
                 std::span<const std::array<Point, 3>> middles)
      : pslg_(pslg), mesh_(mesh), middles_(middles) {}

  CurvedVerification run() {
    check_triangles();
    check_segments();
    return std::move(result_);
  }

 private:
  using Ends = std::pair<Point, Point>;

  void add(std::string message, std::vector<Point> where) {
    if (result_.violations.size() < kMostListed)
      result_.violations.push_back({2, std::move(message), std::move(where)});
    ++result_.violation_count;
  }

  void check_triangles() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      CurvedTriangle triangle;
      for (const Corner i : kCorners) {
        triangle[i] = mesh_.points[mesh_.triangles[t][i]];
        triangle[3 + i] = middles_[t][i];
      }
      if (!has_positive_jacobian(triangle))
        add(fmt::format("triangle {} at {}, {}, {}: its Jacobian is not positive everywhere", t,
                        describe(triangle[0]), describe(triangle[1]), describe(triangle[2])),
            {triangle[0], triangle[1], triangle[2]});
      for (const Corner i : kCorners) check_edge(triangle[i], triangle[i.next()], triangle[3 + i]);
    }
  }

  /// The triangle on the other side of an edge has the same node.
  void check_edge(Point a, Point b, Point middle) {
    const auto [at, is_new] = middle_.emplace(Ends(std::min(a, b), std::max(a, b)), middle);
    if (!is_new && at->second != middle)
      add(fmt::format("the edge from {} to {} has two middle nodes, {} and {}", describe(a),
                      describe(b), describe(at->second), describe(middle)),
          {at->second, middle});
  }

  void check_segments() {
    for (const Segment& s : pslg_.segments) {
      const Point a = pslg_.points[s.a.index()], b = pslg_.points[s.b.index()];
      const auto found = middle_.find(Ends(std::min(a, b), std::max(a, b)));
      if (found == middle_.end()) continue;  // verify_cover() finds what is no edge
      const Point m = found->second, straight = midpoint(a, b);
      const double size =
          std::max({length(b - a), std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
      const auto is_at = [&](Point p) { return length(m - p) <= kOffMiddle * size; };
      const ArcCircle* circle = circle_of(pslg_, s);
      if (circle != nullptr && is_at(ArcOver(*circle, a, b).middle())) {
        ++result_.on_arcs;
      } else if (is_at(straight)) {
        result_.straight += circle != nullptr ? 1 : 0;
      } else {
        add(fmt::format("the middle node {} of the edge from {} to {} is not {}in the middle of "
                        "the segment",
                        describe(m), describe(a), describe(b),
                        circle != nullptr ? "on the arc, nor " : ""),
            {m});
      }
    }
  }

  const Pslg& pslg_;
  const TriangleSoup& mesh_;
  std::span<const std::array<Point, 3>> middles_;
  std::map<Ends, Point> middle_;  ///< by the ends of its edge
  CurvedVerification result_;
};

}  // namespace

CurvedVerification verify_curved(const Pslg& pslg, const TriangleSoup& mesh,
                                 std::span<const std::array<Point, 3>> middles) {
  return CurvedVerifier(pslg, mesh, middles).run();
}

}  // namespace cover
