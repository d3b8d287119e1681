// Random numbers that are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cover {

/// By how much the state of splitmix64 grows from number to number.
inline constexpr std::uint64_t kSplitmixStep = 0x9e3779b97f4a7c15U;

/// The number that belongs to a state of splitmix64.
///
/// Ref: Steele, Lea, Flood, Fast splittable pseudorandom number generators (2014)
constexpr std::uint64_t splitmix64(std::uint64_t state) {
  state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9U;
  state = (state ^ (state >> 27)) * 0x94d049bb133111ebU;
  return state ^ (state >> 31);
}

/// splitmix64.
class Random {
 public:
  explicit Random(std::uint64_t seed = 1) : state_(seed) {}

  std::uint64_t next() { return splitmix64(state_ += kSplitmixStep); }
  /// Below `n`; not quite even.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  /// In [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

}  // namespace cover
