// Tested by tests/unit/cuts/periodic/periodic_sides_test.cpp.
#include "cuts/periodic/periodic_sides.hpp"

#include <algorithm>
#include <utility>

#include <cover/option_ranges.hpp>

#include "clean/change_report.hpp"
#include "cuts/cut_segments.hpp"
#include "cuts/periodic/complete_sides.hpp"
#include "cuts/periodic/match_sides.hpp"
#include "cuts/periodic/named_line.hpp"
#include "cuts/periodic/snap_sides.hpp"
#include "options/periodic_rule.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

bool has_same_sides(const RegionTable& x, const RegionTable& y) {
  return std::equal(x.sides.begin(), x.sides.end(), y.sides.begin(), y.sides.end(),
                    [](const SegmentSides& s, const SegmentSides& t) {
                      return s.left == t.left && s.right == t.right;
                    });
}

/// Matches of all rules, with all points on both sides.
Result<std::vector<SidesMatch>> match_all(Pslg& pslg, RegionTable& table,
                                          const std::vector<PeriodicRule>& rules, double tolerance,
                                          Report& report) {
  SidesCompletion completion(pslg, table, report);
  // A point goes from line to line, so no more rounds are needed than there are rules.
  for (std::size_t round = 0; round <= rules.size() + 1; ++round) {
    std::vector<SidesMatch> matches;
    bool has_cut = false;
    for (const PeriodicRule& rule : rules) {
      Result<SidesMatch> match = match_sides(pslg, table, rule, tolerance);
      if (!match) return std::move(match).error();
      const Result<bool> cut = completion.complete(rule, *match);
      if (!cut) return cut.error();
      has_cut |= *cut;
      matches.push_back(*std::move(match));
    }
    if (!has_cut) return matches;
  }
  return periodic_error(rules[0],
                        "the rules ask for points without end: are they all of one cell?");
}

}  // namespace

Status join_periodic_sides(Pslg& pslg, RegionTable& table, const std::vector<PeriodicRule>& rules,
                           const Options& options, Report& report) {
  if (rules.empty()) return ok();
  if (options.method == Method::nonobtuse)
    return Error{ErrorCode::bad_option,
                 "method nonobtuse cuts segments by itself, so it does not go with periodic sides",
                 {},
                 {}};
  for (const PeriodicRule& rule : rules) {
    if (Status good = check_rule(rule); !good) return good;
  }
  const std::size_t changes = report.changes.size();
  // What welding may move, for ends that are to be one, may move for ends that are to be images.
  const double tolerance = std::max(kAutoWeld, options.weld.value_or(0));
  Result<std::vector<SidesMatch>> matches = match_all(pslg, table, rules, tolerance, report);
  if (!matches) return std::move(matches).error();
  const bool has_moved = snap_sides(pslg, *matches, report.changes);
  if (options.strict && report.changes.size() > changes) {
    const Change& first = report.changes[changes];
    return Error{ErrorCode::changed_input, first.message, first.where, first.inputs};
  }
  sum_up({report.changes.begin() + static_cast<std::ptrdiff_t>(changes), report.changes.end()},
         report.notes);
  if (has_moved || report.changes.size() > changes) {
    if (!triangulate_whole(pslg).conflicts.empty())
      return periodic_error(rules[0], "points moved to their images make segments cross");
    std::vector<Note> known;  // told already
    Result<RegionTable> again = build_region_table(pslg, options, known);
    if (!again) return std::move(again).error();
    if (!has_same_sides(table, *again))
      return periodic_error(rules[0], "points moved to their images change sides of segments");
    table = *std::move(again);
  }
  for (std::size_t r = 0; r < rules.size(); ++r) {
    pslg.isometries.push_back((*matches)[r].map);
    for (SegmentPair pair : (*matches)[r].pairs) {
      pair.rule = static_cast<std::uint32_t>(r);
      pslg.periodic.push_back(pair);
    }
  }
  return ok();
}

}  // namespace cover
