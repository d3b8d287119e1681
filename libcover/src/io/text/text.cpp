// Numbers are read by std::from_chars: no locale, correctly rounded, and the whole field must be
// used up.
// Tested by tests/unit/io/text/text_test.cpp.
#include "io/text/text.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "base/numbers.hpp"
#include "base/words/characters.hpp"
#include "base/words/parse_number.hpp"

namespace cover {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::string_view kBlanksAndCommas = " \t\r\v\f,";

/// A field without the commas that separate it from its neighbours.
std::string_view without_commas(std::string_view field) { return trimmed(field, ","); }

/// Sizes above this are believed byte by byte: sparse files can announce anything.
constexpr std::uintmax_t kMostAtOnce = std::uintmax_t{1} << 30U;

Error cannot_open(const std::string& path, int number) {
  return {ErrorCode::cannot_open,
          fmt::format("cannot open {}: {}", path, std::strerror(number)),
          {},
          {}};
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return cannot_open(path, EISDIR);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) return cannot_open(path, errno);
  std::string text;
  // A file's size is known and saves copies; a pipe's is not.
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  if (!ignored && size <= kMostAtOnce) {
    text.resize(static_cast<std::size_t>(size));
    text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  }
  char buffer[1 << 16];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get())) {
    text.append(buffer, n);
  }
  if (std::ferror(file.get()) != 0) return cannot_open(path, errno);
  return text;
}

std::optional<double> parse_double(std::string_view field) {
  field = without_plus(field);
  double value = 0;
  const auto [end, status] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (end != field.data() + field.size() || status == std::errc::invalid_argument) return {};
  if (status == std::errc::result_out_of_range) return nearest_in_range(field);
  return value;
}

std::optional<long> parse_integer(std::string_view field) {
  return parse_number<long>(without_plus(field));
}

std::string extension_of(const std::string& path) {
  return lower(std::filesystem::path(path).extension().string());
}

std::string legible(std::string_view field) {
  constexpr std::size_t kMost = 40;
  std::string out(field.substr(0, kMost));
  for (char& c : out) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = '?';
  }
  return field.size() > kMost ? out + "..." : out;
}

std::string hint_at_comma(std::string_view field) {
  return field.find(',') == std::string_view::npos
             ? std::string()
             : " (decimals have a point; between numbers stand blanks)";
}

LineReader::LineReader(std::string_view text, std::string source, char comment, Separator separator)
    : rest_(text), source_(std::move(source)), comment_(comment), separator_(separator) {}

bool LineReader::next() {
  const std::string_view blanks = separator_ == Separator::comma ? kBlanksAndCommas : kBlanks;
  fields_.clear();
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    text = text.substr(0, text.find(comment_));
    for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
      const std::size_t stop = text.find_first_of(blanks, at);
      const std::string_view field =
          without_commas(text.substr(at, stop == std::string_view::npos ? stop : stop - at));
      if (!field.empty()) fields_.push_back(field);
      at = stop == std::string_view::npos ? stop : text.find_first_not_of(blanks, stop);
    }
    if (!fields_.empty()) return true;
  }
  return false;
}

Error LineReader::error(ErrorCode code, std::string_view what) const {
  // Nothing was read yet: the file is empty.
  if (line_ == 0) return {code, fmt::format("{}: {}", source_, what), {}, {}};
  return {code, fmt::format("{}:{}: {}", source_, line_, what), {}, {}};
}

}  // namespace cover
