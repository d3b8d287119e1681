#include <cover/option_table.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace cover {
namespace {

/// Values that the option takes, other than its default.
std::vector<std::string> values_of(const OptionEntry& entry) {
  switch (entry.kind) {
    case OptionKind::flag:
      return {"true"};
    case OptionKind::word:
    case OptionKind::words:
      return {std::string(entry.words().back())};
    case OptionKind::whole:
      return {"7"};
    case OptionKind::number:
    case OptionKind::angle:
      return {std::isfinite(entry.range.high)
                  ? std::to_string((entry.range.low + entry.range.high) / 2)
                  : std::to_string(entry.range.low + 1.5)};
    case OptionKind::text:
      break;
  }
  if (entry.name == "weld") return {"0.25"};
  if (entry.name == "size-field") return {"h.vtu"};
  if (entry.name == "size-of") return {"asinh"};
  if (entry.name == "periodic") return {"a=b", "\"x=1\"=c d@mirror", "e=f@-1,2.5:45"};
  if (entry.name == "layers")
    return {"a=0.5,1.5",       "b c@Si O2=1e-3,1,7", "\"a@b=c\"@\"d=\"=2,1,3", "a@\"x@y\"=2,1,3",
            "7\" wafer=1,1,3", "\"7\"\"@x\"=1,1,3",  "\"\"\"\"=1,1,3"};
  return {"a=0.5", "b c=0x=2"};
}

TEST(OptionTable, HelpOnCouplingsNamesTheExceptionOfAuto) {
  const std::string_view help = find_option("couplings")->help;
  EXPECT_NE(help.find("auto: first; with --split-interfaces targets"), std::string_view::npos);
}

TEST(OptionTable, EveryRowIsWhole) {
  std::set<std::string_view> names;
  std::set<char> letters;
  for (const OptionEntry& entry : option_table()) {
    SCOPED_TRACE(entry.name);
    EXPECT_TRUE(names.insert(entry.name).second);
    EXPECT_TRUE(entry.letter == 0 || letters.insert(entry.letter).second);
    EXPECT_FALSE(entry.help.empty());
    EXPECT_EQ(entry.placeholder.empty(), entry.kind == OptionKind::flag);
    EXPECT_EQ(entry.words().empty(),
              entry.kind != OptionKind::word && entry.kind != OptionKind::words);
    EXPECT_EQ(entry.counts == nullptr, entry.counts_with.empty());
    EXPECT_TRUE(entry.needs.empty() || find_option(entry.needs) != nullptr);
    for (const std::string_view word : entry.words())
      EXPECT_NE(entry.help.find(word), std::string_view::npos) << word;
    ASSERT_NE(entry.set, nullptr);
    ASSERT_NE(entry.get, nullptr);
    // Whatever has a range is checked against it.
    const bool ranged = entry.range.low > -ranges::kNoLimit || entry.range.high < ranges::kNoLimit;
    EXPECT_TRUE(!ranged || entry.check != nullptr);
    EXPECT_TRUE(ranged || (entry.kind != OptionKind::number && entry.kind != OptionKind::angle &&
                           entry.kind != OptionKind::whole));
  }
}

TEST(OptionTable, EveryOptionIsFoundUnderItsNameInPythonToo) {
  for (const OptionEntry& entry : option_table()) {
    std::string name(entry.name);
    EXPECT_EQ(find_option(name), &entry);
    std::replace(name.begin(), name.end(), '-', '_');
    EXPECT_EQ(find_option(name), &entry);
  }
  EXPECT_EQ(find_option("max"), nullptr);
  EXPECT_EQ(find_option("max-angles"), nullptr);
  EXPECT_EQ(find_option(""), nullptr);
}

TEST(OptionTable, WhatIsSetIsToldAndSetAgain) {
  for (const OptionEntry& entry : option_table()) {
    SCOPED_TRACE(entry.name);
    Options options;
    for (const std::string& value : values_of(entry)) {
      const Status status = entry.set(entry, value, options);
      ASSERT_TRUE(status) << status.error().message;
    }
    const std::vector<std::string> told = entry.get(entry, options);
    EXPECT_NE(told, entry.get(entry, Options()));
    Options again;
    for (const std::string& value : told) ASSERT_TRUE(entry.set(entry, value, again));
    EXPECT_EQ(entry.get(entry, again), told);
    // No other option changes with it.
    for (const OptionEntry& other : option_table()) {
      if (&other == &entry) continue;
      EXPECT_EQ(other.get(other, options), other.get(other, Options())) << other.name;
    }
  }
}

TEST(OptionTable, ProvenanceHasWhateverShapesTheMesh) {
  for (const OptionEntry& entry : option_table()) {
    SCOPED_TRACE(entry.name);
    Options options;
    for (const std::string& value : values_of(entry)) ASSERT_TRUE(entry.set(entry, value, options));
    const auto settings = describe_options(options);
    EXPECT_EQ(std::any_of(settings.begin(), settings.end(),
                          [&](const auto& setting) { return setting.name == entry.name; }),
              entry.shapes_mesh);
  }
}

TEST(OptionTable, RangesHoldForTextAndForMembersAlike) {
  for (const OptionEntry& entry : option_table()) {
    SCOPED_TRACE(entry.name);
    if (entry.kind == OptionKind::text || entry.check == nullptr) continue;
    for (const auto& [limit, inside] : {std::pair(entry.range.low, entry.range.has_low),
                                        std::pair(entry.range.high, entry.range.has_high)}) {
      if (!std::isfinite(limit)) continue;
      const std::string text = fmt::format("{}", limit);
      Options options;
      EXPECT_EQ(entry.set(entry, text, options).has_value(), inside) << text;
      EXPECT_TRUE(entry.check(entry, options)) << text;
      const double step = limit == entry.range.low ? -1 : 1;
      EXPECT_FALSE(entry.set(entry, fmt::format("{}", limit + step), options)) << text;
    }
    Options options;
    for (const char* bad : {"nan", "inf", "-inf", "", "x", "1x", "1 ", "0x10", "--1"})
      EXPECT_FALSE(entry.set(entry, bad, options)) << bad;
  }
}

TEST(OptionTable, TextThatIsNoValueIsRefusedInWords) {
  const auto message = [](const char* name, std::string_view value) {
    const OptionEntry* entry = find_option(name);
    Options options;
    const Status status = entry->set(*entry, value, options);
    EXPECT_FALSE(status) << name;
    EXPECT_EQ(status.error().code, ErrorCode::bad_option);
    return status.error().message;
  };
  EXPECT_EQ(message("fill", "disk"), "'disk' is not one of refine, disks; did you mean 'disks'?");
  EXPECT_EQ(message("max-angle", "60"), "60 is not above 60 and below 180");
  EXPECT_EQ(message("threads", "1.5"), "1.5 is not a whole number");
  EXPECT_EQ(message("threads", "-1"), "-1 is not at least 0 and at most 4096");
  EXPECT_EQ(message("hull", "yes"), "'yes' is not true or false");
  EXPECT_EQ(message("size", "a=0"), "'a=0' is not h or NAME=h with a length h above 0");
  EXPECT_EQ(message("size", "a="), "'a=' is not h or NAME=h with a length h above 0");
  EXPECT_EQ(message("size", "a=1+*x"), "'1+*x', column 3: expected a number or a name, not '*'");
  EXPECT_EQ(message("size-at", "gate=x"), "'gate=x' is not NAME=h with a length h above 0");
  EXPECT_EQ(message("layers", "a"),
            "'a' is not LINE[@REGION]=first,growth[,count] with a length, a number and a whole "
            "number");
  for (const char* bad :
       {"a=1", "=1,1,1", "@b=1,1,1", "a@=1,1,1", "a=1,1,1,1", "a=x,1,1", "a=1,1,0.5", "\"a=1,1,1"})
    EXPECT_NE(message("layers", bad).find("is not LINE"), std::string::npos) << bad;
  EXPECT_EQ(message("layers", "a@b=0,1,1"),
            "layers for 'a@b': the first layer is 0, but must be above 0");
  EXPECT_NE(message("layers", "a=nan,1,1").find("the first layer is nan"), std::string::npos);
  EXPECT_NE(message("layers", "a=-1,1,1").find("the first layer is -1"), std::string::npos);
  EXPECT_NE(message("layers", "a=1,0.9,1").find("the growth is 0.9, but must be at least 1"),
            std::string::npos);
  EXPECT_NE(message("layers", "a=1,nan,1").find("the growth is nan"), std::string::npos);
  EXPECT_NE(message("layers", "a=1,1,-1").find("the number of layers is -1"), std::string::npos);
  EXPECT_NE(message("layers", "a=1,1").find("the growth must be above 1"), std::string::npos);
  EXPECT_EQ(message("size-at", "1"), "'1' is not NAME=h with a length h above 0");
  EXPECT_EQ(message("weld", "on"), "'on' is not auto, off or a number, at least 0 and below 1");
}

TEST(OptionTable, LayersOfALineAreAskedForOnce) {
  const OptionEntry& entry = *find_option("layers");
  Options options;
  EXPECT_TRUE(entry.set(entry, "a@b=1,2,3", options));
  EXPECT_TRUE(entry.set(entry, "a@c=1,2,3", options));
  EXPECT_TRUE(entry.set(entry, "a=2,2,3", options));
  const Status twice = entry.set(entry, "a@b=2,2,3", options);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().message, "'a@b=2,2,3': layers for that line are asked for twice");
  EXPECT_EQ(options.layers.size(), 3U);
}

