// Keyword arguments as Options.
#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include <cover/options.hpp>
#include <cover/read_options.hpp>
#include <cover/write_options.hpp>

namespace cover::python {

/// Options of option_table() with sentences on those that have no effect.
struct Keywords {
  Options options;
  std::vector<std::string> idle;
};

/// Options of option_table() by their names with '_' for '-', and as the plural `sizes`, `sizes_at`
/// and without the `no_`. None leaves one out.
///
/// Raises: TypeError for a keyword that is none and a value of another kind, OptionError for a
///         value that is not allowed.
Keywords options_from(const pybind11::dict& keywords);

/// Takes the options of read_option_table() out of `keywords`.
/// Raises: as options_from()
ReadOptions take_read_options(pybind11::dict& keywords);

/// The options of write_option_table().
/// Raises: as options_from()
WriteOptions write_options_from(const pybind11::dict& keywords);

}  // namespace cover::python
