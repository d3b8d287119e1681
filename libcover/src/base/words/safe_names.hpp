// Names that any file format, shell and solver script can live with.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cover {

/// `name` with everything but ASCII letters, digits, '_', '-' and '.' replaced by '_'; "unnamed" if
/// it is empty.
std::string safe_name(std::string_view name);

/// `name` as people read it: UTF-8 as it is, with '_' for control characters, double quotes and
/// bytes that are no UTF-8; "unnamed" if it is empty.
std::string legible_name(std::string_view name);

/// The legible forms of `names`, all different, as unique_safe_names() does it.
std::vector<std::string> unique_legible_names(std::span<const std::string> names);
/// The same where some names are `taken` already.
std::vector<std::string> unique_legible_names(std::span<const std::string> names,
                                              const std::set<std::string>& taken);

/// The safe forms of `names`, all different: the second "Si" becomes "Si_2", and so on.
///
/// ENSURES: a name that is safe and occurs once stays as it is.
std::vector<std::string> unique_safe_names(std::span<const std::string> names);

/// The same where some names are `taken` already and none may be above `longest` characters, if
/// that is given, which leave room for a number.
std::vector<std::string> unique_safe_names(std::span<const std::string> names,
                                           const std::set<std::string>& taken,
                                           std::size_t longest = std::string::npos);

}  // namespace cover
