// Columns of text for a terminal.
#pragma once

#include <string>
#include <vector>

namespace cover::app {

/// A table whose columns are as wide as their widest cell. Text columns are flush left, number
/// columns flush right.
class TextTable {
 public:
  enum class Align { left, right };
  struct Column {
    std::string title;
    Align align = Align::right;
  };

  explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Cells may hold anything: see printable().
  ///
  /// REQUIRES: as many cells as columns
  void add(std::vector<std::string> cells);
  [[nodiscard]] std::string text(const std::string& indent = "  ") const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace cover::app
