// Tested by tests/unit/sizes/sizes_test.cpp and tests/unit/layers/layer_rules_test.cpp.
#include "method/boundaries_with_wishes.hpp"

#include <utility>

#include "layers/layer_rules.hpp"
#include "region/region_graph.hpp"
#include "sizes/sizes.hpp"

namespace cover {

Result<std::vector<RegionBoundary>> boundaries_with_wishes(const Pslg& pslg,
                                                           const RegionTable& table,
                                                           const Options& options,
                                                           const Team& team) {
  std::vector<RegionBoundary> boundaries = split_regions(pslg, table, team);
  Status status = resolve_sizes(pslg, table, options, boundaries);
  if (status) status = resolve_layers(pslg, table, options, boundaries);
  if (!status) return std::move(status).error();
  return boundaries;
}

}  // namespace cover
