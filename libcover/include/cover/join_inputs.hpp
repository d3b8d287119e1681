// One geometry from several files: tiles of a map, layers of a drawing.
#pragma once

#include <vector>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover {

/// All that the inputs have, in their order: so later polygons are painted over earlier ones.
/// Points at the same place become one when the whole is cleaned. Ids stay those of the files; a
/// material that the reader of a map made up, feature_3, gets the number of its file in front,
/// 2:feature_3, from the second file on. Attributes of one name are one, of text where one is.
///
/// Maps of one coordinate system have one unit, that of those which say it. Where it is not certain
/// that two systems are different ones, a warning tells of them.
///
/// Errors: bad_option where there is none, where coordinate systems, units or scales differ, where
///         one says that faces without a seed are void and another not, where more than one has
///         values beside its geometry, and where no input has what was asked of all
/// Cost:   O(n)
Result<Input> join_inputs(std::vector<Input> inputs);

}  // namespace cover
