// Reports for the terminal.
#pragma once

#include <string>

#include <cover/cover_mesh.hpp>
#include <cover/stream_mesh.hpp>

namespace cover::app {

/// What a run reached: totals, the regions with the least slack (all if `every_region`), a
/// histogram of all angles in bins of 10 degrees, times.
std::string mesh_text(const StreamedOutput& streamed, bool every_region);

/// What an input holds and what can be reached on it: regions and interfaces.
std::string info_text(const Prepared& prepared, bool every_region);

/// What the box method costs: encroached sides, cuts needed and planned for each grade.
std::string box_costs_text(const BoxCosts& costs, bool every_side);

}  // namespace cover::app
