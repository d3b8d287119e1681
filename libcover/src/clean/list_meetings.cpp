// One sweep finds the common points of all segments; each point is then looked at alone, so that a
// thousand segments through one point make one sentence and not half a million.
// Tested by tests/unit/clean/pslg_test.cpp.
#include "clean/list_meetings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <vector>

#include <cover/text.hpp>

#include "base/faults/complaint.hpp"
#include "base/none.hpp"
#include "geom/predicates.hpp"
#include "geom/subdivision/exact_subdivision.hpp"

namespace cover {
namespace {

/// A segment, or a lone point, on its way through a node.
struct Visit {
  std::uint32_t node = 0;
  std::uint32_t line = 0;
  std::uint32_t before = kNone;  ///< the nodes beside it on the line
  std::uint32_t after = kNone;
  friend auto operator<=>(const Visit&, const Visit&) = default;
  [[nodiscard]] bool is_inside() const { return before != kNone && after != kNone; }
};

class Lister {
 public:
  explicit Lister(const Input& input)
      : input_(input),
        crossings_(ErrorCode::crossing_segments, input.source),
        overlaps_(ErrorCode::overlapping_segments, input.source),
        touches_(ErrorCode::point_on_segment, input.source) {}

  std::optional<Error> list() {
    sweep();
    for (std::size_t k = 0; k < visits_.size();) {
      std::size_t end = k;
      while (end < visits_.size() && visits_[end].node == visits_[k].node) ++end;
      look({visits_.data() + k, end - k});
      k = end;
    }
    crossings_.append(overlaps_);
    crossings_.append(touches_);
    if (crossings_.empty()) return {};
    return crossings_.error();
  }

 private:
  [[nodiscard]] bool is_point(std::uint32_t line) const { return line >= input_.segments.size(); }

  void sweep() {
    std::vector<PlainSegment> lines;
    std::vector<bool> is_end(input_.points.size(), false);
    for (const InputSegment& s : input_.segments) {
      lines.push_back({input_.points[s.a], input_.points[s.b]});
      is_end[s.a] = is_end[s.b] = true;
    }
    for (std::uint32_t k = 0; k < is_end.size(); ++k) {
      if (is_end[k]) continue;
      lines.push_back({input_.points[k], input_.points[k]});
      lone_.push_back(k);
    }
    Subdivision cuts = subdivide(lines);
    nodes_ = std::move(cuts.nodes);
    for (std::uint32_t line = 0; line < lines.size(); ++line) {
      const auto path = cuts.path_of(line);
      const std::size_t steps = is_point(line) ? 1 : path.size();
      for (std::size_t i = 0; i < steps; ++i) {
        visits_.push_back(
            {path[i], line, i > 0 ? path[i - 1] : kNone, i + 1 < steps ? path[i + 1] : kNone});
      }
    }
    std::sort(visits_.begin(), visits_.end());
  }

  void look(std::span<const Visit> visits) {
    std::vector<std::uint32_t> through;  // one line of each direction that passes
    for (const Visit& v : visits) {
      if (v.is_inside() && std::none_of(through.begin(), through.end(), [&](std::uint32_t line) {
            return are_parallel(line, v.line);
          })) {
        through.push_back(v.line);
        if (through.size() > 2) break;  // three are as good as a thousand
      }
    }
    if (through.size() > 1) return add_crossing(visits, through);
    if (add_overlap(visits) || through.empty()) return;
    for (const Visit& v : visits) {
      if (!v.is_inside() && (is_point(v.line) || !are_parallel(v.line, through[0])))
        return add_touch(v, through[0]);
    }
  }

  /// REQUIRES: the two have a point in common
  [[nodiscard]] bool are_parallel(std::uint32_t s, std::uint32_t t) const {
    const auto [a, b] = ends(s);
    const auto [c, d] = ends(t);
    return orientation(a, b, c) == Sign::zero && orientation(a, b, d) == Sign::zero;
  }
  [[nodiscard]] std::pair<Point, Point> ends(std::uint32_t line) const {
    const InputSegment& s = input_.segments[line];
    return {input_.points[s.a], input_.points[s.b]};
  }

  [[nodiscard]] InputRef ref(std::uint32_t line) const {
    return {InputKind::segment, input_.segments[line].id};
  }

  void add_crossing(std::span<const Visit> visits, const std::vector<std::uint32_t>& through) {
    std::vector<InputRef> inputs;
    for (const Visit& v : visits) {
      if (v.is_inside()) inputs.push_back(ref(v.line));
    }
    const std::string first = name_of_segment(input_, through[0]);
    const std::string second = name_of_segment(input_, through[1]);
    const std::string near = describe(nodes_[visits[0].node]);
    std::string message = inputs.size() == 2
                              ? fmt::format("{} crosses {} near {}", first, second, near)
                              : fmt::format("{} crosses {} and {} near {}", first, second,
                                            counted(inputs.size() - 2, "more segment"), near);
    crossings_.add(std::move(message), {nodes_[visits[0].node]}, std::move(inputs));
  }

  /// Complains of lines that run on to the same node, if they do not come from one too.
  bool add_overlap(std::span<const Visit> visits) {
    std::vector<Visit> on(visits.begin(), visits.end());
    std::erase_if(on, [](const Visit& v) { return v.after == kNone; });
    std::sort(on.begin(), on.end(), [](const Visit& v, const Visit& w) {
      return std::pair(v.after, v.line) < std::pair(w.after, w.line);
    });
    bool any = false;
    for (std::size_t k = 0; k < on.size();) {
      std::size_t end = k;
      bool starts = false;
      while (end < on.size() && on[end].after == on[k].after) {
        starts |= on[end++].before == kNone;
      }
      if (starts && end - k > 1) {
        std::vector<InputRef> inputs;
        for (std::size_t i = k; i < end; ++i) inputs.push_back(ref(on[i].line));
        const std::string more =
            end - k > 2 ? " and " + counted(end - k - 2, "more segment") : std::string();
        overlaps_.add(
            fmt::format("{} and {}{} overlap from {} on", name_of_segment(input_, on[k].line),
                        name_of_segment(input_, on[k + 1].line), more,
                        describe(nodes_[on[k].node])),
            {nodes_[on[k].node]}, std::move(inputs));
        any = true;
      }
      k = end;
    }
    return any;
  }

  /// The end of a line, or a lone point, inside another line.
  void add_touch(const Visit& visit, std::uint32_t line) {
    std::uint32_t point = 0;
    if (is_point(visit.line)) {
      point = lone_[visit.line - input_.segments.size()];
    } else {
      const InputSegment& s = input_.segments[visit.line];
      point = input_.points[s.a] == nodes_[visit.node] ? s.a : s.b;
    }
    touches_.add(fmt::format("{} lies inside {}", name_of_point(input_, point),
                             name_of_segment(input_, line)),
                 {input_.points[point]}, {{InputKind::point, point_id(input_, point)}, ref(line)});
  }

  const Input& input_;
  std::vector<std::uint32_t> lone_;  ///< points that end no segment
  std::vector<Point> nodes_;
  std::vector<Visit> visits_;  ///< node by node
  Complaint crossings_, overlaps_, touches_;
};

}  // namespace

std::optional<Error> list_meetings(const Input& input) { return Lister(input).list(); }

}  // namespace cover
