// --dump-stages: pictures of how the disk packing came about.
#pragma once

#include <string>
#include <vector>

#include <cover/packing.hpp>
#include <cover/result.hpp>

namespace cover::app {

/// Writes 1_disks.svg, 2_gaps.svg and 3_triangles.svg into `folder`, which is made if missing.
///
/// Errors: cannot_write
Status dump_stages(const std::vector<PackingRecord>& packings, const std::string& folder);

}  // namespace cover::app
