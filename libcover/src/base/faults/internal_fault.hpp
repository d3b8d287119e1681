// A promise inside of the library that turned out to be broken, and where.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// Thrown where going on would read or write what is not there. Becomes an internal error that
/// carries the places (tasks/errors_as_values).
class InternalFault : public std::logic_error {
 public:
  InternalFault(const std::string& what, std::vector<Point> where)
      : std::logic_error(what), where_(std::move(where)) {}
  [[nodiscard]] const std::vector<Point>& where() const { return where_; }

 private:
  std::vector<Point> where_;
};

}  // namespace cover
