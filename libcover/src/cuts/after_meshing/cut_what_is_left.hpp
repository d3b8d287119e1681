// Another attempt where taking vertices away has not mended what it was relied upon for.
#pragma once

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "cuts/work.hpp"

namespace cover {

/// Where triangles are obtuse after thin_cuts(): segments are cut in rounds as far as
/// cut_until_met() goes, and vertices are taken away again. The mesh with fewer obtuse triangles is
/// kept, unless what_is_worse() objects. Does nothing where there are so many points that this
/// takes as long as all before it.
///
/// Errors:  cancelled, internal
/// Cost:    that of cut_until_met(), cut_negative_couplings() and thin_cuts()
Status cut_what_is_left(Work& work, const Options& options, const Callbacks& callbacks);

}  // namespace cover
