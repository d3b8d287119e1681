// Segments are sorted by (left, right, name); each group is one interface. A chain follows segments
// of the group from end to end as long as exactly one goes on.
// Tested by tests/unit/region/region_graph_test.cpp.
#include "region/interfaces.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/core.h>

#include "base/none.hpp"
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

constexpr std::uint32_t kSeveral = kNone - 1;

/// Steps that start and end at a vertex: one, none (kNone) or kSeveral.
struct StepsAtVertex {
  std::uint32_t starts = kNone, ends = kNone;
};
using StepsAtVertices = std::vector<StepsAtVertex>;

/// The segments of one interface in the order of its chains.
class Chains {
 public:
  /// `at` has no steps, before and after.
  Chains(const Pslg& pslg, const RegionTable& table, RegionId left,
         std::span<const SegmentId> segments, StepsAtVertices& at)
      : pslg_(pslg) {
    steps_.reserve(segments.size());
    for (const SegmentId s : segments) {
      const Segment& segment = pslg.segments[s.index()];
      const bool forward = table.sides[s.index()].left == left;
      steps_.push_back({forward ? segment.a : segment.b, forward ? segment.b : segment.a, s});
    }
    link(at);
  }

  /// First chains that have a beginning, then closed ones, each from its lowest point on.
  std::vector<SegmentId> in_order() {
    std::vector<SegmentId> out;
    out.reserve(steps_.size());
    std::vector<std::uint32_t> starts;
    for (std::uint32_t k = 0; k < steps_.size(); ++k) {
      if (!has_one_before_[k]) starts.push_back(k);
    }
    follow(starts, out);
    starts.clear();
    std::vector<bool> seen(steps_.size(), false);
    for (std::uint32_t k = 0; k < steps_.size(); ++k) {
      if (used_[k] || seen[k]) continue;
      std::uint32_t lowest = k;
      for (std::uint32_t j = k; !seen[j]; j = next_[j]) {
        seen[j] = true;
        if (is_before(j, lowest)) lowest = j;
      }
      starts.push_back(lowest);
    }
    follow(starts, out);
    return out;
  }

 private:
  struct Step {
    VertexId from, to;
    SegmentId segment;
  };

  [[nodiscard]] bool is_before(std::uint32_t j, std::uint32_t k) const {
    const auto at = [this](VertexId v) { return pslg_.points[v.index()]; };
    return std::tuple(at(steps_[j].from), at(steps_[j].to)) <
           std::tuple(at(steps_[k].from), at(steps_[k].to));
  }

  /// A step goes on in another where it alone ends and the other alone starts.
  void link(StepsAtVertices& at) {
    for (std::uint32_t k = 0; k < steps_.size(); ++k) {
      add(at[steps_[k].from.index()].starts, k);
      add(at[steps_[k].to.index()].ends, k);
    }
    next_.assign(steps_.size(), kNone);
    has_one_before_.assign(steps_.size(), false);
    used_.assign(steps_.size(), false);
    for (std::uint32_t k = 0; k < steps_.size(); ++k) {
      const StepsAtVertex& here = at[steps_[k].to.index()];
      if (here.ends != k || here.starts >= kSeveral) continue;
      next_[k] = here.starts;
      has_one_before_[here.starts] = true;
    }
    for (const Step& step : steps_) at[step.from.index()] = at[step.to.index()] = {};
  }

  static void add(std::uint32_t& known, std::uint32_t step) {
    known = known == kNone ? step : kSeveral;
  }

  /// Chains from these steps on, which are put in order.
  void follow(std::vector<std::uint32_t>& starts, std::vector<SegmentId>& out) {
    std::sort(starts.begin(), starts.end(),
              [this](std::uint32_t j, std::uint32_t k) { return is_before(j, k); });
    for (const std::uint32_t start : starts) {
      for (std::uint32_t k = start; k != kNone && !used_[k]; k = next_[k]) {
        used_[k] = true;
        out.push_back(steps_[k].segment);
      }
    }
  }

  const Pslg& pslg_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> next_;  ///< by step
  std::vector<bool> has_one_before_, used_;
};

InterfaceKind kind_of(const Key& key) {
  if (key.name != 0) return InterfaceKind::contact;
  if (key.right == kVoid) return InterfaceKind::outline;
  return key.left == key.right ? InterfaceKind::slit : InterfaceKind::interface;
}

