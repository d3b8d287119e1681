// Which cuts broke something: cuts are rounded, and what they move may meet what lies beside it.
#pragma once

#include <vector>

#include <cover/ids.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>

#include "cdt/region_cdt.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// The cuts, vertices from `first` on, that made `boundary` bound nothing: those of the flaw, or
/// all of the region where it names none or `all` is set.
///
/// Errors: InternalFault where the region has no cut
std::vector<VertexId> cuts_that_broke(const RegionBoundary& boundary, const Flaw& flaw,
                                      VertexId first, bool all);

/// The cuts, vertices from `first` on, that broke something in the void: made segments meet there,
/// pass what lies in it, or the hull have other sides.
///
/// Cost:   O(n log n): a triangulation of the whole
/// Errors: InternalFault where segments meet though there is no cut
std::vector<VertexId> cuts_that_broke_void(const Pslg& pslg, const RegionTable& table,
                                           VertexId first);

}  // namespace cover
