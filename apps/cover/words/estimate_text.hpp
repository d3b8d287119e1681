// What a dry run tells of the mesh that there would be.
#pragma once

#include <string>

#include <cover/estimate.hpp>

namespace cover::app {

/// What a mesh will take.
std::string estimate_text(const Estimate& estimate);

}  // namespace cover::app
