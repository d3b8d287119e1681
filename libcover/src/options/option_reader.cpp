// Tested by tests/unit/options/option_table_test.cpp.
#include <algorithm>

#include <fmt/core.h>

#include <cover/option_table.hpp>

namespace cover {

Status OptionReader::set(const OptionEntry& entry, std::string_view value) {
  Status status = entry.set(entry, value, options_);
  if (status) given_.push_back(&entry);
  return status;
}

bool OptionReader::given(std::string_view name) const {
  return std::any_of(given_.begin(), given_.end(), [&](const OptionEntry* entry) {
    return entry->name == name && !entry->get(*entry, options_).empty();
  });
}

Options OptionReader::implied() const {
  Options options = options_;
  for (const OptionEntry* entry : given_) {
    if (entry->implies.empty() || given("method") || !given(entry->name)) continue;
    const OptionEntry* method = find_option("method");
    // The words of the table are words of the method.
    if (!method->set(*method, entry->implies, options)) continue;
  }
  return options;
}

Result<Options> OptionReader::result() const {
  for (const OptionEntry* entry : given_) {
    if (entry->needs.empty() || given(entry->needs)) continue;
    return Error{
        ErrorCode::bad_option, fmt::format("{} needs {}", entry->name, entry->needs), {}, {}};
  }
  return implied();
}

std::vector<const OptionEntry*> OptionReader::idle() const {
  std::vector<const OptionEntry*> entries;
  const Options options = implied();
  for (const OptionEntry* entry : given_) {
    const bool twice = std::find(entries.begin(), entries.end(), entry) != entries.end();
    if (entry->counts != nullptr && !entry->counts(options) && !twice) entries.push_back(entry);
  }
  return entries;
}

}  // namespace cover
