// Memory that is not needed any more.
#pragma once

#include <vector>

namespace cover {

/// Empties a list and gives its memory back. (`list = {}` is an assignment of no items, which keeps
/// the memory for others.)
template <class T>
void give_back(std::vector<T>& list) {
  std::vector<T>().swap(list);
}

}  // namespace cover
