// Lists whose new items hold nothing until they are written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/team.hpp"

namespace cover {

/// Leaves items that are made from nothing as their memory is.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);
  template <class U>
  struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
    using other = UnsetAllocator<U>;
  };

  UnsetAllocator() = default;
  template <class U>
  UnsetAllocator(const UnsetAllocator<U>& /*other*/) noexcept {}

  template <class U>
  void construct(U* /*place*/) noexcept {}
  template <class U, class... Values>
  void construct(U* place, Values&&... values) {
    std::construct_at(place, std::forward<Values>(values)...);
  }
};

/// A std::vector of which resize(n) and emplace_back() write nothing. Large arrays are then touched
/// first by the threads that fill them: the system clears pages one by one, which for one thread
/// takes as long as filling them.
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

/// Makes all items `value`, each by the thread that touches it first.
template <class T>
void set_all(UnsetVector<T>& list, std::type_identity_t<T> value, const Team& team) {
  team.each_range(list.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
    std::fill(list.data() + first, list.data() + last, value);
  });
}

/// A copy with room for `most` items, or for more if there are more.
template <class T>
UnsetVector<T> copy_of(const UnsetVector<T>& list, const Team& team, std::size_t most = 0) {
  UnsetVector<T> copy;
  copy.reserve(std::max(most, list.size()));
  copy.resize(list.size());
  team.each_range(list.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
    std::copy(list.data() + first, list.data() + last, copy.data() + first);
  });
  return copy;
}

}  // namespace cover
