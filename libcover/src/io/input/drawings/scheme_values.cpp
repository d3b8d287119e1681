// Tested by tests/unit/io/input/drawings/read_sde_test.cpp.
#include "io/input/drawings/scheme_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "io/text/limits.hpp"

namespace cover {
namespace {

using Kind = SchemeValue::Kind;
using Values = SchemeEvaluator::Values;

SchemeValue truth(bool value) {
  SchemeValue out;
  out.kind = Kind::truth;
  out.number = value ? 1 : 0;
  return out;
}

SchemeValue number_value(double value) {
  SchemeValue out;
  out.kind = Kind::number;
  out.number = value;
  return out;
}

SchemeValue text_value(std::string value) {
  SchemeValue out;
  out.kind = Kind::text;
  out.text = std::move(value);
  return out;
}

/// How much there is to copy.
std::size_t weight(const SchemeValue& value) {
  std::size_t sum = 1 + value.text.size() / 64;
  for (const SchemeValue& item : value.items) sum += weight(item);
  return sum;
}

bool all_numbers(const Values& values) {
  return std::all_of(values.begin(), values.end(),
                     [](const SchemeValue& v) { return v.is(Kind::number); });
}

struct OneNumber {
  std::string_view name;
  double (*function)(double);
};
constexpr OneNumber kOneNumber[] = {
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"abs", [](double x) { return std::abs(x); }},
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"floor", [](double x) { return std::floor(x); }},
    {"ceiling", [](double x) { return std::ceil(x); }},
    {"round", [](double x) { return std::nearbyint(x); }},
};

bool compare(std::string_view name, double a, double b) {
  return name == "="    ? a == b
         : name == "<"  ? a < b
         : name == ">"  ? a > b
         : name == "<=" ? a <= b
                        : a >= b;
}

/// Whether two values are the same; nothing if that cannot be known.
std::optional<bool> are_equal(const SchemeValue& a, const SchemeValue& b) {
  if (a.is(Kind::none) || b.is(Kind::none)) return std::nullopt;
  if (a.kind != b.kind || a.items.size() != b.items.size()) return false;
  for (std::size_t k = 0; k < a.items.size(); ++k) {
    const std::optional<bool> same = are_equal(a.items[k], b.items[k]);
    if (!same || !*same) return same;
  }
  return a.number == b.number && a.text == b.text && a.at == b.at;
}

struct Question {
  std::string_view name;
  bool (*holds)(double);
};
constexpr Question kQuestions[] = {
    {"zero?", [](double x) { return x == 0; }},
    {"positive?", [](double x) { return x > 0; }},
    {"negative?", [](double x) { return x < 0; }},
    {"even?", [](double x) { return std::remainder(x, 2) == 0; }},
    {"odd?", [](double x) { return std::abs(std::remainder(x, 2)) == 1; }},
};

double fold(char operation, double a, double b) {
  switch (operation) {
    case '+':
      return a + b;
    case '-':
      return a - b;
    case '*':
      return a * b;
    default:
      return a / b;
  }
}

}  // namespace

SchemeValue SchemeEvaluator::fail(const SchemeForm& form, const std::string& what) {
  if (!error_)
    error_ = Error{ErrorCode::syntax, fmt::format("{}:{}: {}", source_, form.line, what), {}, {}};
  return {};
}

SchemeValue SchemeEvaluator::look_up(const std::string& name) {
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    const auto found = scope->find(name);
    if (found != scope->end()) return found->second;
  }
  if (name == "#t") return truth(true);
  if (name == "#f") return truth(false);
  if (name == "PI" || name == "pi") return number_value(std::acos(-1.0));
  if (unknown_.empty()) unknown_ = name;
  return {};
}

SchemeValue SchemeEvaluator::evaluate(const SchemeForm& form) {
  if (error_) return {};
  if (++steps_ > kSchemeSteps) return fail(form, "evaluating this takes too many steps");
  switch (form.kind) {
    case SchemeForm::Kind::number:
      return number_value(form.number);
    case SchemeForm::Kind::text:
      return text_value(form.word);
    case SchemeForm::Kind::symbol: {
      SchemeValue value = look_up(form.word);
      steps_ += weight(value);
      return value;
    }
    case SchemeForm::Kind::list:
      break;
  }
  if (depth_ >= kSchemeDepth) return fail(form, "too many calls one in the other");
  ++depth_;
  SchemeValue value = list_value(form);
  --depth_;
  return value;
}

