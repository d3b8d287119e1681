// Segments are sorted by (left, right, name); each group is one interface. A chain follows segments
// of the group from end to end as long as exactly one goes on.
// Tested by tests/unit/region/region_graph_test.cpp.
#include "region/interfaces.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <tuple>

#include "geom/vector.hpp"

namespace cover {
namespace {

/// What the interface of a segment is told by.
struct Key {
  RegionId left;  ///< the lower region that is not the void
  RegionId right;
  std::uint32_t name = 0;
  friend auto operator<=>(const Key&, const Key&) = default;
};

Key key_of(const SegmentSides& sides, const Segment& segment) {
  auto [low, high] = std::minmax(sides.left, sides.right);
  return low == kVoid ? Key{high, kVoid, segment.name} : Key{low, high, segment.name};
}

/// The segments of one interface in the order of its chains.
class Chains {
 public:
  Chains(const Pslg& pslg, const RegionTable& table, RegionId left,
         std::span<const SegmentId> segments)
      : pslg_(pslg) {
    for (const SegmentId s : segments) {
      const Segment& segment = pslg.segments[s.index()];
      const bool forward = table.sides[s.index()].left == left;
      steps_.push_back({forward ? segment.a : segment.b, forward ? segment.b : segment.a, s});
    }
    std::sort(steps_.begin(), steps_.end(), [this](const Step& x, const Step& y) {
      return std::tuple(at(x.from), at(x.to)) < std::tuple(at(y.from), at(y.to));
    });
    arrivals_.reserve(steps_.size());
    for (const Step& step : steps_) arrivals_.push_back(at(step.to));
    std::sort(arrivals_.begin(), arrivals_.end());
    used_.assign(steps_.size(), false);
  }

  std::vector<SegmentId> in_order() {
    std::vector<SegmentId> out;
    out.reserve(steps_.size());
    // First chains that have a beginning, then closed ones.
    for (const bool closed : {false, true}) {
      for (std::size_t k = 0; k < steps_.size(); ++k) {
        if (used_[k] || (!closed && goes_through(steps_[k].from))) continue;
        follow(k, out);
      }
    }
    return out;
  }

 private:
  struct Step {
    VertexId from, to;
    SegmentId segment;
  };

  [[nodiscard]] Point at(VertexId v) const { return pslg_.points[v.index()]; }

  /// The steps that start at a vertex.
  [[nodiscard]] std::span<const Step> departures(VertexId v) const {
    const auto [begin, end] =
        std::equal_range(steps_.begin(), steps_.end(), Step{v, v, {}},
                         [this](const Step& x, const Step& y) { return at(x.from) < at(y.from); });
    return {begin, end};
  }

  /// One step ends and one starts here.
  [[nodiscard]] bool goes_through(VertexId v) const {
    const auto [begin, end] = std::equal_range(arrivals_.begin(), arrivals_.end(), at(v));
    return end - begin == 1 && departures(v).size() == 1;
  }

  void follow(std::size_t k, std::vector<SegmentId>& out) {
    for (;;) {
      used_[k] = true;
      out.push_back(steps_[k].segment);
      const VertexId end = steps_[k].to;
      if (!goes_through(end)) return;
      k = static_cast<std::size_t>(departures(end).data() - steps_.data());
      if (used_[k]) return;
    }
  }

  const Pslg& pslg_;
  std::vector<Step> steps_;      ///< by start
  std::vector<Point> arrivals_;  ///< ends of all steps, sorted
  std::vector<bool> used_;
};

InterfaceKind kind_of(const Key& key) {
  if (key.name != 0) return InterfaceKind::contact;
  if (key.right == kVoid) return InterfaceKind::outline;
  return key.left == key.right ? InterfaceKind::slit : InterfaceKind::interface;
}

std::string name_of(const Pslg& pslg, const RegionTable& table, const Key& key) {
  const std::string& left = table.region(key.left).name;
  switch (kind_of(key)) {
    case InterfaceKind::contact:
      return pslg.names[key.name];
    case InterfaceKind::outline:
      return left + "_outline";
    case InterfaceKind::slit:
      return left + "_slit";
    case InterfaceKind::interface:
      break;
  }
  return left + "_" + table.region(key.right).name;
}

}  // namespace

void build_interfaces(const Pslg& pslg, RegionTable& table) {
  std::vector<std::pair<Key, SegmentId>> keyed;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Key key = key_of(table.sides[s], pslg.segments[s]);
    if (key.left != kVoid) keyed.emplace_back(key, SegmentId{s});
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<SegmentId> group;
  for (std::size_t k = 0; k < keyed.size();) {
    const Key key = keyed[k].first;
    group.clear();
    while (k < keyed.size() && keyed[k].first == key) group.push_back(keyed[k++].second);
    Interface line;
    line.id = InterfaceId{table.interfaces.size() + 1};
    line.kind = kind_of(key);
    line.name = name_of(pslg, table, key);
    line.left = key.left;
    line.right = key.right;
    line.segments = Chains(pslg, table, key.left, group).in_order();
    for (const SegmentId s : line.segments) {
      const Segment& segment = pslg.segments[s.index()];
      line.length += length(pslg.points[segment.b.index()] - pslg.points[segment.a.index()]);
      table.sides[s.index()].interface = line.id;
    }
    table.interfaces.push_back(std::move(line));
  }
}

}  // namespace cover
