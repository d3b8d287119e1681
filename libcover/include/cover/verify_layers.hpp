// Finds layers along a line of any mesh, from plain arrays.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <cover/angle.hpp>
#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>
#include <cover/triangle_soup.hpp>

namespace cover {

/// The rows of triangles along a line, in one region.
struct LayersFound {
  RegionId region;
  std::size_t edges = 0;    ///< of the mesh, on the line
  std::size_t layered = 0;  ///< of these, with a row or more
  int fewest = 0;           ///< rows, over edges that have some
  int most = 0;
  double first_least = 0;  ///< thickness of the first row, over edges that have one
  double first_most = 0;
  double thickness = 0;  ///< of the most rows
  std::size_t triangles = 0;
  Angle largest;             ///< angle in these triangles
  std::size_t above_90 = 0;  ///< obtuse triangles, as Quality::obtuse counts them
  std::size_t negative = 0;  ///< edges of rows with a negative coupling in the region
};

/// What counts along the line called `line` in a region: the last rule that fits, null if there is
/// none.
const LayerRule* layer_rule_for(const Region& region, std::string_view line,
                                std::span<const LayerRule> rules);

/// Finds rows over every edge of the mesh that lies on the line called `line`: two triangles make a
/// cell of a row where their quadrilateral has its upper edge within 20 degrees of the lower one
/// and its sides within 20 degrees of upright (where a rule says how thick it is, 40, as in mitres
/// of inner corners), in line with those of the cell below, and is no thinner than that and no more
/// than three times as thick. Cells are looked for upwards as long as there are some that grow
/// alike, within a thousandth: as the rule in `rules` for this line says if first rows are as thick
/// as that says, and up to its count; else as the second over the first, so that regular triangles
/// above them are no layers. Triangles in which rows end are no cells; nor are, where some first
/// rows of a region are as thick as the rule says, others on that line.
///
/// `region` is the name of a region or a material; empty: both sides of the line. Of `rules`, which
/// may be for other lines, the last counts; where all that are for this line are for its other
/// side, there are no layers on this one.
/// REQUIRES: `pslg` and `table` cut where `mesh` is, see adopt_cuts()
/// Returns:  by region, in the order of their ids
/// Errors:   bad_option where no line has the name, or no such region is beside it
/// EXACT:    the signs of couplings
/// Cost:     O(n log n)
Result<std::vector<LayersFound>> verify_layers(const Pslg& pslg, const RegionTable& table,
                                               const TriangleSoup& mesh, std::string_view line,
                                               std::string_view region = {},
                                               std::span<const LayerRule> rules = {});

}  // namespace cover
