// See keep_rules.hpp. Tested by tests/unit/quality/fault/keep_rules_test.cpp.
#include "quality/fault/keep_rules.hpp"

namespace cover {
namespace {

constexpr double kWorthACut = 0.2;  ///< of its excess, that the worst triangle must win

}  // namespace

bool is_gain(const Tally& now, const Tally& before) {
  if (now.negative > before.negative) return false;
  if (now.largest > before.largest || now.large > before.large || now.above > before.above ||
      now.far_above > before.far_above) {
    return false;
  }
  if (now.negative < before.negative) return true;
  if (now.above < before.above || now.far_above < before.far_above ||
      now.large < improvement_of(before.large)) {
    return true;
  }
  if (now.below > before.below || now.small > before.small) return false;
  return now.below < before.below || now.small < improvement_of(before.small);
}

bool is_kick_kept(const Merit& now, const Merit& before) {
  return now.above <= before.above && is_better_by_largest(now, before);
}

bool is_cut_kept(const Merit& now, const Merit& before, const Goal& goal) {
  return now.large <= before.large &&
         (now.above < before.above ||
          (now.above == before.above &&
           now.large - goal.large < (1 - kWorthACut) * (before.large - goal.large)));
}

bool is_kept_beside_couplings(const Merit& now, const Merit& before) {
  return now.fault.worst() <= before.fault.worst();
}

}  // namespace cover
