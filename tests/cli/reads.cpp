// reads: for each path on standard input a line with the reader's error, empty where it has none.
// Many files in one process, for schema_test.py.
#include <iostream>
#include <string>

#include <cover/read_input.hpp>

int main() {
  for (std::string path; std::getline(std::cin, path);) {
    const cover::Result<cover::Input> input = cover::read_input(path);
    std::cout << (input ? "" : input.error().message) << '\n';
  }
}
