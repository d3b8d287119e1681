// Errors about the input: every element at fault as the user's file knows it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cover/error.hpp>
#include <cover/input.hpp>

namespace cover {

/// Collects what is wrong in one way and makes one Error of it. The message is the source's name
/// and the first few sentences; `where` and `inputs` hold everything.
class Complaint {
 public:
  Complaint(ErrorCode code, std::string source) : code_(code), source_(std::move(source)) {}

  void add(std::string sentence, std::vector<Point> where, std::vector<InputRef> inputs);
  /// Puts all that `other` says behind. An empty complaint takes over the code.
  void append(const Complaint& other);

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] Error error() const;

 private:
  ErrorCode code_;
  std::string source_;
  std::size_t count_ = 0;
  std::vector<std::string> sentences_;  ///< the first ones
  std::vector<Point> where_;
  std::vector<InputRef> inputs_;
};

/// The id of a point of `input` in the user's file.
long point_id(const Input& input, std::size_t point);
/// "point 7 at (0.5, 1) (line 9)".
std::string name_of_point(const Input& input, std::size_t point);
/// "segment 3 from point 1 to point 2 (line 14)", and of which file where there are several.
std::string name_of_segment(const Input& input, std::size_t segment);
/// " of b.dxf", empty unless the input was joined of several.
std::string file_suffix(const Input& input, std::uint32_t file);
/// " (line 9)", empty if the line is unknown.
std::string line_suffix(int line);

}  // namespace cover
