#include <cover/option_table.hpp>

#include <gtest/gtest.h>

namespace cover {
namespace {

using Settings = std::vector<Provenance::Setting>;

TEST(DescribeOptions, TheMethodAloneByDefault) {
  Options options;
  options.threads = 7;
  options.require.bound = true;
  EXPECT_EQ(describe_options(options), (Settings{{"method", "quality"}}));
}

TEST(DescribeOptions, WhateverDiffersUnderTheNamesOfTheCommandLine) {
  Options options;
  options.method = Method::almond;
  options.paper = true;
  options.max_angle = Angle::degrees(120);
  options.sizes = {{"", 0.5, false}, {"oxide", 2, false}, {"gate", 0.1, true}};
  options.sizes.push_back({"Si", 0, false, "0.1+abs(y)"});
  options.size_of = "asinh";
  options.size_step = 0.5;
  options.min_size = 0.001;
  options.input_sizes = false;
  options.size_field = [](Point) { return 1.0; };
  options.size_field_name = "h.vtu";
  options.weld = 1e-9;
  options.overlap = Overlap::error;
  EXPECT_EQ(describe_options(options), (Settings{{"method", "almond"},
                                                 {"paper", "true"},
                                                 {"max-angle", "120"},
                                                 {"size", "0.5"},
                                                 {"size", "oxide=2"},
                                                 {"size", "Si=0.1+abs(y)"},
                                                 {"size-at", "gate=0.1"},
                                                 {"no-input-sizes", "true"},
                                                 {"size-field", "h.vtu"},
                                                 {"size-of", "asinh"},
                                                 {"size-step", "0.5"},
                                                 {"min-size", "0.001"},
                                                 {"overlap", "error"},
                                                 {"weld", "1e-09"}}));
}

}  // namespace
}  // namespace cover
