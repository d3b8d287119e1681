// Regions of a report as JSON; write_report_json.cpp says what each member is.
#pragma once

#include <nlohmann/json.hpp>

#include <cover/regions.hpp>
#include <cover/report.hpp>

namespace cover {

nlohmann::ordered_json region_json(const Region& region, const RegionReport& report);

/// All regions as if they were one, and how many of them are how.
nlohmann::ordered_json overall_json(const Report& report);

}  // namespace cover
