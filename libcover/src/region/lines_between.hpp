// What lines between two regions are called. Implemented in named_regions.cpp, tested by
// tests/unit/region/named_regions_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include <cover/regions.hpp>

namespace cover {

/// "; between 'Si' and 'SiO2' lie 'gate', 'box_well'" for the end of a message, where a name of no
/// line is made of the names of two regions or materials (Si_SiO2) that touch; else empty.
std::string lines_between(const RegionTable& table, std::string_view name);

}  // namespace cover
