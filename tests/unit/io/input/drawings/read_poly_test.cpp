#include <gtest/gtest.h>

#include <cover/read_input.hpp>

#include <fmt/core.h>

#include <array>
#include <string>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

using testing::TemporaryFolder;

/// Reads `text` as the file in.poly.
Result<Input> read_poly_files(std::string_view text) {
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
  const auto input = read_poly_files(
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
  EXPECT_TRUE(input->seeds_may_miss);
  EXPECT_EQ(input->void_rule, VoidRule::holes_only);
}

/// An area that stands for no limit is one still as a length.
TEST(ReadPoly, TheLargestAreasAreFiniteSizes) {
  const auto input = read_poly_files("3 2\n1 0 0\n2 1 0\n3 0 1\n0\n0\n1\n1 0.2 0.2 1 1e308\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_NEAR(input->seeds[0].size.value(), 1.52e154, 1e152);
}

TEST(ReadPoly, TheMarkOfUtf8IsPassed) {
  const auto input = read_poly_files(
      "\xef\xbb\xbf"
      "3 2\n1 0 0\n2 1 0\n3 0 1\n0\n0\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->points.size(), 3u);
}

TEST(ReadPoly, NeedsNoMarkersAttributesOrRegions) {
  const auto input = read_poly_files("3\n0 0 0\n1 1 0\n2 0 1\n1\n0 0 2\n0\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->points.size(), 3U);
  EXPECT_TRUE(input->point_markers.empty());
  EXPECT_EQ(input->segments.size(), 1U);
  EXPECT_EQ(input->segments[0].b, 2U);
}

TEST(ReadPoly, TakesCommasBeforeBlanksAsBlanks) {
  const auto input = read_poly_files("3, 2\n0, 0, 0\n1 , 1, 0.5\n2 0, 1\n1\n0 0, 2,\n0\n");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->points, (std::vector<Point>{{0, 0}, {1, 0.5}, {0, 1}}));
  EXPECT_TRUE(input->warnings.empty());
}

TEST(ReadPoly, TellsWhatItLeavesOut) {
  const auto input = read_poly_files("3 2 0 0\n0 0 0 7\n1 1 0\n2 0 1 8 9\n1 1\n0 0 2 5\n0\n");
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
  const auto input = read_poly_files("0 2 0 0\n1 0\n1 2 3\n0\n");
  ASSERT_FALSE(input);
  EXPECT_EQ(input.error().code, ErrorCode::cannot_open);
  EXPECT_NE(input.error().message.find("in.node: No such file or directory"), std::string::npos);
  EXPECT_NE(input.error().message.find("in.poly has no points of its own"), std::string::npos);
}

/// What is wrong, or else what was read.
std::string told_of_poly(std::string_view text, unsigned threads) {
  ReadOptions options;
  options.threads = threads;
  const Result<Input> input = parse_input(text, ".poly", "in.poly", options);
  if (!input) return input.error().message;
  std::string out;
  for (const std::string& warning : input->warnings) out += warning + "\n";
  for (std::size_t v = 0; v < input->points.size(); ++v)
    out += fmt::format("{} {} {} line {} marker {}\n", input->point_ids[v], input->points[v].x,
                       input->points[v].y, input->point_lines[v],
                       input->point_markers.empty() ? -1 : input->point_markers[v]);
  for (const InputSegment& s : input->segments)
    out += fmt::format("{}: {} {} line {} marker {}\n", s.id, s.a, s.b, s.line, s.marker);
  return out + fmt::format("{} holes\n", input->holes.size());
}

/// A megabyte, in which some points and segments are other lines.
std::string large_file(const char* edit_point, const char* edit_segment) {
  constexpr long kPoints = 30'000;
  std::string text = fmt::format("{} 2 1 1\n", kPoints);
  for (long k = 0; k < kPoints; ++k) {
    const bool edited = k % 13'456 == 13'455;
    text += edited
                ? fmt::format(fmt::runtime(edit_point), k + 5)
                : fmt::format("{} {} {} 0.25 {}", k + 5, 0.1 * static_cast<double>(k), -k, k % 3);
    text += k % 1000 == 0 ? "\r\n\n" : "\n";
  }
  text += fmt::format("{} 1\n", kPoints);
  for (long k = 0; k < kPoints; ++k) {
    const bool edited = k % 14'567 == 14'566;
    text += edited ? fmt::format(fmt::runtime(edit_segment), k)
                   : fmt::format("{} {} {} {}", k, k + 5, (k + 1) % kPoints + 5, k % 5);
    text += "\n";
  }
  return text + "0\n";
}

/// The same with a comment behind each line, so that none is plain.
std::string with_comments(std::string text) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string(" #\n") : std::string(1, c);
  return out;
}

TEST(ReadPoly, ReadsTheSameByAnyNumberOfThreads) {
  const std::array<std::array<const char*, 2>, 13> edits{{
      {"{} 3 4 0 7", "{} 5 6 7"},
      {"{}, 3, 4, 0, 7", "{}, 5, 6, 7 # a comment"},
      {"{} +3 4 x 7", "{} 5 6"},
      {"{} 3 4", "{} 5 6"},
      {"{} 3 4 0 7 8", "{} 5 6 7 8"},
      {"# left out\n{} 3 4 0 7", "\n\n{} 5 6 7"},
      {"9{} 3 4 0 7", "9{} 5 6 7"},
      {"{} 3 y 0 7", "{} 5 6 7"},
      {"{} 3 4 0 7", "{} 5 4 7"},
      {"{} 3 inf 0 7", "{} 5 6 7"},
      {"6 3 4 0 7 # {}", "{} 5 6 7"},
      {"{} 3 4 0 99999999999", "{} 5 6 7"},
      {"{} 3 4 0 7", "{0} 5 6 7\n{0} 5 6 7"},
  }};
  for (const auto& [point, segment] : edits) {
    const std::string text = large_file(point, segment);
    const std::string expected = told_of_poly(with_comments(text), 1);
    for (const unsigned threads : {1U, 2U, 3U, 7U})
      EXPECT_TRUE(told_of_poly(text, threads) == expected)
          << point << ", " << segment << ": " << told_of_poly(text, threads).substr(0, 200)
          << "\nnot\n"
          << expected.substr(0, 200);
  }
}

TEST(ReadPoly, EndsLargeFilesWhereTheyAreCutOff) {
  const std::string text = large_file("{} 3 4 0 7", "{} 5 6 7");
  for (const std::size_t length : {text.size() / 4, text.size() / 2, text.size() - 3}) {
    const std::string cut = text.substr(0, length);
    EXPECT_EQ(told_of_poly(cut, 3), told_of_poly(with_comments(cut), 1));
  }
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
  const auto input = read_poly_files(GetParam().text);
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
                "in.poly: nothing is in it: it is empty, or was cut off"},
        Refusal{"nothing_but_blanks", "  \n", ErrorCode::truncated,
                "in.poly:1: the file ends where the number of points should follow"},
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
