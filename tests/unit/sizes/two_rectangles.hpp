// Two regions side by side, for the tests of sizes and of cuts to them.
#pragma once

#include <utility>

#include <cover/input.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>

#include "clean/pslg.hpp"
#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"

namespace cover::testing {

/// Two rectangles side by side, of materials "left" and "right".
inline Input two_rectangles() {
  Input input = segments_between({{0, 0}, {1, 0}, {3, 0}, {3, 1}, {1, 1}, {0, 1}},
                                 {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}});
  for (const auto& [x, name] : {std::pair(0.5, "left"), std::pair(2.0, "right")}) {
    RegionSeed seed;
    seed.at = {x, 0.5};
    seed.material = name;
    input.seeds.push_back(seed);
  }
  return input;
}

struct Regions {
  Pslg pslg;
  RegionTable table;
};

inline Regions regions_of(const Input& input) {
  Report report;
  Regions regions{make_pslg(input, {}, report).value(), {}};
  regions.table = build_region_table(regions.pslg, {}, report.notes).value();
  return regions;
}

}  // namespace cover::testing
