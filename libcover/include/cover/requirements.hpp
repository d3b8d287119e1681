// What a run had to reach, and did not.
#pragma once

#include <string>
#include <vector>

#include <cover/options.hpp>
#include <cover/output.hpp>

namespace cover {

/// Whether a region misses the proven bound although doubles could hold it; regions kept of another
/// mesh aside.
bool missed_bound(const Report& report);
/// Says which regions do.
std::string describe_missed_bound(const Output& output);

/// The requirements of `options` that the mesh misses, in words.
std::vector<std::string> unmet_requirements(const Output& output, const Options& options);

}  // namespace cover
