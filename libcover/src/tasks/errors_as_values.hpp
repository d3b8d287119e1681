// Where exceptions of a task become values, but for lack of memory (base/faults/out_of_memory).
#pragma once

#include <exception>
#include <new>
#include <string_view>
#include <type_traits>

#include <cover/result.hpp>

#include "base/faults/caller_fault.hpp"
#include "base/faults/internal_fault.hpp"
#include "base/faults/out_of_memory.hpp"

namespace cover {

/// An error in cover itself, with what it was doing and what was thrown.
Error internal_error(std::string_view doing, const char* what);

/// Calls `body`, whose result is a Result; what it throws becomes an error that says what was being
/// done: out_of_memory; bad_option for what a caller's function threw (CallerFault); internal for
/// all else (CGAL, or a check of our own that failed).
///
/// ENSURES: throws nothing but what is no std::exception, whatever memory there is
template <class Body>
std::invoke_result_t<Body> errors_as_values(std::string_view doing, Body body) {
  return memory_as_value(doing, [&]() -> std::invoke_result_t<Body> {
    try {
      return body();
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const InternalFault& e) {
      Error error = internal_error(doing, e.what());
      error.where = e.where();
      return error;
    } catch (const CallerFault& e) {
      return Error{ErrorCode::bad_option, e.what(), {e.where()}, {}};
    } catch (const std::exception& e) {
      return internal_error(doing, e.what());
    }
  });
}

}  // namespace cover
