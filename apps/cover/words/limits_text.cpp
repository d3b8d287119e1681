#include "words/limits_text.hpp"

#include <array>

#include <fmt/core.h>

#include "terminal/console.hpp"

namespace cover::app {
namespace {

std::string counts_text(const std::array<std::size_t, kStandings>& counts) {
  std::string text;
  for (const Standing s :
       {Standing::met, Standing::optimal, Standing::near, Standing::coupled, Standing::open}) {
    const std::size_t n = counts[static_cast<std::size_t>(s)];
    if (n > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", grouped(n), describe(s));
  }
  return text;
}

}  // namespace

std::string limits_text(const LimitCounts& counts) {
  const std::string largest = counts_text(counts.largest);
  if (largest.empty()) return {};
  return fmt::format("largest angle {}; smallest angle {}", largest, counts_text(counts.smallest));
}

}  // namespace cover::app
