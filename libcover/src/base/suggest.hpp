// "Did you mean ...?"
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cover {

/// The candidate that `word` is most likely a misspelling of, if one is close enough.
std::optional<std::string> closest(std::string_view word, std::span<const std::string> candidates);

/// "; did you mean 'disks'?" for the end of a message; empty if no candidate is close enough.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// "'disk' is not one of refine, disks; did you mean 'disks'?"
std::string not_one_of(std::string_view word, std::span<const std::string> candidates);

}  // namespace cover
