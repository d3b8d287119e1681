// Tested by tests/unit/io/read_mesh/read_mesh_test.cpp, through the formats.
#include "io/text/field_reader.hpp"

#include <fmt/core.h>

#include <cmath>

namespace cover {

long FieldReader::integer(std::size_t field) {
  const auto value = field < fields().size() ? parse_integer(fields()[field]) : std::nullopt;
  if (!value)
    fail(ErrorCode::syntax, fmt::format("field {} is no integer{}", field + 1, hint_at(field)));
  return value.value_or(0);
}

double FieldReader::real(std::size_t field) {
  const auto value = field < fields().size() ? parse_double(fields()[field]) : std::nullopt;
  if (value && std::isfinite(*value)) return *value;
  fail(value ? ErrorCode::non_finite_coordinate : ErrorCode::syntax,
       fmt::format("field {} is no finite number{}", field + 1, hint_at(field)));
  return 0;
}

std::string FieldReader::hint_at(std::size_t field) const {
  return field < fields().size() ? hint_at_comma(fields()[field]) : std::string();
}

}  // namespace cover
