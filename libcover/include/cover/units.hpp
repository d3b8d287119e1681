// What coordinates mean. Nothing else depends on it.
#pragma once

#include <string_view>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover {

/// nm, um, mm, cm or m.
bool is_length_unit(std::string_view unit);

/// Multiplies all lengths of `input` by a power of two or of ten, as 1e-9: powers of two exactly,
/// powers of ten with each coordinate rounded once, so that 45 nm becomes the double 4.5e-8.
///
/// Errors: bad_option where `factor` is neither; non_finite_coordinate where a coordinate
/// overflows.
Status scale_input(Input& input, double factor);

}  // namespace cover
