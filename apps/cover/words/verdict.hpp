// What decides whether a mesh can be trusted, in a few sentences.
#pragma once

#include <string>
#include <vector>

#include <cover/options.hpp>
#include <cover/output.hpp>

namespace cover::app {

/// One sentence of a verdict.
struct Finding {
  enum class Grade {
    good,     ///< as it should be
    caution,  ///< a promise is kept, but a target was missed or the input changed
    bad,      ///< a promise is broken
    fact,     ///< neither good nor bad by itself
  };
  Grade grade = Grade::good;
  std::string what;  ///< a word or two
  std::string text;
};

/// Checks promises 1, 2 and 4 on the mesh itself, exactly; tells of the others what the run found,
/// and compares what was reached with its targets.
///
/// Cost: O(n log n)
std::vector<Finding> findings_of(const Output& output);

/// By how much all boxes of the box method together are larger than the mesh, if areas have no
/// signs, in tenths of a percent.
long excess_of_unsigned_boxes(const Report& report);
/// The same in words: "2.5 %".
std::string excess_text(long tenths);

/// The worst grade among them.
Finding::Grade verdict_of(const std::vector<Finding>& findings);

}  // namespace cover::app
