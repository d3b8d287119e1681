// Rows of tables of options: how a value of each kind is read, written and checked.
//
//   whole<&Options::pieces>({.name = "pieces", .range = ranges::kPieces, .help = "..."})
//
// A row is made of its member and of what is said about it; everything else follows from the type
// of the member.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>

#include <fmt/core.h>

#include <cover/option_table.hpp>
#include <cover/text.hpp>

#include "base/faults/errors.hpp"
#include "base/words/parse_number.hpp"

namespace cover::option_kinds {

/// A number that fills the whole text, with a plus sign or without.
template <class Number>
std::optional<Number> parse(std::string_view text) {
  return parse_number<Number>(without_plus(text));
}

/// A number in the range of the row.
template <class Target>
Result<double> number_of(const OptionOf<Target>& row, std::string_view text) {
  const std::optional<double> value = parse<double>(text);
  if (!value) return bad_option(fmt::format("'{}' is not a number", text));
  if (!row.range.holds(*value))
    return bad_option(fmt::format("{} is not {}", text, describe(row.range)));
  return *value;
}

/// The position of a word among those of the row.
template <class Target>
Result<std::size_t> word_of(const OptionOf<Target>& row, std::string_view text) {
  const auto words = row.words();
  const auto at = std::find(words.begin(), words.end(), text);
  if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
  return bad_option(not_one_of(text, std::vector<std::string>(words.begin(), words.end())));
}

/// The name of the row as that of a member.
template <class Target>
std::string keyword_of(const OptionOf<Target>& row) {
  std::string name(row.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Why a value that `range` does not hold is refused.
template <class Target>
Error out_of_range(const OptionOf<Target>& row, const std::string& value) {
  return bad_option(
      fmt::format("{} is {}, but must be {}", keyword_of(row), value, describe(row.range)));
}

/// The row of that name, in which '_' counts as '-'; nullptr if there is none.
template <class Target>
const OptionOf<Target>* find_in(std::span<const OptionOf<Target>> table, std::string_view name) {
  const auto same = [](char a, char b) { return a == (b == '_' ? '-' : b); };
  for (const OptionOf<Target>& row : table) {
    if (std::equal(row.name.begin(), row.name.end(), name.begin(), name.end(), same)) return &row;
  }
  return nullptr;
}

/// What counts unless another value is given, as it would be written; several with commas.
template <class Target>
std::string default_of(const OptionOf<Target>& row) {
  return listed(row.get(row, Target()), ",");
}

/// Whether all values are in the ranges of their rows.
///
/// Errors: bad_option
template <class Target>
Status check_all(std::span<const OptionOf<Target>> table, const Target& target) {
  for (const OptionOf<Target>& row : table) {
    if (row.check == nullptr) continue;
    if (Status status = row.check(row, target); !status) return status;
  }
  return ok();
}

template <auto Member>
struct MemberOf;
template <class TargetType, class ValueType, ValueType TargetType::*Member>
struct MemberOf<Member> {
  using Target = TargetType;
  using Value = ValueType;
};
template <auto Member>
using TargetOf = typename MemberOf<Member>::Target;
template <auto Member>
using ValueOf = typename MemberOf<Member>::Value;

template <class T>
struct Content {
  using Type = T;
};
template <class T>
struct Content<std::optional<T>> {
  using Type = T;
};

/// The value of a member, which may be optional.
template <class T>
const T* content(const T& member) {
  return &member;
}
template <class T>
const T* content(const std::optional<T>& member) {
  return member ? &*member : nullptr;
}

/// A bool that is `Given` where the option stands alone.
template <auto Member, bool Given = true>
constexpr auto flag(OptionOf<TargetOf<Member>> row) {
  using Row = OptionOf<TargetOf<Member>>;
  row.kind = OptionKind::flag;
  row.set = [](const Row&, std::string_view text, TargetOf<Member>& target) -> Status {
    if (text != "true" && text != "false")
      return bad_option(fmt::format("'{}' is not true or false", text));
    target.*Member = (text == "true") == Given;
    return ok();
  };
  row.get = [](const Row&, const TargetOf<Member>& target) {
    return target.*Member == Given ? std::vector<std::string>{"true"} : std::vector<std::string>();
  };
  return row;
}

/// An enumeration whose words stand in the order of its values.
template <auto Member>
constexpr auto word(OptionOf<TargetOf<Member>> row) {
  using Row = OptionOf<TargetOf<Member>>;
  row.kind = OptionKind::word;
  row.set = [](const Row& self, std::string_view text, TargetOf<Member>& target) -> Status {
    const Result<std::size_t> found = word_of(self, text);
    if (!found) return found.error();
    target.*Member = static_cast<ValueOf<Member>>(*found);
    return ok();
  };
  row.get = [](const Row& self, const TargetOf<Member>& target) {
    return std::vector{std::string(self.words()[static_cast<std::size_t>(target.*Member)])};
  };
  row.check = [](const Row& self, const TargetOf<Member>& target) -> Status {
    const auto value = static_cast<std::underlying_type_t<ValueOf<Member>>>(target.*Member);
    const std::vector<std::string> words(self.words().begin(), self.words().end());
    if (value >= 0 && static_cast<std::size_t>(value) < words.size()) return ok();
    return bad_option(fmt::format("{} is number {}, which is none of {}", keyword_of(self), value,
                                  listed(words)));
  };
  return row;
}

/// A whole number.
template <auto Member>
constexpr auto whole(OptionOf<TargetOf<Member>> row) {
  using Row = OptionOf<TargetOf<Member>>;
  row.kind = OptionKind::whole;
  row.set = [](const Row& self, std::string_view text, TargetOf<Member>& target) -> Status {
    const Result<double> value = number_of(self, text);
    if (!value) return value.error();
    const std::optional<ValueOf<Member>> whole = parse<ValueOf<Member>>(text);
    if (!whole) return bad_option(fmt::format("{} is not a whole number", text));
    target.*Member = *whole;
    return ok();
  };
  row.get = [](const Row&, const TargetOf<Member>& target) {
    return std::vector{std::to_string(target.*Member)};
  };
  row.check = [](const Row& self, const TargetOf<Member>& target) -> Status {
    if (self.range.holds(static_cast<double>(target.*Member))) return ok();
    return out_of_range(self, std::to_string(target.*Member));
  };
  return row;
}

/// A double, or one that need not be there.
template <auto Member>
constexpr auto number(OptionOf<TargetOf<Member>> row) {
  using Row = OptionOf<TargetOf<Member>>;
  row.kind = OptionKind::number;
  row.set = [](const Row& self, std::string_view text, TargetOf<Member>& target) -> Status {
    const Result<double> value = number_of(self, text);
    if (!value) return value.error();
    target.*Member = *value;
    return ok();
  };
  row.get = [](const Row&, const TargetOf<Member>& target) {
    const double* value = content(target.*Member);
    return value != nullptr ? std::vector{describe(*value)} : std::vector<std::string>();
  };
  row.check = [](const Row& self, const TargetOf<Member>& target) -> Status {
    const double* value = content(target.*Member);
    if (value == nullptr || self.range.holds(*value)) return ok();
    return out_of_range(self, describe(*value));
  };
  return row;
}

/// Text as it is, of which there may be none.
template <auto Member>
constexpr auto text(OptionOf<TargetOf<Member>> row) {
  using Row = OptionOf<TargetOf<Member>>;
  row.kind = OptionKind::text;
  row.set = [](const Row& self, std::string_view value, TargetOf<Member>& target) -> Status {
    if (value.empty()) return bad_option(fmt::format("{} is needed", self.placeholder));
    target.*Member = value;
    return ok();
  };
  row.get = [](const Row&, const TargetOf<Member>& target) {
    return (target.*Member).empty() ? std::vector<std::string>() : std::vector{target.*Member};
  };
  return row;
}

/// One of a few words, as text; what the member is at first may be none of them.
template <auto Member>
constexpr auto named(OptionOf<TargetOf<Member>> row) {
  using Row = OptionOf<TargetOf<Member>>;
  row = text<Member>(row);
  row.kind = OptionKind::word;
  row.set = [](const Row& self, std::string_view value, TargetOf<Member>& target) -> Status {
    const Result<std::size_t> found = word_of(self, value);
    if (!found) return found.error();
    target.*Member = value;
    return ok();
  };
  row.check = [](const Row& self, const TargetOf<Member>& target) -> Status {
    const std::string& name = target.*Member;
    if (name == TargetOf<Member>().*Member || word_of(self, name)) return ok();
    const std::vector<std::string> words(self.words().begin(), self.words().end());
    return bad_option(
        fmt::format("{} is '{}', which is not one of {}", keyword_of(self), name, listed(words)));
  };
  return row;
}

/// Texts, one each time that the option is given.
template <auto Member>
constexpr auto texts(OptionOf<TargetOf<Member>> row) {
  using Row = OptionOf<TargetOf<Member>>;
  row.kind = OptionKind::text;
  row.repeats = true;
  row.set = [](const Row& self, std::string_view value, TargetOf<Member>& target) -> Status {
    if (value.empty()) return bad_option(fmt::format("{} is needed", self.placeholder));
    (target.*Member).emplace_back(value);
    return ok();
  };
  row.get = [](const Row&, const TargetOf<Member>& target) { return target.*Member; };
  return row;
}

/// An Angle, or one that need not be there; range and values in degrees.
template <auto Member>
constexpr auto angle(OptionOf<TargetOf<Member>> row) {
  using Row = OptionOf<TargetOf<Member>>;
  row.kind = OptionKind::angle;
  row.unit = "degrees";
  row.placeholder = "DEG";
  row.set = [](const Row& self, std::string_view text, TargetOf<Member>& target) -> Status {
    const Result<double> value = number_of(self, text);
    if (!value) return value.error();
    target.*Member = Angle::degrees(*value);
    return ok();
  };
  row.get = [](const Row&, const TargetOf<Member>& target) {
    const Angle* value = content(target.*Member);
    // As it was given: degrees are kept as radians, which costs the last digits.
    return value != nullptr ? std::vector{fmt::format("{:.12g}", value->in_degrees())}
                            : std::vector<std::string>();
  };
  row.check = [](const Row& self, const TargetOf<Member>& target) -> Status {
    const Angle* value = content(target.*Member);
    // In radians, where an angle made of the limit itself is the limit.
    const Range radians{Angle::degrees(self.range.low).in_radians(),
                        Angle::degrees(self.range.high).in_radians(), self.range.has_low,
                        self.range.has_high};
    if (value == nullptr || radians.holds(value->in_radians())) return ok();
    return out_of_range(self, fmt::format("{:.12g} degrees", value->in_degrees()));
  };
  return row;
}

}  // namespace cover::option_kinds
