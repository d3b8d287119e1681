// What was done to the input, in words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <cover/error.hpp>
#include <cover/input.hpp>
#include <cover/report.hpp>

#include "clean/network.hpp"
#include "clean/node_edges.hpp"
#include "clean/paint/paint.hpp"
#include "clean/paint/visible_edges.hpp"

namespace cover {

/// "(0, 0), (1, 0) and 3 more places".
std::string list_of_places(const std::vector<Point>& where);

/// Appends a change for every line of which a piece is visible and that had to be cut, save for a
/// polygon's side at the corner of another polygon.
void report_splits(const Input& input, const Network& network,
                   const std::vector<VisibleEdge>& edges, std::vector<Change>& changes);

/// Appends a warning for every polygon that crosses itself or of which nothing is visible, and a
/// change for every one that folds back on itself, where that separates nothing. Of those that are
/// `hidden`, by number, the network knows nothing.
void report_polygons(const Input& input, const std::vector<bool>& hidden, const Network& network,
                     const EdgeGraph& graph, const std::vector<EdgeOwners>& owners, Report& report);

/// Appends a warning where polygons are merged into regions that have the name or the attributes of
/// another polygon.
void report_merged_values(const Input& input, const Painting& painting, std::vector<Note>& notes);

/// Appends a note for each kind of change with the number of them and the first few.
void sum_up(const std::vector<Change>& changes, std::vector<Note>& notes);

/// All changes as the error of `--strict`; none if there are none.
std::optional<Error> changes_as_error(const Input& input, const std::vector<Change>& changes);

}  // namespace cover
