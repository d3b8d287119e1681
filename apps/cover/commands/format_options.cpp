#include "commands/format_options.hpp"

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

}  // namespace cover::app