/// Of a line without a name of its own. Of an interface it is that of the left region first.
std::string made_name(const RegionTable& table, const Key& key) {
  const std::string& left = table.region(key.left).name;
  switch (kind_of(key)) {
    case InterfaceKind::outline:
      return left + "_outline";
    case InterfaceKind::slit:
      return left + "_slit";
    default:
      return left + "_" + table.region(key.right).name;
  }
}

/// Turns lines between regions of two names, of which each may be the left one, all alike: as the
/// first of them lies.
class SharedNames {
 public:
  explicit SharedNames(const RegionTable& table) : first_(table.regions.size()) {
    std::unordered_map<std::string_view, std::uint32_t> first;
    for (std::uint32_t r = 0; r < first_.size(); ++r) {
      const auto [known, is_new] = first.emplace(table.regions[r].name, r);
      first_[r] = known->second;
      are_any_ |= !is_new;
    }
  }

  Key turned(Key key) {
    if (!are_any_ || kind_of(key) != InterfaceKind::interface) return key;
    const std::uint64_t left = first_[place_of(key.left)], right = first_[place_of(key.right)];
    if (pairs_.contains(right << 32 | left))
      std::swap(key.left, key.right);
    else
      pairs_.insert(left << 32 | right);
    return key;
  }

 private:
  std::vector<std::uint32_t> first_;  ///< by region: the first of that name
  bool are_any_ = false;
  std::unordered_set<std::uint64_t> pairs_;  ///< of names, the left one above
};

/// Names lines. A name that the input gives is no other line's, as solvers put electrodes on it: a
/// made one gives way, to what is no made name of another line either.
class Namer {
 public:
  using Keyed = std::vector<std::pair<Key, SegmentId>>;

  /// REQUIRES: all outlive this
  Namer(const Pslg& pslg, const RegionTable& table, const Keyed& keyed)
      : pslg_(pslg),
        table_(table),
        keyed_(keyed),
        shared_(table),
        given_(pslg.names.begin(), pslg.names.end()) {}

  std::string name_of(const Key& key) {
    if (kind_of(key) == InterfaceKind::contact) return pslg_.names[key.name];
    std::string made = made_name(table_, shared_.turned(key));
    if (!given_.contains(made)) return made;
    const auto [way, is_new] = ways_given_.try_emplace(made);
    std::string& name = way->second;
    if (!is_new) return name;
    if (made_.empty()) collect_made();
    for (int k = 2; name.empty() || given_.contains(name) || !made_.insert(name).second; ++k)
      name = fmt::format("{}_{}", made, k);
    return name;
  }

 private:
  void collect_made() {
    for (const auto& [key, segment] : keyed_) {
      if (kind_of(key) != InterfaceKind::contact) made_.insert(made_name(table_, key));
    }
  }

  const Pslg& pslg_;
  const RegionTable& table_;
  const Keyed& keyed_;
  SharedNames shared_;
  std::set<std::string_view> given_;
  std::set<std::string> made_;                     ///< empty until one is to give way
  std::map<std::string, std::string> ways_given_;  ///< by made name: what it gave way to
};

}  // namespace

void build_interfaces(const Pslg& pslg, RegionTable& table) {
  std::vector<std::pair<Key, SegmentId>> keyed;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Key key = key_of(table.sides[s], pslg.segments[s]);
    if (key.left != kVoid) keyed.emplace_back(key, SegmentId{s});
  }
  if (!std::is_sorted(keyed.begin(), keyed.end())) std::sort(keyed.begin(), keyed.end());
  Namer namer(pslg, table, keyed);
  std::vector<SegmentId> group;
  StepsAtVertices at(pslg.points.size());
  for (std::size_t k = 0; k < keyed.size();) {
    const Key key = keyed[k].first;
    group.clear();
    while (k < keyed.size() && keyed[k].first == key) group.push_back(keyed[k++].second);
    Interface line;
    line.id = InterfaceId{table.interfaces.size() + 1};
    line.kind = kind_of(key);
    line.name = namer.name_of(key);
    line.left = key.left;
    line.right = key.right;
    line.segments = Chains(pslg, table, key.left, group, at).in_order();
    for (const SegmentId s : line.segments) {
      const Segment& segment = pslg.segments[s.index()];
      line.length += length(pslg.points[segment.b.index()] - pslg.points[segment.a.index()]);
      table.sides[s.index()].interface = line.id;
    }
    table.interfaces.push_back(std::move(line));
  }
}

}  // namespace cover
