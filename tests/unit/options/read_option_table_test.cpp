#include <cover/read_option_table.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace cover {
namespace {

std::vector<std::string> values_read_by(const ReadOptionEntry& entry) {
  if (!entry.words().empty()) return {std::string(entry.words().back())};
  if (entry.kind == OptionKind::flag) return {"true"};
  if (entry.kind == OptionKind::number) return {"0.5"};
  if (entry.name == "window") return {"-1,0.5,2,1e3"};
  if (entry.name == "input-format") return {".gds"};
  return entry.repeats ? std::vector<std::string>{"68/20=a b", "x"}
                       : std::vector<std::string>{"68"};
}

TEST(ReadOptionTable, EveryRowIsWholeAndFoundAndNamedLikeNoOtherOption) {
  std::set<std::string_view> names;
  for (const ReadOptionEntry& entry : read_option_table()) {
    SCOPED_TRACE(entry.name);
    EXPECT_TRUE(names.insert(entry.name).second);
    EXPECT_EQ(find_option(entry.name), nullptr);
    std::string in_python(entry.name);
    std::replace(in_python.begin(), in_python.end(), '-', '_');
    EXPECT_EQ(find_read_option(in_python), &entry);
    EXPECT_FALSE(entry.help.empty());
    EXPECT_EQ(entry.placeholder.empty(), entry.kind == OptionKind::flag);
    EXPECT_EQ(entry.counts == nullptr, entry.counts_with.empty());
    ASSERT_NE(entry.set, nullptr);
    ASSERT_NE(entry.get, nullptr);
    const bool has_range = entry.kind == OptionKind::number || entry.kind == OptionKind::whole;
    EXPECT_EQ(entry.check != nullptr,
              has_range || entry.kind == OptionKind::word || entry.name == "window");
  }
  EXPECT_EQ(find_read_option("layers"), nullptr);
}

TEST(ReadOptionTable, WhatIsSetIsToldAndSetAgain) {
  for (const ReadOptionEntry& entry : read_option_table()) {
    SCOPED_TRACE(entry.name);
    ReadOptions options;
    for (const std::string& value : values_read_by(entry)) {
      const Status status = entry.set(entry, value, options);
      ASSERT_TRUE(status) << status.error().message;
    }
    EXPECT_TRUE(check_read_options(options));
    EXPECT_EQ(entry.get(entry, options), entry.name == "window"
                                             ? std::vector<std::string>{"-1,0.5,2,1000"}
                                             : values_read_by(entry));
    for (const ReadOptionEntry& other : read_option_table()) {
      if (&other == &entry) continue;
      EXPECT_EQ(other.get(other, options), other.get(other, ReadOptions())) << other.name;
    }
    const auto told = describe_read_options(options);
    EXPECT_EQ(told.empty(), entry.name == "unit" || entry.name == "scale");
  }
  EXPECT_TRUE(describe_read_options({}).empty());
}

TEST(ReadOptionTable, WhatIsNoValueIsRefused) {
  const auto message = [](const char* name, std::string_view value) {
    const ReadOptionEntry* entry = find_read_option(name);
    ReadOptions options;
    const Status status = entry->set(*entry, value, options);
    EXPECT_FALSE(status) << name << ' ' << value;
    return status ? "" : status.error().message;
  };
  EXPECT_EQ(message("unit", "km"), "'km' is not one of nm, um, mm, cm, m");
  EXPECT_EQ(message("scale", "0"), "0 is not above 0");
  EXPECT_EQ(message("chord-angle", "121"), "121 is not above 0 and at most 120");
  EXPECT_EQ(message("layer", ""), "NAME is needed");
  EXPECT_EQ(message("input-format", "."), "an extension is needed, as gds");
  for (const char* window : {"", "0,0,1", "0,0,1,1,1", "0,0,1,x", "1,0,0,1", "0,0,1,0", "0,0,inf,1",
                             "nan,0,1,1", "0 0 1 1"})
    EXPECT_NE(message("window", window).find("is not x0,y0,x1,y1"), std::string::npos);
  ReadOptions options;
  options.window = Window{{1, 0}, {0, 1}};
  EXPECT_FALSE(check_read_options(options));
  options = {};
  options.scale = -1;
  EXPECT_FALSE(check_read_options(options));
}

}  // namespace
}  // namespace cover