SchemeEvaluator::Values SchemeEvaluator::arguments(const SchemeForm& form) {
  Values values;
  for (std::size_t k = 1; k < form.items.size(); ++k) values.push_back(evaluate(form.items[k]));
  return values;
}

SchemeValue SchemeEvaluator::list_value(const SchemeForm& form) {
  if (form.items.empty() || form.items[0].kind != SchemeForm::Kind::symbol) return {};
  if (std::optional<SchemeValue> value = special(form)) return *std::move(value);
  const std::string& name = form.items[0].word;
  const auto function = functions_.find(name);
  if (function != functions_.end()) return call(function->second, form);
  if (std::optional<SchemeValue> value = arithmetic(name, form)) return *std::move(value);
  if (std::optional<SchemeValue> value = other_builtin(name, form)) return *std::move(value);
  if (std::optional<SchemeValue> value = command_(form, *this)) return *std::move(value);
  if (unknown_.empty()) unknown_ = name;
  return {};
}

SchemeValue SchemeEvaluator::body(const SchemeForm& form, std::size_t first) {
  SchemeValue value;
  for (std::size_t k = first; k < form.items.size(); ++k) value = evaluate(form.items[k]);
  return value;
}

std::optional<SchemeValue> SchemeEvaluator::special(const SchemeForm& form) {
  const std::string& name = form.items[0].word;
  const std::size_t count = form.items.size();
  if (name == "define") return define(form);
  if (name == "set!" && count == 3 && form.items[1].kind == SchemeForm::Kind::symbol) {
    SchemeValue value = evaluate(form.items[2]);
    auto scope = std::find_if(scopes_.rbegin(), scopes_.rend(),
                              [&](const auto& s) { return s.contains(form.items[1].word); });
    (scope == scopes_.rend() ? scopes_.front() : *scope)[form.items[1].word] = std::move(value);
    return SchemeValue{};
  }
  if (name == "begin") return body(form, 1);
  if (name == "let" && count > 2 && form.items[1].kind == SchemeForm::Kind::symbol)
    return loop(form);
  if (name == "let" || name == "let*") return let(form, name == "let*");
  if (name == "cond") return cond(form);
  if (name == "if" && count >= 3) {
    const std::optional<bool> holds = condition(form.items[1]);
    if (holds.value_or(false)) return evaluate(form.items[2]);
    return holds && count > 3 ? evaluate(form.items[3]) : SchemeValue{};
  }
  if ((name == "when" || name == "unless") && count >= 2)
    return condition(form.items[1]) == (name == "when") ? body(form, 2) : SchemeValue{};
  if (name == "and" || name == "or") {
    SchemeValue value = truth(name == "and");
    for (std::size_t k = 1; k < count && value.is_true() == (name == "and"); ++k) {
      value = evaluate(form.items[k]);
      if (value.is(Kind::none)) break;
    }
    return value;
  }
  for (std::size_t k = loops_.size(); k-- > 0;) {
    if (!loops_[k].tails.contains(&form)) continue;
    Values next = arguments(form);  // in which loops may begin and end, so that loops_ moves
    loops_[k].next = std::move(next);
    return SchemeValue{};
  }
  return std::nullopt;
}

/// Whether the form holds; nothing if it is not understood: then no branch counts.
std::optional<bool> SchemeEvaluator::condition(const SchemeForm& form) {
  const SchemeValue value = evaluate(form);
  if (!value.is(Kind::none)) return value.is_true();
  if (unknown_.empty()) unknown_ = "a condition";
  return std::nullopt;
}

