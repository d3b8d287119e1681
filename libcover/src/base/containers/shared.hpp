// A large value of which copies are made that are seldom changed.
#pragma once

#include <memory>
#include <utility>

namespace cover {

/// A value. Copies have it in common until one of them is to be changed.
///
/// Threads: one at a time, for all copies
template <class T>
class Shared {
 public:
  Shared() : Shared(T()) {}
  Shared(T value) : value_(std::make_shared<T>(std::move(value))) {}

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }

  /// The value of this copy alone.
  ///
  /// Cost: that of copying a T if others have it too
  T& change() {
    if (value_.use_count() > 1) value_ = std::make_shared<T>(*value_);
    return *value_;
  }

 private:
  std::shared_ptr<T> value_;  ///< never null but in what was moved from
};

}  // namespace cover
