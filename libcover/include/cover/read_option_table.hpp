// Every option of readers as people write it: name, unit, range, default, help.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cover/option_table.hpp>
#include <cover/read_options.hpp>
#include <cover/report.hpp>

namespace cover {

using ReadOptionEntry = OptionOf<ReadOptions>;

/// The options of readers, in the order in which help lists them. Rows whose `counts` is set ask
/// for ReadOptions::format.
std::span<const ReadOptionEntry> read_option_table();

/// The entry of that name, in which '_' counts as '-'; nullptr if there is none.
const ReadOptionEntry* find_read_option(std::string_view name);

/// The value that counts unless another is given; empty: none.
std::string default_text(const ReadOptionEntry& entry);

/// Whatever is not at its default, but unit and scale, which reports have anyway.
std::vector<Provenance::Setting> describe_read_options(const ReadOptions& options);

}  // namespace cover
