#include "terminal/console.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <cover/text.hpp>

namespace cover::app {

namespace {

/// Messages quote names and texts of files, which must not steer the terminal.
class PrintableFormatter : public spdlog::formatter {
 public:
  explicit PrintableFormatter(std::string pattern)
      : pattern_(std::move(pattern)), inner_(pattern_) {}

  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) override {
    const std::string text = printable({message.payload.data(), message.payload.size()});
    spdlog::details::log_msg shown = message;
    shown.payload = text;
    inner_.format(shown, out);
  }
  [[nodiscard]] std::unique_ptr<spdlog::formatter> clone() const override {
    return std::make_unique<PrintableFormatter>(pattern_);
  }

 private:
  std::string pattern_;
  spdlog::pattern_formatter inner_;
};

}  // namespace

std::shared_ptr<spdlog::logger> make_logger(const Verbosity& verbosity) {
  auto terminal = std::make_shared<spdlog::sinks::stderr_sink_st>();
  terminal->set_formatter(std::make_unique<PrintableFormatter>("cover: %l: %v"));
  terminal->set_level(verbosity.quiet          ? spdlog::level::err
                      : verbosity.verbose <= 0 ? spdlog::level::warn
                      : verbosity.verbose == 1 ? spdlog::level::info
                                               : spdlog::level::debug);
  std::vector<spdlog::sink_ptr> sinks{terminal};
  if (!verbosity.log_file.empty()) {
    auto file = std::make_shared<spdlog::sinks::basic_file_sink_st>(verbosity.log_file, true);
    file->set_formatter(std::make_unique<PrintableFormatter>("%Y-%m-%d %H:%M:%S.%e %-7l %v"));
    sinks.push_back(file);
  }
  auto log = std::make_shared<spdlog::logger>("cover", sinks.begin(), sinks.end());
  log->set_level(spdlog::level::debug);
  log->flush_on(spdlog::level::info);
  // Whose disk is full has a mesh rather than a log; once will do.
  log->set_error_handler([told = false](const std::string& why) mutable {
    if (!std::exchange(told, true))
      print_on_stderr(
          fmt::format("cover: warning: messages are missing in the log: {}\n", printable(why)));
  });
  return log;
}

void print_on_stderr(const std::string& text) { std::fputs(text.c_str(), stderr); }

int fail(spdlog::logger& log, const Error& error) {
  log.error("{}", error.message);
  if (error.code == ErrorCode::changed_input)
    log.error("--strict refuses every change; without it, 'cover info' and --report list them all");
  return exit_code_of(error.code);
}

namespace {

/// The words of a sentence that are the same whatever it is about: without names and numbers.
std::string pattern_of(std::string_view sentence) {
  std::string pattern;
  bool is_name = false;
  for (const char c : sentence) {
    if (c == '\'') is_name = !is_name;
    if (!is_name && ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'))) pattern += c;
  }
  return pattern;
}

/// By note: whether it is one of the `most` that are shown. Each pattern is shown once before any
/// is shown again, so that many alike hide none that is different.
std::vector<bool> shown_of(const std::vector<const Note*>& notes, std::size_t most) {
  std::vector<bool> shown(notes.size(), notes.size() <= most);
  if (notes.size() <= most) return shown;
  std::set<std::string> seen;
  for (std::size_t k = 0; k < notes.size() && seen.size() < most; ++k)
    shown[k] = seen.insert(pattern_of(notes[k]->message)).second;
  std::size_t left = most - seen.size();
  for (std::size_t k = 0; k < notes.size() && left > 0; ++k) {
    if (shown[k]) continue;
    shown[k] = true;
    --left;
  }
  return shown;
}

}  // namespace

void log_notes(spdlog::logger& log, std::span<const Note> notes) {
  constexpr std::size_t kShown = 10;
  const auto show = [&](Note::Kind kind, const char* plural, const char* prefix,
                        spdlog::level::level_enum level = spdlog::level::warn) {
    std::vector<const Note*> of_kind;
    for (const Note& note : notes)
      if (note.kind == kind) of_kind.push_back(&note);
    const std::vector<bool> shown = shown_of(of_kind, kShown);
    for (std::size_t k = 0; k < of_kind.size(); ++k)
      log.log(shown[k] ? level : spdlog::level::debug, "{}{}", prefix, of_kind[k]->message);
    if (of_kind.size() > kShown) {
      log.log(level, "{} further {} are in the report (--report FILE.json) and shown by -vv",
              of_kind.size() - kShown, plural);
    }
  };
  show(Note::Kind::change, "changes of the input", "input changed: ");
  show(Note::Kind::warning, "warnings", "");
  show(Note::Kind::below_resolution, "places below the resolution of doubles", "");
  show(Note::Kind::bound_missed, "missed bounds", "");
  show(Note::Kind::cut, "cuts", "", spdlog::level::debug);  // the text report has them
  show(Note::Kind::box_cut, "cuts for the box method", "", spdlog::level::debug);
  show(Note::Kind::fallback, "remarks on methods", "", spdlog::level::info);
  show(Note::Kind::target_missed, "missed targets", "", spdlog::level::info);
  show(Note::Kind::repair, "repairs", "", spdlog::level::debug);
}

void log_warnings(spdlog::logger& log, const std::vector<std::string>& warnings) {
  std::vector<Note> notes;
  for (const std::string& warning : warnings)
    notes.push_back({Note::Kind::warning, kVoid, warning, {}});
  log_notes(log, notes);
}

std::vector<Note> not_yet_told(const std::vector<Note>& notes,
                               const std::vector<std::string>& told) {
  std::vector<Note> left;
  std::copy_if(notes.begin(), notes.end(), std::back_inserter(left), [&](const Note& note) {
    return note.kind != Note::Kind::warning ||
           std::find(told.begin(), told.end(), note.message) == told.end();
  });
  return left;
}

std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return digits;
}

std::string plural(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(count), noun, count == 1 ? "" : "s");
}

}  // namespace cover::app
