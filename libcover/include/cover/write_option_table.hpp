// Every option of writers as people write it: name, unit, range, default, help.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <cover/option_table.hpp>
#include <cover/write_options.hpp>

namespace cover {

using WriteOptionEntry = OptionOf<WriteOptions>;

/// Every option of writing but `stop`, in the order in which help lists them: the command line and
/// Python's keyword arguments are made of this one table.
std::span<const WriteOptionEntry> write_option_table();

/// The entry of that name, in which '_' counts as '-'; nullptr if there is none.
const WriteOptionEntry* find_write_option(std::string_view name);

/// Whether the option has an effect on files of this extension (".msh"); that counts_with names.
bool counts_with(const WriteOptionEntry& entry, std::string_view extension);

/// The value that counts unless another is given, as it would be written. Empty: none.
std::string default_text(const WriteOptionEntry& entry);

}  // namespace cover
