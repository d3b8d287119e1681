// Are the options in their legal ranges?
#pragma once

#include <string>

#include <cover/option_ranges.hpp>
#include <cover/options.hpp>
#include <cover/result.hpp>

namespace cover {

/// "above 60 and below 180", "at least 0 and below 1", "above 1".
std::string describe(const Range& range);

/// Errors: bad_option; the message names the option, its value and the legal range.
Status check_options(const Options& options);

}  // namespace cover
