// A region for tests of the plan: the makers of its candidates, and its plain triangulation.
#pragma once

#include <utility>

#include "quality/plan/candidates.hpp"

namespace cover::testing {

/// The makers for one region, and its plain triangulation, with which all else is compared.
struct PlannedRegion {
  explicit PlannedRegion(RegionBoundary region, Options asked = {})
      : boundary(std::move(region)),
        options(std::move(asked)),
        make(boundary, options, {}, true),
        cdt(make.as_it_is()) {
    make.compare_with(cdt);
  }

  RegionBoundary boundary;
  Options options;
  Candidates make;
  Candidate cdt;
};

}  // namespace cover::testing
