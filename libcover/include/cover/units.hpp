// What coordinates mean. Nothing else depends on it.
#pragma once

#include <optional>
#include <string_view>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>

namespace cover {

/// nm, um, mm, cm or m.
bool is_length_unit(std::string_view unit);

/// What numbers in `from` are multiplied by to be in `to`; each is a unit of ours or inches, feet,
/// yards, miles, mils, microinches, US survey feet, angstroms, decimetres or kilometres. Nothing
/// where one is none of these.
std::optional<double> factor_between(std::string_view from, std::string_view to);

/// Multiplies all lengths of `input`: by powers of two exactly; by powers of ten with each
/// coordinate rounded once, so that 45 nm becomes the double 4.5e-8; by any other factor as the
/// nearest double to coordinate times `factor`. How many coordinates this rounds is told in
/// `input.warnings`, as points on one line need not stay so. The unit follows, from um to nm by
/// 1000, or is none any more, by 25.4.
///
/// Errors: bad_option where `factor` is not above zero and finite; non_finite_coordinate where a
/// coordinate overflows.
Status scale_input(Input& input, double factor);

/// What options ask of all formats alike: the scale, then the unit of what it leads to. A warning
/// tells where the input's own unit says something else, or has no name after the scale, and of a
/// drawing in inches or the like which scale makes it one of ours.
///
/// Errors: as scale_input()
Status apply_units(Input& input, const ReadOptions& options);

}  // namespace cover