TEST(OptionReader, WhatIsImpliedCountsUnlessAMethodIsGiven) {
  const auto method = [](std::vector<std::pair<const char*, const char*>> words) {
    OptionReader reader;
    for (const auto& [name, value] : words) EXPECT_TRUE(reader.set(*find_option(name), value));
    return reader.result()->method;
  };
  EXPECT_EQ(method({}), Method::quality);
  EXPECT_EQ(method({{"fill", "refine"}}), Method::almond);
  EXPECT_EQ(method({{"paper", "true"}}), Method::almond);
  EXPECT_EQ(method({{"paper", "false"}}), Method::quality);
  EXPECT_EQ(method({{"fill", "disks"}, {"method", "nonobtuse"}}), Method::nonobtuse);
}

TEST(OptionReader, WhatIsNeededMustBeThere) {
  OptionReader reader;
  ASSERT_TRUE(reader.set(*find_option("pieces"), "3"));
  ASSERT_FALSE(reader.result());
  EXPECT_EQ(reader.result().error().message, "pieces needs paper");
  ASSERT_TRUE(reader.set(*find_option("paper"), "true"));
  ASSERT_TRUE(reader.result());
  EXPECT_EQ(reader.result()->pieces, 3);
}

TEST(OptionReader, TellsWhatHasNoEffect) {
  OptionReader reader;
  for (const auto& [name, value] : {std::pair("method", "almond"), std::pair("max-angle", "110"),
                                    std::pair("growth", "2"), std::pair("growth", "3")})
    ASSERT_TRUE(reader.set(*find_option(name), value));
  EXPECT_EQ(reader.idle(), (std::vector{find_option("max-angle"), find_option("growth")}));
  ASSERT_TRUE(reader.set(*find_option("require"), "max-angle"));
  ASSERT_TRUE(reader.set(*find_option("split-interfaces"), "100"));
  EXPECT_TRUE(reader.idle().empty());
}

