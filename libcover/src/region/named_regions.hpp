// Regions by what users call them: for --size and --only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <cover/error.hpp>
#include <cover/regions.hpp>

namespace cover {

/// The regions meant by `name`: those with this name or this name of their material; where there
/// are none, those with this number of their material ("3"); else the one with this id
/// ("region:17"). In the order of ids; none if nothing is called so.
std::vector<RegionId> named_regions(const RegionTable& table, std::string_view name);

/// bad_option: there is no region of that name; "`what`: ..." and the nearest name that there is.
Error no_such_region(const RegionTable& table, const std::string& what, const std::string& name);

}  // namespace cover
