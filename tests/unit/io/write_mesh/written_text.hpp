// Reading a written file word by word: as little as the tests of writers need.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace cover::testing {

inline std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Words between blanks, as numbers where asked for.
class Words {
 public:
  explicit Words(std::string text) : text_(std::move(text)) {}

  std::string word() {
    std::string word;
    text_ >> word;
    return word;
  }
  long integer() { return std::stol(word()); }
  std::uint32_t index(long first = 1) { return static_cast<std::uint32_t>(integer() - first); }
  double number() { return std::strtod(word().c_str(), nullptr); }
  std::string line() {
    std::string line;
    std::getline(text_ >> std::ws, line);
    return line;
  }
  void expect(const std::string& wanted) { ASSERT_EQ(word(), wanted); }
  bool at_end() { return (text_ >> std::ws).eof(); }

 private:
  std::istringstream text_;
};

}  // namespace cover::testing
