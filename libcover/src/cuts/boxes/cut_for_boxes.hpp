// Segments cut for the box method before there is a mesh.
#pragma once

#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/report.hpp>

namespace cover {

/// With Options::box_method: cuts the segments that are encroached (cut_encroached), before there
/// is a mesh. Adds to Report::box_cuts; a note tells what doubles left no room to cut.
void cut_for_boxes(Prepared& prepared, const Options& options);

/// One note that tells all of Report::box_cuts, in place of the one that there was.
void tell_box_cuts(Report& report);

}  // namespace cover
