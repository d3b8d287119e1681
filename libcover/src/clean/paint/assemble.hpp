// The last step to the PSLG: points, segments, markers, names.
#pragma once

#include <vector>

#include <cover/input.hpp>
#include <cover/pslg.hpp>

#include "clean/network.hpp"
#include "clean/node_edges.hpp"
#include "clean/paint/paint.hpp"

namespace cover {

/// Makes the PSLG of clean edges. An edge has the marker and the name of the first segment or line
/// on it that has one, and runs in the direction of the first segment or line on it.
///
/// Points of the input keep their order; the others follow. `owners` is empty where faces are told
/// by seeds. Names that are lost where several lie on one edge are told in `notes`.
Pslg assemble(const Input& input, const Network& network, const EdgeGraph& graph,
              const std::vector<EdgeOwners>& owners, std::vector<Note>& notes);

}  // namespace cover
