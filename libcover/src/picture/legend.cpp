#include "picture/legend.hpp"

#include <map>

#include <fmt/format.h>

namespace cover {

std::vector<Legend::Row> Legend::grouped_by(std::string Entry::*key) const {
  std::vector<Row> rows;
  std::vector<std::size_t> counts;
  std::map<std::string, std::size_t> index;
  for (const Entry& entry : entries_) {
    const auto [at, is_new] = index.try_emplace(entry.*key, rows.size());
    if (is_new) {
      rows.push_back({entry.colour, entry.*key});
      counts.push_back(0);
    }
    ++counts[at->second];
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (counts[i] > 1) rows[i].text += fmt::format(", {} regions", counts[i]);
  }
  return rows;
}

std::vector<Legend::Row> Legend::rows(std::size_t limit) const {
  std::vector<Row> rows = grouped_by(&Entry::region);
  return rows.size() <= limit ? rows : grouped_by(&Entry::material);
}

}  // namespace cover
