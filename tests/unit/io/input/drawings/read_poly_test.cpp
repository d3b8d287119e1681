#include <gtest/gtest.h>

#include <cover/read_input.hpp>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

using testing::TemporaryFolder;

/// Reads `text` as the file in.poly.
Result<Input> read(std::string_view text) {
  const TemporaryFolder folder;
  return read_input(folder.write("in.poly", text));
}

struct Refusal {
  const char* what;
  const char* text;
  ErrorCode code;
  const char* message;  ///< how it must end, from "in.poly" on
};

void PrintTo(const Refusal& r, std::ostream* out) { *out << r.what; }

TEST(ReadPoly, ReadsEverySection) {
  const auto input = read(
      "# a square with a hole\n"
      "4 2 1 1   # points\n"
      "10  0 0  0.5  3\n"
      "20  1 0  0.5  4\n"
      "\n"
      "30  1 1  0.5  5\n"
      "-4  0 1e0 0.5 -6\n"
      "4 1\n"
      "1 10 20 7\n"
      "2 20 30 7\n"
      "3 30 -4 8\n"
      "4 -4 10 -9\n"
      "1\n"
      "1 0.25 0.5\n"
      "2\n"
      "1 0.75 0.5 12 -1\n"
      "2 0.8 0.5 2.5 0.4330127018922193  # the area of a triangle with edges of length 1\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->points, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(input->point_ids, (std::vector<long>{10, 20, 30, -4}));
  EXPECT_EQ(input->point_lines, (std::vector<int>{3, 4, 6, 7}));
  EXPECT_EQ(input->point_markers, (std::vector<int>{3, 4, 5, -6}));
  ASSERT_EQ(input->segments.size(), 4U);
  EXPECT_EQ(input->segments[3].a, 3U);
  EXPECT_EQ(input->segments[3].b, 0U);
  EXPECT_EQ(input->segments[3].marker, -9);
  EXPECT_EQ(input->segments[3].id, 4);
  EXPECT_EQ(input->segments[3].line, 12);
  ASSERT_EQ(input->holes.size(), 1U);
  EXPECT_EQ(input->holes[0].at, (Point{0.25, 0.5}));
  ASSERT_EQ(input->seeds.size(), 2U);
  EXPECT_EQ(input->seeds[0].material, "12");
  EXPECT_FALSE(input->seeds[0].size);
  EXPECT_EQ(input->seeds[1].material, "2.5");
  EXPECT_NEAR(input->seeds[1].size.value(), 1, 1e-15);
  EXPECT_EQ(input->void_rule, VoidRule::holes_only);
}

TEST(ReadPoly, NeedsNoMarkersAttributesOrRegions) {
  const auto input = read("3\n0 0 0\n1 1 0\n2 0 1\n1\n0 0 2\n0\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->points.size(), 3U);
  EXPECT_TRUE(input->point_markers.empty());
  EXPECT_EQ(input->segments.size(), 1U);
  EXPECT_EQ(input->segments[0].b, 2U);
}

TEST(ReadPoly, TakesCommasBeforeBlanksAsBlanks) {
  const auto input = read("3, 2\n0, 0, 0\n1 , 1, 0.5\n2 0, 1\n1\n0 0, 2,\n0\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->points, (std::vector<Point>{{0, 0}, {1, 0.5}, {0, 1}}));
  EXPECT_TRUE(input->warnings.empty());
}

TEST(ReadPoly, TellsWhatItLeavesOut) {
  const auto input = read("3 2 0 0\n0 0 0 7\n1 1 0\n2 0 1 8 9\n1 1\n0 0 2 5\n0\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->segments[0].marker, 5);
  ASSERT_EQ(input->warnings.size(), 1U);
  EXPECT_TRUE(input->warnings[0].ends_with(
      "in.poly:2: '7' and what follows is left out: the file announces 3 fields for a point; 1 "
      "more line has too many"))
      << input->warnings[0];
}

TEST(ReadPoly, TakesPointsFromTheNodeFile) {
  const TemporaryFolder folder;
  (void)folder.write("in.node", "3 2 0 1\n1 0 0 1\n2 1 0 1\n3 0 1 0\n# made by hand\n");
  const auto input = read_input(folder.write("in.poly", "0 2 0 1\n1 0\n1 2 3\n0\n"));
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->points.size(), 3U);
  EXPECT_EQ(input->point_markers, (std::vector<int>{1, 1, 0}));
  EXPECT_EQ(input->segments[0].a, 1U);
}

TEST(ReadPoly, NamesTheNodeFileThatIsMissing) {
  const auto input = read("0 2 0 0\n1 0\n1 2 3\n0\n");
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().code, ErrorCode::cannot_open);
  EXPECT_NE(input.error().message.find("in.node: No such file or directory"), std::string::npos);
  EXPECT_NE(input.error().message.find("in.poly has no points of its own"), std::string::npos);
}

TEST(ReadInput, NamesTheFormatsItKnows) {
  const TemporaryFolder folder;
  const auto input = read_input(folder.write("in.xyz", ""));
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().code, ErrorCode::unsupported_format);
  EXPECT_NE(input.error().message.find("'*.xyz'"), std::string::npos);
}

class ReadPolyRefuses : public ::testing::TestWithParam<Refusal> {};

TEST_P(ReadPolyRefuses, WithFileAndLine) {
  const auto input = read(GetParam().text);
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().code, GetParam().code);
  const std::string& message = input.error().message;
  const std::size_t name = message.find("in.poly");
  ASSERT_NE(name, std::string::npos) << message;
  EXPECT_EQ(message.substr(name), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Files, ReadPolyRefuses,
    ::testing::Values(
        Refusal{"empty", "", ErrorCode::truncated,
                "in.poly: the file ends where the number of points should follow"},
        Refusal{"points_missing", "3 2 0 0\n1 0 0\n2 1 0\n", ErrorCode::truncated,
                "in.poly:3: the file ends where point 3 of 3 should follow; are the counts right? "
                "points: 3 (line 1)"},
        Refusal{
            "segments_missing", "2\n1 0 0\n2 1 0\n2 0\n1 1 2\n", ErrorCode::truncated,
            "in.poly:5: the file ends where segment 2 of 2 should follow; are the counts right? "
            "points: 2 (line 1), segments: 2 (line 4)"},
        Refusal{"holes_missing", "2\n1 0 0\n2 1 0\n1 0\n1 1 2\n", ErrorCode::truncated,
                "in.poly:5: the file ends where the number of holes should follow; are the counts "
                "right? "
                "points: 2 (line 1), segments: 1 (line 4)"},
        Refusal{"region_missing", "2\n1 0 0\n2 1 0\n1 0\n1 1 2\n0\n1\n", ErrorCode::truncated,
                "in.poly:7: the file ends where region 1 of 1 should follow; are the counts right? "
                "points: 2 (line 1), segments: 1 (line 4), holes: 0 (line 6), regions: 1 (line 7)"},
        Refusal{"coordinate_cut_off", "2\n1 0 0\n2 1\n", ErrorCode::syntax,
                "in.poly:3: point 2: the y coordinate is missing; are the counts right? points: 2 "
                "(line 1)"},
        Refusal{"coordinate_no_number", "1\n1 0 zero\n", ErrorCode::syntax,
                "in.poly:2: point 1: the y coordinate 'zero' is no number"},
        Refusal{"coordinate_nan", "1\n1 nan 0\n", ErrorCode::non_finite_coordinate,
                "in.poly:2: point 1: the x coordinate 'nan' is not finite"},
        Refusal{"coordinate_overflow", "1\n1 0 1e999\n", ErrorCode::non_finite_coordinate,
                "in.poly:2: point 1: the y coordinate '1e999' is not finite"},
        Refusal{"seed_infinite", "2\n1 0 0\n2 1 0\n1 0\n1 1 2\n1\n5 inf 0\n",
                ErrorCode::non_finite_coordinate,
                "in.poly:7: hole 5: the x coordinate 'inf' is not finite"},
        Refusal{"point_twice", "2\n1 0 0\n1 1 0\n", ErrorCode::syntax,
                "in.poly:3: there is already a point 1 (line 2)"},
        Refusal{"id_out_of_range", "2\n1 0 0\n2 1 0\n1 0\n8 1 3\n0\n", ErrorCode::id_out_of_range,
                "in.poly:5: segment 8: there is no point 3; the points are 1 to 2"},
        Refusal{"another_format", "<html><body>not found, please try again later</body></html>\n",
                ErrorCode::syntax,
                "in.poly:1: the number of points: '<html><body>not' is no integer; is this a .poly "
                "or .node file?"},
        Refusal{"no_text", "\001\177xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\n",
                ErrorCode::syntax,
                "in.poly:1: the number of points: '??xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...' is "
                "no integer; is this a .poly or .node file?"},
        Refusal{"dimension", "1 3\n1 0 0 0\n", ErrorCode::syntax,
                "in.poly:1: the dimension is '3', it must be 2"},
        Refusal{"negative_count", "-1 2\n", ErrorCode::syntax,
                "in.poly:1: the number of points is negative"},
        Refusal{"decimal_comma", "1\n1 0,5 0,5\n", ErrorCode::syntax,
                "in.poly:2: point 1: the x coordinate '0,5' is no number (decimals have a point; "
                "between numbers stand blanks)"},
        Refusal{"decimal_comma_in_an_area", "2\n1 0 0\n2 1 0\n1 0\n1 1 2\n0\n1\n1 0 0 1 0,1\n",
                ErrorCode::syntax,
                "in.poly:8: region 1: the largest area '0,1' is no number (decimals have a point; "
                "between numbers stand blanks)"},
        Refusal{"negative_regions", "2\n1 0 0\n2 1 0\n1 0\n1 1 2\n0\n-3\n", ErrorCode::syntax,
                "in.poly:7: the number of regions is negative"},
        Refusal{"marker", "2\n1 0 0\n2 1 0\n1 1\n1 1 2 x\n0\n", ErrorCode::syntax,
                "in.poly:5: segment 1: the boundary marker: 'x' is no integer"},
        Refusal{"marker_too_large", "2\n1 0 0\n2 1 0\n1 1\n1 1 2 3000000000\n0\n",
                ErrorCode::syntax,
                "in.poly:5: segment 1: the boundary marker 3000000000 is too large"},
        Refusal{"attribute", "2\n1 0 0\n2 1 0\n1 0\n1 1 2\n0\n1\n1 0 0 Si\n", ErrorCode::syntax,
                "in.poly:8: region 1: the attribute 'Si' is no number"},
        Refusal{
            "too_many_lines", "2\n1 0 0\n2 1 0\n1 0\n1 1 2\n0\n0\n2 2 1\n", ErrorCode::syntax,
            "in.poly:8: there are more lines than the counts announce; are the counts right? "
            "points: 2 (line 1), segments: 1 (line 4), holes: 0 (line 6), regions: 0 (line 7)"}),
    [](const auto& test) { return std::string(test.param.what); });

}  // namespace
}  // namespace cover
