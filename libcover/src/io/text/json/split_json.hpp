// A long array of a JSON document, an element at a time, so that there is no tree of the whole.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// A document whose root is an object, with one of the root's arrays taken out.
struct SplitJson {
  std::string name;                        ///< of that array
  std::string rest;                        ///< the document with that array empty
  std::vector<std::string_view> elements;  ///< of the array, each as it stands in the text
};

/// Takes the first of the root's members out that is an array and has one of these names; nothing
/// where there is none. What it finds is looked at no further than brackets and strings tell: the
/// text is JSON if the rest and each element are.
///
/// Cost: O(n), and no copy of the elements
std::optional<SplitJson> split_json(std::string_view text,
                                    std::initializer_list<std::string_view> names);

/// The point that `[x, y]` stands for, with the doubles that a tree of it would have; nothing for
/// all else, which is not always an error.
///
/// Cost: some 0.05 us, a tenth of what a tree takes, and no memory
std::optional<Point> read_pair(std::string_view element);

/// The same for a pair of integers.
std::optional<std::array<long, 2>> read_integer_pair(std::string_view element);

}  // namespace cover
