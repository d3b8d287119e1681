// Arithmetic that people write: numbers as a function of a few names.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cover/result.hpp>

namespace cover {

/// A formula such as "0.1 + 0.3*abs(y)". It has numbers, names, pi, ( ), + - * / ^ (to the right,
/// before a sign: -2^2 is -4), and the functions min and max of one or more values, hypot(x, y) and
/// atan2(y, x) of two, abs, sqrt, exp, log (natural), sin, cos (radians), asinh and tanh. Names
/// that are not made of letters, digits and '_' stand in single quotes. Immutable; to be called
/// from several threads at a time.
class Expression {
 public:
  /// `names` may stand in the text for values; the i-th value of a call is that of `names[i]`.
  ///
  /// Errors: bad_option, with the column, from 1. Texts whose parts are nested too deep are
  ///         refused.
  /// Cost:   O(length of text)
  static Result<Expression> parse(std::string_view text, std::span<const std::string> names);

  /// The value, which may be no number or infinite.
  ///
  /// REQUIRES: as many values as there were names
  [[nodiscard]] double operator()(std::span<const double> values) const;

  /// Whether the i-th name stands in the text.
  [[nodiscard]] bool uses(std::size_t name) const;

 private:
  friend class ExpressionParser;

  /// Steps on a stack: a value is pushed, or functions take the topmost ones.
  enum class Operation : std::uint8_t {
    number,
    name,
    negative,
    plus,
    minus,
    times,
    over,
    power,
    min,
    max,
    hypot,
    atan2,
    abs,
    sqrt,
    exp,
    log,
    sin,
    cos,
    asinh,
    tanh
  };
  struct Step {
    Operation operation = Operation::number;
    double number = 0;
    std::uint32_t name = 0;
  };
  static constexpr bool takes_two(Operation operation) {
    return operation >= Operation::plus && operation <= Operation::atan2;
  }
  static double of_one(Operation operation, double x);
  static double of_two(Operation operation, double x, double y);

  std::vector<Step> steps_;
};

/// The names of functions of one value.
bool is_function_name(std::string_view word);

}  // namespace cover
