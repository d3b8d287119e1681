// Recursive descent into steps for a stack, of which no text makes more than kMostValues.
// Tested by tests/unit/base/expression_test.cpp.
#include "base/expression.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/errors.hpp"
#include "base/words/characters.hpp"

namespace cover {
namespace {

/// Each level of parentheses, signs or powers keeps at most three values waiting.
constexpr int kDeepest = 60;
constexpr std::size_t kMostValues = 256;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

}  // namespace

/// Parses one text; the first error stays.
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, std::span<const std::string> names)
      : text_(text), names_(names) {}

  Result<Expression> parse() {
    sum(0);
    if (next() != 0) fail(at_, fmt::format("'{}' does not belong here", next()));
    if (error_) return *error_;
    return std::move(out_);
  }

 private:
  using Operation = Expression::Operation;
  struct Function {
    std::string_view name;
    Operation operation;
  };
  static constexpr std::array<Function, 8> kFunctions{{{"abs", Operation::abs},
                                                       {"asinh", Operation::asinh},
                                                       {"cos", Operation::cos},
                                                       {"exp", Operation::exp},
                                                       {"log", Operation::log},
                                                       {"sin", Operation::sin},
                                                       {"sqrt", Operation::sqrt},
                                                       {"tanh", Operation::tanh}}};
  static constexpr std::array<Function, 2> kFunctionsOfTwo{
      {{"hypot", Operation::hypot}, {"atan2", Operation::atan2}}};
  friend bool is_function_name(std::string_view word);

  /// Nothing follows an error: the rest of the text is passed over.
  void fail(std::size_t at, const std::string& what) {
    if (!error_) error_ = bad_option(fmt::format("'{}', column {}: {}", shown(), at + 1, what));
    at_ = text_.size();
  }

  [[nodiscard]] std::string shown() const {
    constexpr std::size_t kMost = 80;
    return text_.size() > kMost ? std::string(text_.substr(0, kMost)) + "..." : std::string(text_);
  }

  /// The next character that is no blank; 0 at the end.
  char next() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!take(c)) fail(at_, fmt::format("expected '{}'", c));
  }

  void add(Operation operation, double number = 0, std::uint32_t name = 0) {
    out_.steps_.push_back({operation, number, name});
  }

  void sum(int depth) {
    product(depth + 1);
    while (!error_) {
      const bool plus = next() == '+';
      if (!plus && next() != '-') return;
      ++at_;
      product(depth + 1);
      add(plus ? Operation::plus : Operation::minus);
    }
  }

  void product(int depth) {
    signed_power(depth);
    while (!error_) {
      const bool times = next() == '*';
      if (!times && next() != '/') return;
      ++at_;
      signed_power(depth);
      add(times ? Operation::times : Operation::over);
    }
  }

  void signed_power(int depth) {
    if (depth > kDeepest) return fail(at_, "too much is nested");
    if (take('+')) return signed_power(depth + 1);
    if (take('-')) {
      signed_power(depth + 1);
      return add(Operation::negative);
    }
    primary(depth);
    if (!take('^')) return;
    signed_power(depth + 1);
    add(Operation::power);
  }

  void primary(int depth) {
    const char c = next();
    if (take('(')) {
      sum(depth);
      return expect(')');
    }
    if (is_digit(c) || c == '.') return number();
    if (c == '\'') return quoted();
    if (is_letter(c)) return word(depth);
    fail(at_, c == 0 ? "a number or a name is missing at the end"
                     : fmt::format("expected a number or a name, not '{}'", c));
  }

  void number() {
    double value = 0;
    const char* const first = text_.data() + at_;
    const auto [end, status] = std::from_chars(first, text_.data() + text_.size(), value);
    if (status != std::errc()) return fail(at_, "this is no number");
    at_ += static_cast<std::size_t>(end - first);
    add(Operation::number, value);
  }

  void quoted() {
    const std::size_t first = at_, end = text_.find('\'', at_ + 1);
    if (end == std::string_view::npos) return fail(first, "the quote has no end");
    at_ = end + 1;
    value_of(text_.substr(first + 1, end - first - 1), first);
  }

  void word(int depth) {
    const std::size_t first = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string_view name = text_.substr(first, at_ - first);
    if (next() != '(') return value_of(name, first);
    const auto is_called = [&](const Function& f) { return f.name == name; };
    const auto* const function = std::find_if(kFunctions.begin(), kFunctions.end(), is_called);
    const auto* const of_two =
        std::find_if(kFunctionsOfTwo.begin(), kFunctionsOfTwo.end(), is_called);
    const bool several = name == "min" || name == "max";
    if (function == kFunctions.end() && of_two == kFunctionsOfTwo.end() && !several)
      return fail(first, fmt::format("there is no function '{}'; there are min, max, {}", name,
                                     function_names()));
    expect('(');
    sum(depth);
    if (function != kFunctions.end()) add(function->operation);
    if (of_two != kFunctionsOfTwo.end()) {
      expect(',');
      sum(depth);
      add(of_two->operation);
    }
    while (several && !error_ && take(',')) {
      sum(depth);
      add(name == "min" ? Operation::min : Operation::max);
    }
    expect(')');
  }

  void value_of(std::string_view name, std::size_t at) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end())
      return add(Operation::name, 0, static_cast<std::uint32_t>(found - names_.begin()));
    if (name == "pi") return add(Operation::number, std::numbers::pi);
    fail(at, fmt::format("there is no '{}'; there are {}{}pi, and functions of something in ( )",
                         name, listed(names_), names_.empty() ? "" : ", "));
  }

  static std::string function_names() {
    std::string out;
    for (const Function& f : kFunctionsOfTwo) out += std::string(f.name) + ", ";
    for (const Function& f : kFunctions)
      out += (&f == kFunctions.begin() ? "" : ", ") + std::string(f.name);
    return out;
  }

  std::string_view text_;
  std::span<const std::string> names_;
  std::size_t at_ = 0;
  Expression out_;
  std::optional<Error> error_;
};

