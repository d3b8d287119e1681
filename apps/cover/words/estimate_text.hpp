// What a dry run tells of the mesh that there would be.
#pragma once

#include <string>

#include <cover/estimate.hpp>

namespace cover::app {

/// What a mesh will take: in memory, where the run may keep it on the disk.
std::string estimate_text(const Estimate& estimate, bool stays_on_disk);

}  // namespace cover::app
