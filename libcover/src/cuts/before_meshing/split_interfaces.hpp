// Cutting segments before regions are split, for users who may touch them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

namespace cover {

/// Cuts segments until every side's gamma_opt is at most Options::split_interfaces, and until no
/// piece is much longer than the sizes wished at its ends and along it, by the regions on both
/// sides or the background. Both sides of a segment get the same points. Does nothing without that
/// option.
///
/// A side whose triangle is too flat is cut at the foot of that triangle's apex; one that is too
/// long, into pieces as long as wished; sizes grow from the finest places of the regions' borders,
/// by Options::growth, as in their meshes (SizeField). What is cut for angles has a least length:
/// where more would be needed, a note says so.
/// ENSURES: `pslg` and `table` fit each other; a note tells how many points were added, and where
/// Errors:  bad_option for a size of an unknown name
/// Cost:    O(n log n) per pass, with about log2 of the largest cut passes
/// Ref:     mitchell_1993_covering, 1.2; J. Ruppert, J. Algorithms 18 (1995)
Status split_interfaces(Pslg& pslg, RegionTable& table, const Options& options,
                        std::vector<Note>& notes);

/// How many points split_interfaces() puts on segments; nothing where its passes would look at more
/// than `most_looks` points for that: in each pass at all, and at those of regions that changed.
Result<std::optional<std::size_t>> count_interface_cuts(Pslg pslg, RegionTable table,
                                                        const Options& options,
                                                        std::size_t most_looks);

/// Cuts `segments` half way where there is room, and then what split_interfaces would cut. False if
/// that takes more than `most_points`: what was cut until then has angles that are too large.
/// Points from `uncut_points` on are cuts already.
///
/// REQUIRES: Options::split_interfaces; `segments` in order, without repeats
Result<bool> halve_segments(Pslg& pslg, RegionTable& table, const Options& options,
                            std::size_t uncut_points, std::span<const SegmentId> segments,
                            std::size_t most_points);

}  // namespace cover