SchemeValue SchemeEvaluator::define(const SchemeForm& form) {
  if (form.items.size() < 3) {
    unknown_ = "define";
    return {};
  }
  const SchemeForm& what = form.items[1];
  if (what.kind == SchemeForm::Kind::symbol) {
    scopes_.back()[what.word] = evaluate(form.items[2]);
  } else if (what.kind == SchemeForm::Kind::list && !what.items.empty()) {
    Function function{{}, &form};
    for (std::size_t k = 1; k < what.items.size(); ++k)
      function.names.push_back(what.items[k].word);
    functions_[what.items[0].word] = std::move(function);
  }
  return {};
}

SchemeValue SchemeEvaluator::let(const SchemeForm& form, bool in_order) {
  if (form.items.size() < 2 || form.items[1].kind != SchemeForm::Kind::list) {
    unknown_ = "let";
    return {};
  }
  std::map<std::string, SchemeValue> scope;
  if (in_order) scopes_.emplace_back();
  for (const SchemeForm& pair : form.items[1].items) {
    if (pair.items.size() != 2) continue;
    SchemeValue value = evaluate(pair.items[1]);
    (in_order ? scopes_.back() : scope)[pair.items[0].word] = std::move(value);
  }
  if (!in_order) scopes_.push_back(std::move(scope));
  SchemeValue value = body(form, 2);
  scopes_.pop_back();
  return value;
}

/// (let NAME ((x first) ...) body), where the body calls NAME last, if at all: a loop. A call of it
/// elsewhere is not understood.
SchemeValue SchemeEvaluator::loop(const SchemeForm& form) {
  if (form.items[2].kind != SchemeForm::Kind::list) {
    unknown_ = "let";
    return {};
  }
  std::vector<std::string> names;
  Values values;
  for (const SchemeForm& pair : form.items[2].items) {
    if (pair.items.size() != 2) continue;
    names.push_back(pair.items[0].word);
    values.push_back(evaluate(pair.items[1]));
  }
  Loop own;
  if (form.items.size() > 3) add_tails(form.items.back(), form.items[1].word, own.tails);
  loops_.push_back(std::move(own));
  const std::size_t scope = scopes_.size();
  scopes_.emplace_back();
  SchemeValue value;
  for (bool goes_on = true; goes_on && !error_;) {
    values.resize(names.size());
    for (std::size_t k = 0; k < names.size(); ++k) scopes_[scope][names[k]] = std::move(values[k]);
    value = body(form, 3);
    goes_on = loops_.back().next.has_value();
    if (goes_on) values = *std::exchange(loops_.back().next, std::nullopt);
  }
  scopes_.pop_back();
  loops_.pop_back();
  return value;
}

/// The calls of `name` that a form ends with.
void SchemeEvaluator::add_tails(const SchemeForm& form, const std::string& name,
                                std::set<const SchemeForm*>& tails) {
  if (form.items.empty()) return;
  const std::string& head = form.items[0].word;
  const std::size_t count = form.items.size();
  if (head == name) {
    tails.insert(&form);
  } else if (head == "if") {
    for (std::size_t k = 2; k < count; ++k) add_tails(form.items[k], name, tails);
  } else if (head == "cond") {
    for (std::size_t k = 1; k < count; ++k) {
      if (form.items[k].items.size() > 1) add_tails(form.items[k].items.back(), name, tails);
    }
  } else if (head == "begin" || head == "let" || head == "let*" || head == "when" ||
             head == "unless" || head == "and" || head == "or") {
    if (count > 1) add_tails(form.items.back(), name, tails);
  }
}

SchemeValue SchemeEvaluator::cond(const SchemeForm& form) {
  for (std::size_t k = 1; k < form.items.size(); ++k) {
    const SchemeForm& clause = form.items[k];
    if (clause.items.empty()) continue;
    if (clause.items[0].word == "else") return body(clause, 1);
    const std::optional<bool> holds = condition(clause.items[0]);
    if (!holds) return {};
    if (*holds) return body(clause, 1);
  }
  return {};
}

SchemeValue SchemeEvaluator::call(const Function& function, const SchemeForm& form) {
  Values values = arguments(form);
  const std::vector<std::string> names = function.names;
  const SchemeForm* const definition = function.form;
  values.resize(names.size());
  auto& scope = scopes_.emplace_back();
  for (std::size_t k = 0; k < names.size(); ++k) scope[names[k]] = std::move(values[k]);
  SchemeValue value = body(*definition, 2);
  scopes_.pop_back();
  return value;
}

