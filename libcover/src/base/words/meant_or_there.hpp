// What a name may have meant that nothing has. Implemented in suggest.cpp, tested by
// tests/unit/base/words/suggest_test.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cover {

/// As did_you_mean(), but where no candidate is close enough "; there are 'refine', 'disks'", with
/// the first eight of them.
std::string meant_or_there(std::string_view word, std::span<const std::string> candidates);

}  // namespace cover
