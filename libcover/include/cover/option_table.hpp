// Every option of the mesher as people write it: name, unit, range, default, help. The command
// line, job files, Python's keyword arguments, provenance and the manual are made of this one
// table.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cover/option_ranges.hpp>
#include <cover/options.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

namespace cover {

/// What a value is written as.
enum class OptionKind {
  flag,    ///< true or false; on the command line it stands alone
  word,    ///< one of a few words
  words,   ///< any of a few words, separated by commas or given again
  whole,   ///< a whole number
  number,  ///< a number
  angle,   ///< a number of degrees
  text,    ///< anything else, as its help says
};

/// What an option is about.
enum class OptionGroup {
  cleaning,  ///< how the input is understood: before there is any mesh
  meshing,
};

/// A row of a table of options, whose values end in a `Target`. Immutable.
template <class Target>
struct OptionOf {
  std::string_view name = {};         ///< "max-angle"; without dashes in front
  char letter = 0;                    ///< its short form on the command line, if it has one
  std::string_view placeholder = {};  ///< what stands for the value in help: "DEG"
  std::string_view unit = {};         ///< "degrees", "length", ...; empty: a pure number or none
  Range range = ranges::kAll;         ///< of numbers
  std::array<std::string_view, 6> word_list{};  ///< see words()
  std::string_view alone =
      {};                ///< the value that is meant where the name stands without one; empty: none
  bool repeats = false;  ///< may be given several times; else the last counts
  bool shapes_mesh = true;      ///< false: meshes are the same with any value
  std::string_view needs = {};  ///< the option without which it is refused; empty: none
  std::string_view implies =
      {};                      ///< the method that it stands for where none is given; empty: none
  std::string_view help = {};  ///< one line
  std::string_view more = {};  ///< what the manual says after it; may be empty
  /// With what it has an effect, where not always: see counts; of writing, extensions.
  std::string_view counts_with = {};
  bool (*counts)(const Target&) = nullptr;  ///< whether it has one; nullptr: not told by a Target
  OptionGroup group = OptionGroup::meshing;
  OptionKind kind = OptionKind::text;

  /// Sets the value, or adds one of an option that repeats.
  ///
  /// Errors: bad_option, with a message that does not name the option
  Status (*set)(const OptionOf&, std::string_view value, Target&) = nullptr;
  /// The values as set() takes them; none where the option is off.
  std::vector<std::string> (*get)(const OptionOf&, const Target&) = nullptr;
  /// Whether the value is in its range.
  /// Errors: bad_option
  Status (*check)(const OptionOf&, const Target&) = nullptr;

  /// The words of OptionKind::word and words.
  [[nodiscard]] constexpr std::span<const std::string_view> words() const {
    std::size_t n = 0;
    while (n < word_list.size() && !word_list[n].empty()) ++n;
    return {word_list.data(), n};
  }
};

using OptionEntry = OptionOf<Options>;

/// In the order in which help and provenance list them.
std::span<const OptionEntry> option_table();

/// The entry of that name, in which '_' counts as '-'; nullptr if there is none.
const OptionEntry* find_option(std::string_view name);

/// The value that counts unless another is given, as it would be written; several are separated by
/// commas. Empty: none.
std::string default_text(const OptionEntry& entry);

/// Gathers options that were written by a person.
class OptionReader {
 public:
  OptionReader() = default;
  /// `before`: what holds where nothing is given.
  explicit OptionReader(Options before) : options_(std::move(before)) {}

  /// Takes one value for the option, as OptionEntry::set does.
  ///
  /// Errors: bad_option
  Status set(const OptionEntry& entry, std::string_view value);

  /// What was given, with what it implies.
  ///
  /// Errors: bad_option, where one option lacks another that it needs
  [[nodiscard]] Result<Options> result() const;

  /// The options that were given and have no effect.
  [[nodiscard]] std::vector<const OptionEntry*> idle() const;

 private:
  [[nodiscard]] bool given(std::string_view name) const;
  [[nodiscard]] Options implied() const;

  Options options_;
  std::vector<const OptionEntry*> given_;
};

/// The method, and whatever else shapes the mesh and differs from its default, so that a mesh can
/// be traced to its options. OptionReader makes the same of it again, apart from
/// Options::size_field and from the last digits of angles.
std::vector<Provenance::Setting> describe_options(const Options& options);

/// Are all options in their legal ranges?
///
/// Errors: bad_option; the message names the option, its value and the legal range.
Status check_options(const Options& options);

}  // namespace cover
