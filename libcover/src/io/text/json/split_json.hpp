// Long arrays of a JSON document, an element at a time, so that there is no tree of the whole.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cover {

/// A document whose root is an object, with some of the root's arrays taken out.
struct SplitJson {
  struct Array {
    std::string name;
    std::vector<std::string_view> elements;  ///< each as it stands in the text
  };
  std::string rest;           ///< the document with these arrays empty
  std::vector<Array> arrays;  ///< in the order of the text

  /// The array of that name; nullptr if there is none.
  [[nodiscard]] const Array* find(std::string_view name) const;
};

/// What somebody has read of an array: up to an element, or, if `is_closed`, up to the "]" behind
/// the last one.
struct Passed {
  std::size_t to;
  bool is_closed;
};
/// Reads elements that an array of that name begins with, at `from` in the text; they are not among
/// Array::elements then. One that reads none returns `from`.
using PassElements = std::function<Passed(std::string_view name, std::size_t from)>;

/// Takes those of the root's members out that are arrays and have one of these names, of each name
/// the first; nothing where there is none. What it finds is looked at no further than brackets and
/// strings tell: the text is JSON if the rest and each element are.
///
/// Cost: O(n), and no copy of the elements
std::optional<SplitJson> split_json(std::string_view text,
                                    std::initializer_list<std::string_view> names,
                                    const PassElements& pass = {});

}  // namespace cover
