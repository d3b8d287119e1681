// What a function of the caller threw.
#pragma once

#include <stdexcept>
#include <string>

#include <cover/point.hpp>

namespace cover {

/// Thrown in place of what a caller's function threw inside of a stage; becomes the error
/// bad_option with the place (tasks/errors_as_values).
class CallerFault : public std::runtime_error {
 public:
  CallerFault(const std::string& what, Point where) : std::runtime_error(what), where_(where) {}
  [[nodiscard]] Point where() const { return where_; }

 private:
  Point where_;
};

}  // namespace cover
