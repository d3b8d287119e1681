// GDAL without prints: what it complains of is kept.
#pragma once

#include <string>
#include <vector>

namespace cover {

/// Gathers what GDAL says in this thread for as long as this lives.
/// REQUIRES: an open GDAL
class QuietGdal {
 public:
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;

  /// Of failures, the first; empty if there was none.
  [[nodiscard]] std::string failure() const { return failures_.empty() ? "" : failures_.front(); }
  void forget() { failures_.clear(); }
  void add_failure(const char* message) { failures_.emplace_back(message); }

 private:
  std::vector<std::string> failures_;
};

}  // namespace cover
