// Errors that many files make.
#pragma once

#include <string>
#include <string_view>

#include <cover/error.hpp>

namespace cover {

/// An option that cannot be meant.
inline Error bad_option(std::string message) {
  return {ErrorCode::bad_option, std::move(message), {}, {}};
}

/// The caller has asked a run to stop.
inline Error interrupted() { return {ErrorCode::cancelled, "interrupted", {}, {}}; }

/// A file that does not hold what it should: "PATH: WHAT".
inline Error wrong_file(const std::string& path, std::string_view what) {
  return {ErrorCode::syntax, path + ": " + std::string(what), {}, {}};
}

/// An error that was found in a file: "PATH: MESSAGE".
inline Error in_file(const std::string& path, Error found) {
  found.message = path + ": " + found.message;
  return found;
}

}  // namespace cover
