// What a map says of its features beside their shape: columns of its table.
#pragma once

#include <string>
#include <vector>

namespace cover {

/// One column. Text is kept as numbers of words, as arrays of a mesh hold it.
struct Attribute {
  std::string name;
  bool is_text = false;
  std::vector<std::string> words;  ///< of text: all different, in the order in which they come up
  /// By feature or region: the number; of text, the index into `words` plus one. None: NaN; of
  /// text 0.
  std::vector<double> values;
};

}  // namespace cover