TEST(CheckOptions, BackgroundSizesMustHaveBeenRead) {
  Options options;
  options.size_field_name = "h.vtu";
  ASSERT_FALSE(check_options(options));
  EXPECT_EQ(check_options(options).error().message, "size_field: h.vtu has not been read");
  options.size_field = [](Point) { return 1.0; };
  EXPECT_TRUE(check_options(options));
}

TEST(CheckOptions, RefusesNumbersThatAreNoWords) {
  const auto refusal = [](auto change) {
    Options options;
    change(options);
    const Status status = check_options(options);
    return status ? std::string() : status.error().message;
  };
  EXPECT_EQ(refusal([](Options& o) { o.method = static_cast<Method>(77); }),
            "method is number 77, which is none of quality, almond, nonobtuse");
  EXPECT_NE(refusal([](Options& o) { o.fill = static_cast<Fill>(-1); }), "");
  EXPECT_NE(refusal([](Options& o) { o.prefer = static_cast<Prefer>(2); }), "");
  EXPECT_NE(refusal([](Options& o) { o.effort = static_cast<Effort>(77); }), "");
  EXPECT_NE(refusal([](Options& o) { o.couplings = static_cast<Couplings>(3); }), "");
  EXPECT_NE(refusal([](Options& o) { o.overlap = static_cast<Overlap>(3); }), "");
}

TEST(CheckOptions, WhatIsToBeResolvedStandsInASizeField) {
  Options options;
  options.size_of = "asinh";
  ASSERT_FALSE(check_options(options));
  EXPECT_NE(check_options(options).error().message.find("size-of is of the values of a file"),
            std::string::npos);
  options.size_field_name = "doping.vtu";
  options.size_field = [](Point) { return 1.0; };
  EXPECT_TRUE(check_options(options));
}

TEST(CheckOptions, TheScaleOfSizeFieldsIsAboveZero) {
  for (const double scale : {0.0, -1.0, std::nan("")}) {
    Options options;
    options.size_field_scale = scale;
    ASSERT_FALSE(check_options(options));
    EXPECT_NE(check_options(options).error().message.find("size_field_scale is"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace cover
