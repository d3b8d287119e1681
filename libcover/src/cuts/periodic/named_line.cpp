// Tested by tests/unit/cuts/periodic/periodic_sides_test.cpp.
#include "cuts/periodic/named_line.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include <cover/input.hpp>

#include "base/containers/order.hpp"

namespace cover {
std::vector<PeriodicRule> periodic_rules(const Input& input, const Options& options) {
  std::vector<PeriodicRule> rules;
  for (const auto* list : {&options.periodic, &input.periodic}) {
    for (const PeriodicRule& rule : *list) {
      if (std::find(rules.begin(), rules.end(), rule) == rules.end()) rules.push_back(rule);
    }
  }
  return rules;
}

std::string describe(const PeriodicRule& rule) {
  return fmt::format("'{}' and '{}'", rule.from, rule.to);
}

NamedLine find_line(const Pslg& pslg, const RegionTable& table, const std::string& name) {
  NamedLine line{named_segments(pslg, table, name), {}};
  for (const SegmentId s : line.segments) {
    line.vertices.push_back(pslg.segments[s.index()].a);
    line.vertices.push_back(pslg.segments[s.index()].b);
  }
  sort_unique(line.vertices);
  return line;
}

Error periodic_error(const PeriodicRule& rule, const std::string& what, std::vector<Point> where) {
  return {ErrorCode::bad_option,
          fmt::format("periodic {}: {}", describe(rule), what),
          std::move(where),
          {}};
}

}  // namespace cover
