// Keyword arguments as Options.
#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include <cover/options.hpp>
#include <cover/picture.hpp>
#include <cover/read_option_table.hpp>
#include <cover/write_option_table.hpp>

namespace cover::python {

/// A value as Python would print it, short.
std::string shown(const pybind11::handle& value);

/// Options of option_table() with sentences on those that have no effect.
struct Keywords {
  Options options;
  std::vector<std::string> idle;
};

/// Options of option_table() by their names with '_' for '-', and as the plural `sizes`, `sizes_at`
/// and without the `no_`. None leaves one out, as `before` has it.
///
/// Raises: OptionError for a keyword that is none, and for a value of another kind or that is not
///         allowed.
Keywords options_from(const pybind11::dict& keywords, Options before = {});

/// Options of reading or of writing, and which of them were given.
template <class Target>
struct Given {
  Target options;
  std::vector<const OptionOf<Target>*> entries;
};

/// Takes the options of read_option_table() out of `keywords`.
/// Raises: as options_from()
Given<ReadOptions> take_read_options(pybind11::dict& keywords);

/// The options of write_option_table().
/// Raises: as options_from()
Given<WriteOptions> write_options_from(const pybind11::dict& keywords);

/// How a picture is drawn, and which keywords say so.
struct PictureKeywords {
  PictureOptions options;
  std::vector<std::string> given;
};

/// Takes title, width and color out of `keywords`.
/// Raises: as options_from()
PictureKeywords take_picture_options(pybind11::dict& keywords);

/// Sentences on those of them that were given for a file that is no picture.
std::vector<std::string> idle_picture_options(const PictureKeywords& picture,
                                              const std::string& extension);

/// Sentences on those of the options that have no effect on reading any of `paths`.
std::vector<std::string> idle_read_options(const std::vector<const ReadOptionEntry*>& given,
                                           ReadOptions options,
                                           const std::vector<std::string>& paths);

/// The same of writing a file with this extension: a mesh or a picture.
std::vector<std::string> idle_write_options(const std::vector<const WriteOptionEntry*>& given,
                                            const std::string& extension);

}  // namespace cover::python