std::optional<SchemeValue> SchemeEvaluator::arithmetic(std::string_view name,
                                                       const SchemeForm& form) {
  const bool folds = name == "+" || name == "-" || name == "*" || name == "/";
  const bool compares = name == "=" || name == "<" || name == ">" || name == "<=" || name == ">=";
  const bool extreme = name == "min" || name == "max";
  const auto* const one = std::find_if(std::begin(kOneNumber), std::end(kOneNumber),
                                       [&](const OneNumber& f) { return f.name == name; });
  const bool two = name == "expt" || name == "atan" || name == "modulo";
  if (!folds && !compares && !extreme && !two && one == std::end(kOneNumber)) return std::nullopt;
  const Values values = arguments(form);
  if (values.empty() || !all_numbers(values)) return SchemeValue{};
  const double first = values[0].number, second = values.size() > 1 ? values[1].number : 0;
  if (one != std::end(kOneNumber)) return number_value(one->function(first));
  if (name == "atan")
    return number_value(values.size() > 1 ? std::atan2(first, second) : std::atan(first));
  if (name == "expt") return number_value(std::pow(first, second));
  if (name == "modulo") return number_value(first - second * std::floor(first / second));
  if (compares) {
    bool holds = true;
    for (std::size_t k = 1; k < values.size(); ++k)
      holds = holds && compare(name, values[k - 1].number, values[k].number);
    return truth(holds);
  }
  if (values.size() == 1 && name == "-") return number_value(-first);
  if (values.size() == 1 && name == "/") return number_value(1 / first);
  double result = first;
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double next = values[k].number;
    result = !extreme        ? fold(name[0], result, next)
             : name == "min" ? std::min(result, next)
                             : std::max(result, next);
  }
  return number_value(result);
}

std::optional<SchemeValue> SchemeEvaluator::other_builtin(std::string_view name,
                                                          const SchemeForm& form) {
  if (name == "not") {
    const Values values = arguments(form);
    if (values.empty() || values[0].is(Kind::none)) return SchemeValue{};
    return truth(!values[0].is_true());
  }
  if (name == "eq?" || name == "eqv?" || name == "equal?" || name == "string=?") {
    const Values values = arguments(form);
    if (values.size() != 2) return SchemeValue{};
    const std::optional<bool> same = are_equal(values[0], values[1]);
    return same ? truth(*same) : SchemeValue{};
  }
  const auto* const question = std::find_if(std::begin(kQuestions), std::end(kQuestions),
                                            [&](const Question& q) { return q.name == name; });
  if (question != std::end(kQuestions)) {
    const Values values = arguments(form);
    return values.size() == 1 && all_numbers(values) ? truth(question->holds(values[0].number))
                                                     : SchemeValue{};
  }
  if (name == "list") {
    SchemeValue list;
    list.kind = Kind::list;
    list.items = arguments(form);
    return weight(list) > kSchemeText ? fail(form, "this makes too long a list") : list;
  }
  if (name == "car") {
    const Values values = arguments(form);
    if (values.empty()) return SchemeValue{};
    if (!values[0].is(Kind::list)) return values[0];
    return values[0].items.empty() ? SchemeValue{} : values[0].items[0];
  }
  if (name == "string-append") {
    std::string text;
    for (const SchemeValue& value : arguments(form)) text += value.text;
    if (text.size() > kSchemeText) return fail(form, "this puts too long a text together");
    return text_value(std::move(text));
  }
  if (name == "number->string") {
    const Values values = arguments(form);
    return values.empty() ? SchemeValue{} : text_value(fmt::format("{}", values[0].number));
  }
  if (name == "position" || name == "gvector") {
    const Values values = arguments(form);
    if (values.size() < 2 || !all_numbers(values)) return SchemeValue{};
    SchemeValue position;
    position.kind = Kind::position;
    position.at = {values[0].number, values[1].number};
    return position;
  }
  return std::nullopt;
}

}  // namespace cover
