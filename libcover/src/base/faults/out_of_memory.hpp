// Memory that runs out is an error of its own, and no more memory is needed to say so.
#pragma once

#include <new>
#include <string_view>
#include <type_traits>

#include <cover/result.hpp>

namespace cover {

/// The error "DOING: out of memory"; without DOING where there is no memory left for that.
Error out_of_memory(std::string_view doing = {}) noexcept;

/// Calls `body`, whose result is a Result. Where memory runs out, that is the error.
///
/// ENSURES: throws only what `body` throws beside std::bad_alloc
template <class Body>
std::invoke_result_t<Body> memory_as_value(std::string_view doing, Body body) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return out_of_memory(doing);
  }
}

}  // namespace cover
