#include <cover/text.hpp>

#include <algorithm>
#include <numeric>
#include <unordered_set>
#include <vector>

#include <fmt/core.h>

#include "base/words/and_more.hpp"
#include "base/words/meant_or_there.hpp"

namespace cover {
namespace {

/// Levenshtein distance, where swapping two neighbouring letters costs one.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), 0U);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

/// Whether these are two names joined by a low line, once the other way round: lines between two
/// regions are called so.
bool are_swapped(std::string_view word, std::string_view candidate) {
  if (word.size() != candidate.size()) return false;
  for (std::size_t k = word.find('_'); k != std::string_view::npos; k = word.find('_', k + 1)) {
    const std::string_view first = word.substr(0, k), second = word.substr(k + 1);
    if (candidate.starts_with(second) && candidate.ends_with(first) &&
        candidate[second.size()] == '_')
      return true;
  }
  return false;
}

/// Whether a combining mark (U+0300 to U+036F) stands at `at` in a text of UTF-8.
bool is_mark_at(std::string_view word, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return k < word.size() ? static_cast<unsigned char>(word[k]) : 0;
  };
  return (byte(at) == 0xcc && byte(at + 1) >= 0x80) ||
         (byte(at) == 0xcd && byte(at + 1) >= 0x80 && byte(at + 1) <= 0xaf);
}

/// A word whose letters beyond ASCII are all '?', those with marks after them too.
std::string without_accents(std::string_view word) {
  std::string plain;
  for (std::size_t at = 0; at < word.size(); ++at) {
    const auto byte = static_cast<unsigned char>(word[at]);
    const bool continues = byte >= 0x80 && byte < 0xc0;
    if (continues) continue;
    if (!is_mark_at(word, at))
      plain += byte < 0x80 ? word[at] : '?';
    else if (!plain.empty())
      plain.back() = '?';
  }
  return plain;
}

bool has_marks(std::string_view word) {
  for (std::size_t at = 0; at < word.size(); ++at)
    if (is_mark_at(word, at)) return true;
  return false;
}

/// Whether words look alike, as one writes accented letters as a letter and a mark after it: files
/// and terminals of macOS do.
bool differ_in_accents(std::string_view one, std::string_view other) {
  return has_marks(one) != has_marks(other) && without_accents(one) == without_accents(other);
}

}  // namespace

std::optional<std::string> closest(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t kLongestWord = 64;  // longer ones are no slips, and would cost time
  if (word.size() > kLongestWord) return std::nullopt;
  // A third of the letters may be wrong; a word that only begins like the candidate counts as one.
  std::size_t best = 1 + word.size() / 3;
  std::optional<std::string> found;
  for (const std::string& candidate : candidates) {
    if (are_swapped(word, candidate) || differ_in_accents(word, candidate)) return candidate;
    const bool begins = word.size() > 2 && candidate.starts_with(word);
    const std::size_t d = lower(word) == lower(candidate) ? 0
                          : begins                        ? 1
                                                          : distance(word, candidate);
    if (d < best) {
      best = d;
      found = candidate;
    }
  }
  return found;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  const auto meant = closest(word, candidates);
  if (!meant) return {};
  if (differ_in_accents(word, *meant))
    return fmt::format(
        "; did you mean '{}'? It looks alike, but one of both has accents as letters of their own, "
        "the other as marks after a letter (NFC and NFD of Unicode)",
        *meant);
  return fmt::format("; did you mean '{}'?", *meant);
}

std::string meant_or_there(std::string_view word, std::span<const std::string> candidates) {
  if (std::string meant = did_you_mean(word, candidates); !meant.empty()) return meant;
  constexpr std::size_t kMost = 8;
  std::unordered_set<std::string_view> seen;
  std::vector<std::string> first;
  for (const std::string& candidate : candidates) {
    const bool is_new = !candidate.empty() && seen.insert(candidate).second;
    if (is_new && first.size() < kMost) first.push_back(fmt::format("'{}'", candidate));
  }
  if (first.empty()) return "";
  return fmt::format("; there {} {}{}", seen.size() == 1 ? "is" : "are", listed(first),
                     and_more(seen.size(), kMost));
}

std::string not_one_of(std::string_view word, std::span<const std::string> candidates) {
  return fmt::format("'{}' is not one of {}{}", word, listed(candidates),
                     did_you_mean(word, candidates));
}

}  // namespace cover
