// Points that only one of two periodic lines has are put on the other.
#pragma once

#include <map>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

#include "cuts/periodic/match_sides.hpp"
#include "cuts/periodic/named_line.hpp"

namespace cover {

/// Puts the points that only one of two lines has on the other, and tells so.
class SidesCompletion {
 public:
  SidesCompletion(Pslg& pslg, RegionTable& table, Report& report)
      : pslg_(pslg), table_(table), report_(report) {}

  /// Whether anything was cut.
  ///
  /// REQUIRES: `match` is match_sides() of `rule`
  /// Errors:   bad_option, with places, where a point has no room on the other line, or a segment
  ///           between matched points has no image
  Result<bool> complete(const PeriodicRule& rule, const SidesMatch& match);

 private:
  struct Lost {
    double distance = 0;
    VertexId vertex;
    Point image;
  };

  void place(VertexId v, const Isometry& map, const NamedLine& line, double tolerance);
  void tell(const PeriodicRule& rule, SegmentId s, const std::vector<Point>& points);
  [[nodiscard]] double extent_of(const PeriodicRule& rule) const;
  [[nodiscard]] double widest_gap(const PeriodicRule& rule, const SidesMatch& match) const;
  [[nodiscard]] Error mismatch(const PeriodicRule& rule, const SidesMatch& match) const;
  [[nodiscard]] Error lone_segments(const PeriodicRule& rule, const SidesMatch& match) const;

  Pslg& pslg_;
  RegionTable& table_;
  Report& report_;
  std::map<SegmentId, std::vector<Point>> cuts_;
  std::vector<Lost> lost_;
};

}  // namespace cover
