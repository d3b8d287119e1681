// Hostile geometry with random options, from bytes: for a fuzzer that changes the bytes, and for
// runs over seeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <cover/input.hpp>
#include <cover/options.hpp>

namespace cover::testing {

/// What is meshed, and how.
struct HostileCase {
  Input input;
  Options options;
  std::string family;  ///< of shapes: "slits", "needles", ...
};

/// Decodes bytes; those that are missing are zero. At most 60 or so points.
HostileCase hostile_case(const std::uint8_t* data, std::size_t size);

/// Bytes of a seed, enough for every choice.
std::vector<std::uint8_t> bytes_of_seed(std::uint64_t seed);

/// The input as JSON that the program reads, coordinates with all their digits.
std::string json_of(const Input& input);

/// The options of the program that mean the same.
std::vector<std::string> arguments_of(const Options& options);

}  // namespace cover::testing
