// Options in words, so that a mesh can be traced to them.
#pragma once

#include <vector>

#include <cover/options.hpp>
#include <cover/report.hpp>

namespace cover {

/// The method, and whatever else shapes the mesh and differs from its default; under the names of
/// the command line. Threads and requirements do not shape it.
std::vector<Provenance::Setting> describe_options(const Options& options);

}  // namespace cover
