// Tested by tests/unit/tasks/errors_as_values_test.cpp.
#include "tasks/errors_as_values.hpp"

#include <fmt/core.h>

namespace cover {

Error internal_error(std::string_view doing, const char* what) {
  return {ErrorCode::internal,
          fmt::format("{}: {}; this is an error in cover, please report it with the input", doing,
                      what),
          {},
          {}};
}

}  // namespace cover
