// Whether a rule for periodic sides can be meant.
#pragma once

#include <cover/options.hpp>
#include <cover/result.hpp>

namespace cover {

/// Errors: bad_option: a name that is missing, a line that would be its own image, a rotation by
///         nothing, or numbers that are not finite
Status check_rule(const PeriodicRule& rule);

}  // namespace cover
