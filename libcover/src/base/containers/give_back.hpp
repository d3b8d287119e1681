// Memory that is not needed any more.
#pragma once

#include <vector>

namespace cover {

/// Empties a list and gives its memory back. (`list = {}` is an assignment of no items, which keeps
/// the memory for others.)
template <class T, class Allocator>
void give_back(std::vector<T, Allocator>& list) {
  std::vector<T, Allocator>().swap(list);
}

}  // namespace cover
