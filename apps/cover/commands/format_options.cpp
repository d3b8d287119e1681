#include "commands/format_options.hpp"

#include <algorithm>

#include "files/writers.hpp"

namespace cover::app {

void FormatOptions::add(CLI::App& command, const char* group) {
  for (const WriteOptionEntry& entry : write_option_table()) {
    written_.push_back({&entry, default_text(entry), nullptr, {}, false});
    written_.back().add_to(command, group);
  }
}

WriteOptions FormatOptions::make() const {
  WriteOptions options;
  for (const auto& written : written_) {
    for (const std::string& text : written.texts()) {
      // What it refuses was refused when the command line was read.
      static_cast<void>(written.entry->set(*written.entry, text, options));
    }
  }
  return options;
}

std::vector<std::string> FormatOptions::ignored(const std::vector<std::string>& outputs,
                                                const std::string& format) const {
  std::vector<std::string> sentences;
  for (const auto& written : written_) {
    const auto asks = [&](const std::string& path) {
      return counts_with(*written.entry, extension_of_output(path, format));
    };
    if (written.option->count() == 0 || std::any_of(outputs.begin(), outputs.end(), asks)) continue;
    sentences.push_back(does_nothing(*written.entry));
  }
  return sentences;
}

}  // namespace cover::app
