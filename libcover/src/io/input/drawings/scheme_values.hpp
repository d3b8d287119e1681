// What commands of a drawing program compute: numbers, texts, positions, and what they name.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <cover/error.hpp>
#include <cover/point.hpp>

#include "io/text/scheme.hpp"

namespace cover {

struct SchemeValue {
  enum class Kind {
    none,   ///< unknown: of a name that nothing defines, or of a command that is not understood
    truth,  ///< `number` is 0 or 1
    number,
    text,
    position,  ///< `at`; its height is left out
    edge,      ///< the line at `at`
    body,      ///< the polygon of the index `number`
    list,
  };
  Kind kind = Kind::none;
  double number = 0;
  std::string text;
  Point at;
  std::vector<SchemeValue> items;

  [[nodiscard]] bool is(Kind k) const { return kind == k; }
  [[nodiscard]] bool is_true() const { return !(kind == Kind::truth && number == 0); }
};

/// Evaluates Scheme as decks of drawing programs have it: define (also of functions), set!, let,
/// let*, loops by let with a name, if, cond, when, unless, begin, and, or, not, arithmetic,
/// comparisons, equal? and the like, sqrt and the like, list, car, string-append, number->string,
/// position and gvector. Names are found in the scope of the caller. Everything else is handed on.
/// Where a condition is not understood, no branch is evaluated.
class SchemeEvaluator {
 public:
  using Values = std::vector<SchemeValue>;
  /// A command that is not Scheme's own: its value, or nothing where it is not known either.
  using Command =
      std::function<std::optional<SchemeValue>(const SchemeForm& form, SchemeEvaluator& evaluator)>;

  SchemeEvaluator(std::string source, Command command)
      : source_(std::move(source)), command_(std::move(command)), scopes_(1) {}

  /// A form of the text. What it cannot say is none.
  SchemeValue evaluate(const SchemeForm& form);
  /// All but the first of a list.
  Values arguments(const SchemeForm& form);

  /// Set where a limit was met: kSchemeSteps, kSchemeDepth, kSchemeText. Everything is none then.
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  /// The first name since the last call that was not known; empty if there was none.
  std::string take_unknown() { return std::exchange(unknown_, {}); }

 private:
  struct Function {
    std::vector<std::string> names;
    const SchemeForm* form;
  };

  /// A loop that is under way.
  struct Loop {
    std::set<const SchemeForm*> tails;  ///< calls that go on with it
    std::optional<Values> next;         ///< what the last of them said
  };

  SchemeValue fail(const SchemeForm& form, const std::string& what);
  SchemeValue look_up(const std::string& name);
  SchemeValue list_value(const SchemeForm& form);
  SchemeValue define(const SchemeForm& form);
  SchemeValue let(const SchemeForm& form, bool in_order);
  SchemeValue loop(const SchemeForm& form);
  SchemeValue cond(const SchemeForm& form);
  std::optional<bool> condition(const SchemeForm& form);
  static void add_tails(const SchemeForm& form, const std::string& name,
                        std::set<const SchemeForm*>& tails);
  SchemeValue body(const SchemeForm& form, std::size_t first);
  SchemeValue call(const Function& function, const SchemeForm& form);
  std::optional<SchemeValue> special(const SchemeForm& form);
  std::optional<SchemeValue> arithmetic(std::string_view name, const SchemeForm& form);
  std::optional<SchemeValue> other_builtin(std::string_view name, const SchemeForm& form);

  std::string source_;
  Command command_;
  std::vector<std::map<std::string, SchemeValue>> scopes_;
  std::map<std::string, Function> functions_;
  std::vector<Loop> loops_;
  std::string unknown_;
  std::optional<Error> error_;
  std::size_t steps_ = 0;
  std::size_t depth_ = 0;
};

}  // namespace cover
