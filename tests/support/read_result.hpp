// What a reader must make of a text: an input, or words of an error.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover::testing {

/// The input; where there is an error instead, the test fails with its words.
inline Input must_read(Result<Input> read) {
  EXPECT_TRUE(read.has_value()) << (read ? "" : read.error().message);
  return read ? *std::move(read) : Input();
}

/// The words of the error; where there is none, the test fails.
inline std::string must_refuse(const Result<Input>& read) {
  EXPECT_FALSE(read.has_value());
  return read ? "" : read.error().message;
}

}  // namespace cover::testing
