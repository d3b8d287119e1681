// Are the options in their legal ranges?
#pragma once

#include <cover/options.hpp>
#include <cover/result.hpp>

namespace cover {

/// Errors: bad_option; the message names the option, its value and the legal range.
Status check_options(const Options& options);

}  // namespace cover
