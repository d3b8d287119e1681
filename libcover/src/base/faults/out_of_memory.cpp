// Tested by tests/unit/tasks/errors_as_values_test.cpp and tests/faults/allocation_faults_test.cpp.
#include "base/faults/out_of_memory.hpp"

#include <string>
#include <utility>

namespace cover {
namespace {

constexpr std::string_view kShort = "out of memory";  // a std::string of it needs no allocation

}  // namespace

Error out_of_memory(std::string_view doing) noexcept {
  Error error{ErrorCode::out_of_memory, std::string(kShort), {}, {}};
  if (doing.empty()) return error;
  try {
    std::string message;
    message.reserve(doing.size() + 2 + kShort.size());
    message.append(doing).append(": ").append(kShort);
    error.message = std::move(message);
  } catch (const std::bad_alloc&) {
    // The short message stays.
  }
  return error;
}

}  // namespace cover
