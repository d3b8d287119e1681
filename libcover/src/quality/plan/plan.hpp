// What is tried on a region, in which order, and when it is enough: one table for each way to
// prefer and each effort.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <cover/options.hpp>

#include "quality/plan/candidates.hpp"

namespace cover {

/// What the steps of a plan have made so far.
struct PlanProgress {
  Candidates& make;
  Candidate cdt{}, refined{}, best{};
  std::optional<Candidate> star{};
  bool is_settled = false;  ///< the best is near its limits
};

/// One step of a plan.
struct Step {
  enum class StopWhen {
    never,
    complete,  ///< both targets are met by every triangle
    alone,     ///< they are, or couplings leave no other mesh
    near,      ///< they are, or no mesh is better by more than a degree in what is missed
    done,      ///< the largest angle is that of the goal, or what the region's worst side forces
  };
  std::string_view name;  ///< for who reads the table: what is improved, and how
  bool (*is_due)(const PlanProgress&) = nullptr;
  void (*run)(PlanProgress&) = nullptr;
  StopWhen stop = StopWhen::never;  ///< no further steps then
};

/// The plan for a region. What steps gain and cost stands in quality/effort/effort.hpp.
std::span<const Step> plan_for(const Options& options, bool has_sizes);

/// Whether no further step is due after `step`.
bool is_enough(const Step& step, const PlanProgress& progress);

/// Runs the steps of `plan` in turn. The best is no worse than what its steps compared; with sizes
/// they take the refined one as it is.
Candidate run_plan(std::span<const Step> plan, Candidates& candidates);

}  // namespace cover