Result<Expression> Expression::parse(std::string_view text, std::span<const std::string> names) {
  return ExpressionParser(text, names).parse();
}

double Expression::of_one(Operation operation, double x) {
  switch (operation) {
    case Operation::negative:
      return -x;
    case Operation::abs:
      return std::abs(x);
    case Operation::sqrt:
      return std::sqrt(x);
    case Operation::exp:
      return std::exp(x);
    case Operation::log:
      return std::log(x);
    case Operation::sin:
      return std::sin(x);
    case Operation::cos:
      return std::cos(x);
    case Operation::asinh:
      return std::asinh(x);
    case Operation::tanh:
      return std::tanh(x);
    default:
      return std::nan("");
  }
}

/// Of min and max, what is no number stays none.
double Expression::of_two(Operation operation, double x, double y) {
  switch (operation) {
    case Operation::plus:
      return x + y;
    case Operation::minus:
      return x - y;
    case Operation::times:
      return x * y;
    case Operation::over:
      return x / y;
    case Operation::power:
      return std::pow(x, y);
    case Operation::min:
      return x <= y ? x : x > y ? y : x + y;
    case Operation::max:
      return x >= y ? x : x < y ? y : x + y;
    case Operation::hypot:
      return std::hypot(x, y);
    case Operation::atan2:
      return std::atan2(x, y);
    default:
      return std::nan("");
  }
}

double Expression::operator()(std::span<const double> values) const {
  std::array<double, kMostValues> stack;  // NOLINT: written before it is read
  std::size_t n = 0;
  for (const auto& [operation, number, name] : steps_) {
    if (operation == Operation::number) {
      stack[n++] = number;
    } else if (operation == Operation::name) {
      stack[n++] = values[name];
    } else if (takes_two(operation)) {
      --n;
      stack[n - 1] = of_two(operation, stack[n - 1], stack[n]);
    } else {
      stack[n - 1] = of_one(operation, stack[n - 1]);
    }
  }
  return steps_.empty() ? std::nan("") : stack[0];
}

bool Expression::uses(std::size_t name) const {
  return std::any_of(steps_.begin(), steps_.end(), [&](const Step& step) {
    return step.operation == Operation::name && step.name == name;
  });
}

bool is_function_name(std::string_view word) {
  return std::any_of(ExpressionParser::kFunctions.begin(), ExpressionParser::kFunctions.end(),
                     [&](const auto& f) { return f.name == word; });
}

}  // namespace cover
