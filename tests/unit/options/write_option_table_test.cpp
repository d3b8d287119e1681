#include <cover/write_option_table.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <cover/read_option_table.hpp>

namespace cover {
namespace {

std::string value_of(const WriteOptionEntry& entry) {
  if (!entry.words().empty()) return std::string(entry.words().back());
  return entry.kind == OptionKind::flag ? "true" : "2";
}

TEST(WriteOptionTable, EveryRowIsWholeAndFoundAndNamedLikeNoOtherOption) {
  std::set<std::string_view> names;
  for (const WriteOptionEntry& entry : write_option_table()) {
    SCOPED_TRACE(entry.name);
    EXPECT_TRUE(names.insert(entry.name).second);
    EXPECT_EQ(find_option(entry.name), nullptr);
    EXPECT_EQ(find_read_option(entry.name), nullptr);
    std::string in_python(entry.name);
    std::replace(in_python.begin(), in_python.end(), '-', '_');
    EXPECT_EQ(find_write_option(in_python), &entry);
    EXPECT_FALSE(entry.help.empty());
    EXPECT_EQ(entry.placeholder.empty(), entry.kind == OptionKind::flag);
    EXPECT_EQ(entry.check == nullptr, entry.kind == OptionKind::flag);
  }
  EXPECT_EQ(find_write_option("stop"), nullptr);
}

TEST(WriteOptionTable, WhatIsSetIsToldAndChangesNothingElse) {
  for (const WriteOptionEntry& entry : write_option_table()) {
    SCOPED_TRACE(entry.name);
    WriteOptions options;
    const Status status = entry.set(entry, value_of(entry), options);
    ASSERT_TRUE(status) << status.error().message;
    EXPECT_TRUE(check_write_options(options));
    EXPECT_EQ(entry.get(entry, options), std::vector{value_of(entry)});
    for (const WriteOptionEntry& other : write_option_table()) {
      if (&other == &entry) continue;
      EXPECT_EQ(other.get(other, options), other.get(other, WriteOptions())) << other.name;
    }
  }
}

TEST(WriteOptionTable, WholeExtensionsCount) {
  const WriteOptionEntry& order = *find_write_option("order");
  for (const char* extension : {".vtu", ".vtk", ".vtkhdf", ".json", ".svg", ".png", ".html"})
    EXPECT_TRUE(counts_with(order, extension)) << extension;
  for (const char* extension : {".poly", ".obj", ".vt", ".vtkh", ".m", ".htm"})
    EXPECT_FALSE(counts_with(order, extension)) << extension;
  EXPECT_FALSE(counts_with(*find_write_option("lines"), ".vtkhdf"));
  EXPECT_TRUE(counts_with(*find_write_option("parts"), ".anything"));
}

TEST(WriteOptionTable, WhatIsNoValueIsRefused) {
  const auto message = [](const char* name, std::string_view value) {
    const WriteOptionEntry* entry = find_write_option(name);
    WriteOptions options;
    const Status status = entry->set(*entry, value, options);
    EXPECT_FALSE(status) << name << ' ' << value;
    return status ? "" : status.error().message;
  };
  EXPECT_EQ(message("order", "3"), "3 is not at least 1 and at most 2");
  EXPECT_EQ(message("order", "1.5"), "1.5 is not a whole number");
  EXPECT_EQ(message("parts", "0"), "0 is not at least 1 and at most 100000");
  EXPECT_EQ(message("msh", "9"), "'9' is not one of 2.2, 4.1");
  EXPECT_EQ(message("ids", "colour"), "'colour' is not one of region, material, name");
}

TEST(WriteOptionTable, AProgramsValuesAreChecked) {
  const auto refused = [](const WriteOptions& options) {
    const Status status = check_write_options(options);
    return status ? "" : status.error().message;
  };
  EXPECT_EQ(refused({}), "");
  EXPECT_EQ(refused({.order = 3}), "order is 3, but must be at least 1 and at most 2");
  EXPECT_EQ(refused({.msh = ""}), "msh is '', which is not one of 2.2, 4.1");
  EXPECT_EQ(refused({.inp_element = "C3D"}),
            "inp_element is 'C3D', which is not one of S, CPS, CPE, CAX");
}

}  // namespace
}  // namespace cover
