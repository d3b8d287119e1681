// The tables of steps, and how one is run.
#include "quality/plan/plan.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <string_view>
#include <vector>

#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;
using StopWhen = Step::StopWhen;

Options with(Effort effort, Prefer prefer = Prefer::balanced) {
  Options options;
  options.effort = effort;
  options.prefer = prefer;
  return options;
}

std::vector<std::string_view> names(std::span<const Step> plan) {
  std::vector<std::string_view> out;
  for (const Step& step : plan) out.push_back(step.name);
  return out;
}

TEST(PlanFor, BeginsWithThePlainTriangulationAndHasNoEmptySteps) {
  for (const Effort effort : {Effort::fast, Effort::normal, Effort::thorough}) {
    for (const Prefer prefer : {Prefer::balanced, Prefer::largest}) {
      for (const bool has_sizes : {false, true}) {
        const std::span<const Step> plan = plan_for(with(effort, prefer), has_sizes);
        ASSERT_FALSE(plan.empty());
        EXPECT_EQ(plan[0].name, "cdt");
        for (const Step& step : plan) {
          EXPECT_FALSE(step.name.empty());
          EXPECT_NE(step.is_due, nullptr);
          EXPECT_NE(step.run, nullptr);
        }
      }
    }
  }
}

TEST(PlanFor, ThoroughHasAllThatTheDefaultHasButStopsAtNoProofAndGoesOn) {
  for (const bool has_sizes : {false, true}) {
    std::vector<std::string_view> normal = names(plan_for(with(Effort::normal), has_sizes));
    const std::vector<std::string_view> thorough =
        names(plan_for(with(Effort::thorough), has_sizes));
    std::erase(normal, "limits of that");
    ASSERT_GT(thorough.size(), normal.size());
    EXPECT_TRUE(std::equal(normal.begin(), normal.end(), thorough.begin()));
  }
}

TEST(PlanFor, LessThan95DegreesPutsTheLargestAngleFirst) {
  Options strict = with(Effort::normal);
  strict.max_angle = Angle::degrees(94);
  const Options largest = with(Effort::normal, Prefer::largest);
  for (const bool has_sizes : {false, true})
    EXPECT_EQ(names(plan_for(strict, has_sizes)), names(plan_for(largest, has_sizes)));
  EXPECT_NE(names(plan_for(strict, false)), names(plan_for(with(Effort::normal), false)));
}

TEST(PlanFor, LittleEffortTriesLess) {
  EXPECT_LT(plan_for(with(Effort::fast), false).size(),
            plan_for(with(Effort::normal), false).size());
  EXPECT_LT(plan_for(with(Effort::fast), true).size(), plan_for(with(Effort::normal), true).size());
}

/// A region that misses its targets, and steps that count how often they run.
class RunPlan : public ::testing::Test {
 protected:
  static void make_best(PlanProgress& p) {
    ++runs_[0];
    p.cdt = p.best = p.make.as_it_is();
    p.make.compare_with(p.cdt);
  }
  static void complete_it(PlanProgress& p) {
    ++runs_[1];
    p.best.merit.complete = true;
  }
  static void count_one(PlanProgress&) { ++runs_[2]; }
  static bool always(const PlanProgress&) { return true; }
  static bool never(const PlanProgress&) { return false; }

  RunPlan() { runs_ = {}; }

  static inline std::array<int, 3> runs_{};
  const RegionBoundary boundary_ = boundary_of({regular_polygon(20)});
  const Options options_{};
  Candidates candidates_{boundary_, options_, {}, true};
};

TEST_F(RunPlan, RunsWhatIsDueUntilItIsEnough) {
  const std::array plan{Step{"made", always, make_best}, Step{"not due", never, count_one},
                        Step{"complete", always, complete_it, StopWhen::complete},
                        Step{"too late", always, count_one}};
  const Candidate best = run_plan(plan, candidates_);
  EXPECT_TRUE(best.merit.complete);
  EXPECT_EQ(best.method, "cdt");
  EXPECT_EQ(runs_, (std::array{1, 1, 0}));
}

TEST_F(RunPlan, AStepThatDoesNotStopIsFollowedByTheNext) {
  const std::array plan{Step{"made", always, make_best}, Step{"complete", always, complete_it},
                        Step{"counted", always, count_one, StopWhen::complete},
                        Step{"too late", always, count_one}};
  (void)run_plan(plan, candidates_);
  EXPECT_EQ(runs_, (std::array{1, 1, 1}));
}

TEST_F(RunPlan, WhatIsEnoughIsJudgedEvenWhereAStepIsNotDue) {
  const std::array plan{Step{"made", always, make_best}, Step{"complete", always, complete_it},
                        Step{"not due", never, count_one, StopWhen::complete},
                        Step{"too late", always, count_one}};
  (void)run_plan(plan, candidates_);
  EXPECT_EQ(runs_, (std::array{1, 1, 0}));
}

TEST_F(RunPlan, NothingIsTriedWhereTheRunIsToStop) {
  std::stop_source source;
  source.request_stop();
  Candidates stopped(boundary_, options_, source.get_token(), true);
  const std::array plan{Step{"made", always, make_best}};
  (void)run_plan(plan, stopped);
  EXPECT_EQ(runs_[0], 0);
}

TEST_F(RunPlan, EachReasonToStopLooksAtOneThing) {
  PlanProgress p{candidates_};
  make_best(p);
  const auto is_enough_by = [&](StopWhen stop) {
    return is_enough(Step{"", always, make_best, stop}, p);
  };
  ASSERT_FALSE(p.best.merit.complete);
  EXPECT_FALSE(is_enough_by(StopWhen::never));
  EXPECT_FALSE(is_enough_by(StopWhen::complete));
  EXPECT_FALSE(is_enough_by(StopWhen::alone));
  EXPECT_FALSE(is_enough_by(StopWhen::near));
  p.is_settled = true;
  EXPECT_TRUE(is_enough_by(StopWhen::near));
  EXPECT_FALSE(is_enough_by(StopWhen::complete));
  EXPECT_EQ(is_enough_by(StopWhen::done), candidates_.is_done(p.best));
  p.best.merit.complete = true;
  EXPECT_TRUE(is_enough_by(StopWhen::complete));
  EXPECT_TRUE(is_enough_by(StopWhen::alone));
  EXPECT_FALSE(is_enough_by(StopWhen::never));
}

/// No region ends worse with more effort, by the measure that is the same for both.
TEST(Plan, ThoroughIsNoWorseThanTheDefaultInAnyRegion) {
  const std::uint64_t seed = test_seed(3);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  for (int k = 0; k < 24; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(5 + k, 0.3, random)});
    const Options options = with(Effort::normal), more = with(Effort::thorough);
    Candidates usual(boundary, options, {}, true), all(boundary, more, {}, true);
    const Candidate normal = run_plan(plan_for(options, false), usual);
    const Candidate thorough = run_plan(plan_for(more, false), all);
    EXPECT_FALSE(usual.ranking().order().is_better(normal.merit, thorough.merit))
        << k << ": " << normal.merit.fault.worst() << " and " << thorough.merit.fault.worst();
  }
}

}  // namespace
}  // namespace cover
