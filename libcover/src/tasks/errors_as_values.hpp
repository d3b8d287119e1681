// The one place where exceptions are caught.
#pragma once

#include <exception>
#include <string_view>
#include <type_traits>

#include <cover/result.hpp>

#include "base/internal_fault.hpp"

namespace cover {

/// An error in cover itself, with what it was doing and what was thrown.
Error internal_error(std::string_view doing, const char* what);

/// Calls `body`, whose result is a Result; what it throws (CGAL, or for lack of memory, or a check
/// of our own that failed) becomes an internal error that says what was being done.
///
/// REQUIRES: `body` calls nothing of the caller's: what that throws is the caller's own.
template <class Body>
std::invoke_result_t<Body> errors_as_values(std::string_view doing, Body body) {
  try {
    return body();
  } catch (const InternalFault& e) {
    Error error = internal_error(doing, e.what());
    error.where = e.where();
    return error;
  } catch (const std::exception& e) {
    return internal_error(doing, e.what());
  }
}

}  // namespace cover
