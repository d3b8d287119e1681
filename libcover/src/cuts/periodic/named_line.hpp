// The lines that rules speak of, and what is said where a rule does not hold.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>

namespace cover {

inline constexpr std::size_t kUnmatchedTold = 10;  ///< places with an error

/// The segments of a name.
struct NamedLine {
  std::vector<SegmentId> segments;  ///< in order
  std::vector<VertexId> vertices;   ///< in order, once each
};

/// That of named_segments(); without segments where there is none.
///
/// Cost: O(n log n)
NamedLine find_line(const Pslg& pslg, const RegionTable& table, const std::string& name);

/// bad_option: `what` keeps the lines of `rule` from being periodic.
Error periodic_error(const PeriodicRule& rule, const std::string& what,
                     std::vector<Point> where = {});

}  // namespace cover
