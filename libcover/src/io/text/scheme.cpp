// Lists that are open wait on a stack, so that no text overflows that of the machine.
// Tested by tests/unit/io/input/drawings/read_sde_test.cpp.
#include "io/text/scheme.hpp"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include "base/words/characters.hpp"
#include "io/text/limits.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

class SchemeParser {
 public:
  SchemeParser(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  Result<SchemeText> parse() {
    open_.emplace_back();
    while (!error_ && at_ < text_.size()) is_left_out() ? pass_line() : read();
    if (!error_ && !branches_.empty())
      fail(branches_.back().line, "this condition of the preprocessor has no #endif");
    if (!error_ && open_.size() > 1) fail(open_.back().line, "this parenthesis is not closed");
    if (error_) return *error_;
    out_.forms = std::move(open_.front().items);
    return std::move(out_);
  }

 private:
  void fail(int line, const std::string& what) {
    if (!error_)
      error_ = Error{ErrorCode::syntax, fmt::format("{}:{}: {}", source_, line, what), {}, {}};
  }

  [[nodiscard]] bool starts_line() const {
    for (std::size_t k = at_; k > 0 && text_[k - 1] != '\n'; --k)
      if (text_[k - 1] != ' ' && text_[k - 1] != '\t') return false;
    return true;
  }

  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  }

  void read() {
    const char c = text_[at_];
    if (c == '\n') ++line_;
    if (is_blank(c) || c == '\'' || c == '`') {
      ++at_;
    } else if (c == ';') {
      skip_line();
    } else if (text_.substr(at_, 2) == "#|") {
      skip_comment();
    } else if (c == '#' && is_directive()) {
      read_directive();
    } else if (c == '(' || c == '[') {
      open_list();
    } else if (c == ')' || c == ']') {
      close_list();
    } else if (c == '"') {
      read_text();
    } else {
      read_word();
    }
  }

  /// #if, #else, #endif, ... at the beginning of a line; not #t and #f.
  [[nodiscard]] bool is_directive() const {
    const std::string_view word = text_.substr(at_ + 1, 2);
    const bool is_truth =
        word.size() < 2 || ((word[0] == 't' || word[0] == 'f') && is_end(word[1]));
    return !is_truth && starts_line();
  }

  /// What stands between the lines of a preprocessor's condition.
  struct Branch {
    int line = 0;
    bool is_known = false;   ///< which branch counts
    bool is_taken = false;   ///< this one does
    bool was_taken = false;  ///< this one or one before it did
  };

  [[nodiscard]] bool is_left_out() const {
    return std::any_of(branches_.begin(), branches_.end(),
                       [](const Branch& branch) { return !branch.is_taken; });
  }

  /// A line that is left out, unless it is one of the preprocessor's.
  void pass_line() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    if (at_ < text_.size() && text_[at_] == '#' && is_directive()) return read_directive();
    skip_line();
    if (at_ < text_.size()) ++at_, ++line_;
  }

  /// #if 0, #if 1, #elif, #else, #endif; all else is not understood.
  void read_directive() {
    const std::size_t first = at_;
    skip_line();
    const std::string_view all = trimmed(text_.substr(first, at_ - first));
    const std::string_view word = all.substr(0, all.find_first_of(" \t"));
    const std::string_view condition = trimmed(all.substr(word.size()));
    const std::size_t end = std::min(condition.find(';'), condition.find("//"));  // of a comment
    const std::string_view rest = trimmed(condition.substr(0, end));
    if (word.substr(0, 3) == "#if") {
      const bool is_known = word == "#if" && (rest == "0" || rest == "1");
      if (!is_known && !is_left_out()) out_.conditions.push_back(line_);
      branches_.push_back({line_, is_known, is_known && rest == "1", is_known && rest == "1"});
    } else if ((word == "#else" || word == "#elif") && !branches_.empty()) {
      Branch& branch = branches_.back();
      if (word == "#elif" && branch.is_known && !branch.was_taken && rest != "0" && rest != "1") {
        branch.is_known = false;
        out_.conditions.push_back(line_);
      }
      branch.is_taken = branch.is_known && !branch.was_taken && rest != "0";
      branch.was_taken = branch.was_taken || branch.is_taken;
    } else if (word == "#endif" && !branches_.empty()) {
      branches_.pop_back();
    } else if (!is_left_out()) {
      out_.directives.push_back(line_);
    }
  }

  static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\0';
  }
  static bool is_end(char c) {
    return is_blank(c) || c == '(' || c == ')' || c == '[' || c == ']' || c == '"' || c == ';';
  }

  void skip_comment() {
    const int line = line_;
    const std::size_t end = text_.find("|#", at_ + 2);
    for (; at_ < text_.size() && at_ != end; ++at_) line_ += text_[at_] == '\n';
    if (end == std::string_view::npos) return fail(line, "this comment has no end");
    at_ = end + 2;
  }

  void open_list() {
    if (open_.size() > kSchemeDepth) return fail(line_, "too many lists one in the other");
    SchemeForm list;
    list.line = line_;
    open_.push_back(std::move(list));
    ++at_;
  }

  void close_list() {
    if (open_.size() == 1) return fail(line_, "this parenthesis closes nothing");
    SchemeForm list = std::move(open_.back());
    open_.pop_back();
    open_.back().items.push_back(std::move(list));
    ++at_;
  }

  void read_text() {
    SchemeForm form;
    form.kind = SchemeForm::Kind::text;
    form.line = line_;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
      line_ += text_[at_] == '\n';
      form.word += text_[at_];
    }
    if (at_ == text_.size()) return fail(form.line, "this text has no end");
    ++at_;
    open_.back().items.push_back(std::move(form));
  }

  void read_word() {
    const std::size_t first = at_;
    while (at_ < text_.size() && !is_end(text_[at_])) ++at_;
    SchemeForm form;
    form.line = line_;
    form.word = text_.substr(first, at_ - first);
    const std::optional<double> number = parse_double(form.word);
    const char c = form.word[0];
    const bool spelled = is_digit(c) || c == '-' || c == '+' || c == '.';
    form.kind = number && spelled ? SchemeForm::Kind::number : SchemeForm::Kind::symbol;
    form.number = number.value_or(0);
    open_.back().items.push_back(std::move(form));
  }

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<SchemeForm> open_;  ///< the first is the whole text
  std::vector<Branch> branches_;  ///< of the preprocessor, one in the other
  SchemeText out_;
  std::optional<Error> error_;
};

}  // namespace

Result<SchemeText> parse_scheme(std::string_view text, const std::string& source) {
  return SchemeParser(text, source).parse();
}

}  // namespace cover
