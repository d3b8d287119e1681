// Tested by tests/unit/clean/pslg_test.cpp.
#include "base/faults/complaint.hpp"

#include <fmt/core.h>

#include <algorithm>

#include <cover/text.hpp>

#include "base/words/and_more.hpp"

namespace cover {
namespace {

constexpr std::size_t kSentences = 5;  // what fits a terminal; the rest is counted

}  // namespace

void Complaint::add(std::string sentence, std::vector<Point> where, std::vector<InputRef> inputs) {
  if (++count_ <= kSentences) sentences_.push_back(std::move(sentence));
  where_.insert(where_.end(), where.begin(), where.end());
  inputs_.insert(inputs_.end(), inputs.begin(), inputs.end());
}

void Complaint::append(const Complaint& other) {
  if (empty()) code_ = other.code_;
  sentences_.insert(sentences_.end(), other.sentences_.begin(), other.sentences_.end());
  sentences_.resize(std::min(sentences_.size(), kSentences));
  where_.insert(where_.end(), other.where_.begin(), other.where_.end());
  inputs_.insert(inputs_.end(), other.inputs_.begin(), other.inputs_.end());
  count_ += other.count_;
}

Error Complaint::error() const {
  std::string message = source_.empty() ? "" : source_ + ": ";
  message += listed(sentences_, "; ");
  if (count_ > kSentences) message += and_more(count_, kSentences, ";") + " like these";
  return {code_, message, where_, inputs_};
}

long point_id(const Input& input, std::size_t point) {
  return input.point_ids.empty() ? static_cast<long>(point) : input.point_ids[point];
}

std::string name_of_point(const Input& input, std::size_t point) {
  return fmt::format("point {} at {}{}", point_id(input, point), describe(input.points[point]),
                     line_suffix(input.point_lines.empty() ? 0 : input.point_lines[point]));
}

std::string name_of_segment(const Input& input, std::size_t segment) {
  const InputSegment& s = input.segments[segment];
  return fmt::format("segment {} from point {} to point {}{}{}", s.id, point_id(input, s.a),
                     point_id(input, s.b), line_suffix(s.line), file_suffix(input, s.file));
}

std::string file_suffix(const Input& input, std::uint32_t file) {
  return file < input.files.size() ? " of " + input.files[file] : "";
}

std::string line_suffix(int line) { return line > 0 ? fmt::format(" (line {})", line) : ""; }

}  // namespace cover
