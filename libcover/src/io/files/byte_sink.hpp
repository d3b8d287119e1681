// Where the bytes of a file go.
#pragma once

#include <functional>
#include <string_view>

namespace cover {

/// Takes the bytes of a file, piece by piece.
using ByteSink = std::function<void(std::string_view)>;

}  // namespace cover
