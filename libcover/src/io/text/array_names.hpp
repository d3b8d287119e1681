// What arrays of a mesh file are called that came with the input.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cover {

/// Of the hash of the file with the numbers of an .xdmf.
constexpr std::string_view kXdmfHash = "HashOfNumbers";

/// In a .vtkhdf, whose groups are sorted by name: the names of the input's arrays in their order.
constexpr const char* kArrayOrder = "ArrayOrder";

/// Whether an array of a mesh file is one that every mesh of ours has or may have.
bool is_own_array(std::string_view name);

/// Names for arrays of the input: legible, without '/', all different and none of ours.
std::vector<std::string> array_names(std::vector<std::string> names);

/// What the words of a text attribute are called beside its array.
std::string words_name(const std::string& array);

}  // namespace cover
