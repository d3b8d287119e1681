#include <gtest/gtest.h>

#include <filesystem>

#include <cover/read_input.hpp>

#include <fmt/core.h>

#include <array>
#include <string>

#include "io/input/formats.hpp"
#include "support/cases_folder.hpp"
#include "support/read_result.hpp"

namespace cover {
namespace {

Input read(std::string_view text) { return testing::must_read(parse_json(text, "deck.json")); }

std::string message_of(std::string_view text) {
  return testing::must_refuse(parse_json(text, "deck.json"));
}

TEST(ReadJson, ReadsAPslg) {
  const Input input = read(R"({
    "name": "two", "unit": "um", "points": [[0, 0], [1, 0], [1, 1.5e-3], [0, 1]],
    "segments": [[0, 1], [1, 2], {"points": [2, 3], "name": "gate", "marker": 7}, [3, 0]],
    "holes": [[0.5, 0.25]],
    "regions": [{"x": 0.1, "y": 0.2, "material": "Si", "region": "bulk", "size": 0.5},
                {"x": 0.3, "y": 0.2, "material": 4}]})");
  EXPECT_EQ(input.unit, "um");
  EXPECT_EQ(input.void_rule, VoidRule::unseeded_faces);
  EXPECT_TRUE(input.seeds_may_miss);
  ASSERT_EQ(input.points.size(), 4u);
  EXPECT_EQ(input.points[2], (Point{1, 1.5e-3}));
  ASSERT_EQ(input.segments.size(), 4u);
  EXPECT_EQ(input.segments[2].a, 2u);
  EXPECT_EQ(input.segments[2].name, "gate");
  EXPECT_EQ(input.segments[2].marker, 7);
  EXPECT_EQ(input.segments[3].id, 3);
  ASSERT_EQ(input.holes.size(), 1u);
  ASSERT_EQ(input.seeds.size(), 2u);
  EXPECT_EQ(input.seeds[0].region, "bulk");
  EXPECT_EQ(input.seeds[0].size, 0.5);
  EXPECT_EQ(input.seeds[1].material, "4");
}

TEST(ReadJson, ReadsASoupWithLines) {
  const Input input = read(R"({
    "polygons": [{"material": "Si", "rings": [[[0, 0], [4, 0], [4, 4]], [[1, 0.5], [2, 0.5], [2, 1]]]},
                 {"material": "Ox", "region": "cap", "priority": 2.5, "rings": [[[0, 0], [1, 0], [1, 1]]]}],
    "lines": [{"name": "drain", "points": [[0, 0], [1, 0]]},
              {"points": [[0, 0], [1, 0], [1, 1]], "closed": true}]})");
  ASSERT_EQ(input.polygons.size(), 2u);
  EXPECT_EQ(input.polygons[0].rings.size(), 2u);
  EXPECT_EQ(input.polygons[1].priority, 2.5);
  EXPECT_EQ(input.polygons[1].region, "cap");
  EXPECT_EQ(input.polygons[1].id, 1);
  ASSERT_EQ(input.lines.size(), 2u);
  EXPECT_EQ(input.lines[0].name, "drain");
  EXPECT_EQ(input.lines[1].points.size(), 4u);
}

TEST(ReadJson, CutsCurvesOnceForBothNeighbours) {
  const Input input = read(R"({
    "chord_error": 0.01,
    "polygons": [
      {"material": "air", "rings": [[[-2, -2], [2, -2], [2, 2], [-2, 2]],
                                    [{"circle": {"centre": [0, 0], "radius": 1}}]]},
      {"material": "iron", "rings": [[[0, 0], {"arc": {"centre": [0, 0], "radius": 1, "from": 10, "to": 200}}]]}]})");
  const std::vector<Point>& circle = input.polygons[0].rings[1];
  const std::vector<Point>& sector = input.polygons[1].rings[0];
  EXPECT_EQ(circle.front(), circle.back());
  EXPECT_GT(sector.size(), 10u);
  EXPECT_EQ(sector[0], (Point{0, 0}));
  for (std::size_t k = 1; k < sector.size(); ++k)
    EXPECT_NE(std::find(circle.begin(), circle.end(), sector[k]), circle.end());
}

TEST(ReadJson, AnArcOf360DegreesEndsOnItsFirstPoint) {
  for (const char* ends : {R"("from": 1.3, "to": 361.3)", R"("from": 361.2, "to": 1.2)",
                           R"("from": 359.7, "to": 719.7)"}) {
    const Input input = read(fmt::format(
        R"({{"segments": [{{"arc": {{"centre": [0, 0], "radius": 1, {}, "chords": 24}}}}]}})",
        ends));
    EXPECT_EQ(input.points.size(), 24U) << ends;
    EXPECT_EQ(input.segments.size(), 24U) << ends;
  }
}

TEST(ReadJson, TurnsCurvesIntoSegmentsOfAPslg) {
  const Input input = read(R"({
    "points": [[1, 0], [-1, 0], [0, 3]],
    "segments": [{"points": [0, 1], "arc": {"centre": [0, 0], "chords": 4}, "name": "top"},
                 {"arc": {"centre": [0, 0], "radius": 1, "from": 180, "to": 360, "chords": 4}},
                 {"circle": {"centre": [0, 0], "radius": 3, "chords": 8}}]})");
  EXPECT_EQ(input.segments.size(), 16u);
  EXPECT_EQ(input.points.size(), 3u + 3 + 3 + 7);  // ends and (0, 3) are points of the file
  EXPECT_EQ(input.segments[0].a, 0u);
  EXPECT_EQ(input.segments[3].b, 1u);
  EXPECT_EQ(input.segments[4].a, 1u);
  EXPECT_EQ(input.segments[7].b, 0u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(input.segments[k].name, "top");
}

TEST(ReadJson, TellsOfOneCircleWithTwoNumbersOfChords) {
  const Input same = read(R"({"segments": [
    {"circle": {"centre": [0, 0], "radius": 1, "chords": 12}},
    {"arc": {"centre": [0, 0], "radius": 1, "from": 90, "to": 0, "chords": 3}}]})");
  EXPECT_EQ(same.points.size(), 12u);
  EXPECT_TRUE(same.warnings.empty());
  const Input other = read(R"({"segments": [
    {"circle": {"centre": [0, 0], "radius": 1, "chords": 8}},
    {"circle": {"centre": [0, 0], "radius": 1, "chords": 12}}]})");
  EXPECT_EQ(other.points.size(), 12u);
  ASSERT_EQ(other.warnings.size(), 1u);
  EXPECT_NE(other.warnings[0].find("asks for 8 chords and gets 12"), std::string::npos);
}

TEST(ReadJson, ReadsLayersOfLines) {
  const Input input = read(R"({
    "points": [[0, 0], [1, 0], [1, 1]],
    "segments": [{"points": [0, 1], "name": "gate", "layers": {"first": 0.1, "growth": 1.5}},
                 [1, 2], [2, 0]],
    "lines": [{"name": "anode", "points": [[0, 0], [1, 1]],
               "layers": {"region": "bulk", "first": 0.2, "growth": 1, "count": 3}}],
    "layers": [{"line": "si_sio2", "first": 0.3, "growth": 2, "count": 4}]})");
  ASSERT_EQ(input.layers.size(), 3u);
  EXPECT_EQ(input.layers[0].line, "gate");
  EXPECT_EQ(input.layers[0].growth, 1.5);
  EXPECT_EQ(input.layers[0].count, 0);
  EXPECT_EQ(input.layers[1].line, "anode");
  EXPECT_EQ(input.layers[1].region, "bulk");
  EXPECT_EQ(input.layers[1].count, 3);
  EXPECT_EQ(input.layers[2].line, "si_sio2");
  EXPECT_EQ(input.layers[2].first, 0.3);
}

TEST(ReadJson, RefusesLayersThatAreNone) {
  const auto with = [](const std::string& layers) {
    return message_of(R"({"points": [[0, 0]], "layers": [)" + layers + "]}");
  };
  EXPECT_NE(with(R"({"first": 1, "growth": 1, "count": 1})").find("\"line\" is missing"),
            std::string::npos);
  EXPECT_NE(with(R"({"line": "a", "growth": 1, "count": 1})").find("\"first\" is missing"),
            std::string::npos);
  for (const char* bad : {R"({"line": "a", "first": 0, "growth": 1, "count": 1})",
                          R"({"line": "a", "first": -1, "growth": 1, "count": 1})",
                          R"({"line": "a", "first": 1, "growth": 0.9, "count": 1})",
                          R"({"line": "a", "first": 1, "growth": 1})",
                          R"({"line": "a", "first": 1, "growth": 1, "count": -1})",
                          R"({"line": "a", "first": 1, "growth": 1, "count": 1001})",
                          R"({"line": "a", "first": 1, "growth": 1, "count": 1.5})"}) {
    EXPECT_NE(with(bad).find("layers[0]"), std::string::npos) << bad;
  }
  EXPECT_NE(message_of(R"({"points": [[0, 0], [1, 1]], "segments": [
              {"points": [0, 1], "layers": {"first": 1, "growth": 2}}]})")
                .find("layers need a \"name\""),
            std::string::npos);
}

TEST(ReadJson, NamesThePlaceOfEveryError) {
  EXPECT_EQ(message_of(R"({"points": [], "segments": [], "regoins": []})"),
            "deck.json: regoins: unknown key (did you mean \"regions\"?)");
  EXPECT_EQ(message_of(R"({"polygons": [{"materail": "a", "rings": []}]})"),
            "deck.json: polygons[0].materail: unknown key (did you mean \"material\"?)");
  EXPECT_EQ(message_of(R"({"polygons": [{"name": "a", "rings": []}]})")
                .find("deck.json: polygons[0].name: unknown key (known are \"material\", "),
            0U)
      << message_of(R"({"polygons": [{"name": "a", "rings": []}]})");
  EXPECT_EQ(message_of(R"({"points": [[0, 0], [1, "a"]], "segments": []})"),
            "deck.json: points[1][1]: expected a number, found \"a\"");
  EXPECT_EQ(message_of(R"({"points": [[0, 0], [1]], "segments": []})"),
            "deck.json: points[1]: expected a point [x, y], found 1 number");
  EXPECT_EQ(message_of(R"({"points": [[0, 0], [1, 0]], "segments": [[0, 2]]})"),
            "deck.json: segments[0][1]: there is no point 2: the points are 0 to 1");
  EXPECT_EQ(message_of(R"({"polygons": [{"rings": []}]})"),
            "deck.json: polygons[0]: the key \"material\" is missing");
  EXPECT_EQ(message_of("{}"), "deck.json: found no \"points\", \"segments\" or \"polygons\"");
  EXPECT_EQ(message_of("[]"), "deck.json: expected an object, found an array");
  EXPECT_EQ(message_of(R"({"points": [], "points": []})"),
            "deck.json: the key \"points\" is given twice in one object");
  EXPECT_EQ(message_of(R"({"points": [], "unit": "inch"})"),
            "deck.json: unit: expected a unit of length: nm, um, mm, cm or m");
}

/// What is wrong, or else what was read.
std::string told(std::string_view text, unsigned threads) {
  ReadOptions options;
  options.threads = threads;
  const Result<Input> input = parse_json(text, "deck.json", options);
  if (!input) return input.error().message;
  std::string out;
  for (const Point& p : input->points) out += fmt::format("{} {}\n", p.x, p.y);
  for (const InputSegment& s : input->segments)
    out += fmt::format("{}: {} {} {}\n", s.id, s.a, s.b, s.name);
  return out + fmt::format("{} holes\n", input->holes.size());
}

/// Some megabytes, of which one point and one segment are others, and one segment has a name.
std::string large_file(const char* point, const char* segment, const char* name, long named) {
  constexpr long kPoints = 30'000;
  std::string text = R"({"points": [)";
  for (long k = 0; k < kPoints; ++k) {
    const bool is_other = k == 14'567;
    text += is_other ? std::string(point)
                     : fmt::format("[{}, {}]", 0.1 * static_cast<double>(k), k % 7 == 0 ? 0 : k);
    text += k + 1 < kPoints ? ", " : "";
  }
  text += R"(], "holes": [[0.5, 0.25]], "segments": [)";
  for (long k = 0; k < kPoints; ++k) {
    text += k == 25'678 ? segment : fmt::format("[{},{}]", k, (k + 1) % kPoints);
    if (k == named) text += fmt::format(R"(, {{"points": [3, 4], "name": "{}"}})", name);
    text += k + 1 < kPoints ? ", " : "";
  }
  return text + "]}";
}

/// By a tree of the whole, which a name with an escape asks for.
TEST(ReadJson, ReadsTheSameByAnyNumberOfThreads) {
  const std::array<std::array<const char*, 2>, 8> others{{
      {"[3, 4]", "[5, 6]"},
      {"[3, 4]", R"({"points": [5, 6], "name": "c"})"},
      {"[3, \"4\"]", "[5, 6]"},
      {"[3, 4, 5]", "[5, 6]"},
      {"[3, 4]", "[5, 30000]"},
      {"[3, 4]", "[5, 6.5]"},
      {"[3, 4],", "[5, 6]"},
      {"[3, 4]", "[5, -1]"},
  }};
  for (const auto& [point, segment] : others) {
    for (const long named : {0L, 13'456L, 29'999L}) {
      const std::string expected = told(large_file(point, segment, R"(\u0062)", named), 1);
      const std::string text = large_file(point, segment, "b", named);
      for (const unsigned threads : {1U, 2U, 3U, 7U})
        EXPECT_TRUE(told(text, threads) == expected)
            << point << ", " << segment << ": " << told(text, threads).substr(0, 200) << "\nnot\n"
            << expected.substr(0, 200);
    }
  }
  const std::string text = large_file("[3, 4]", "[5, 6]", "b", 0);
  for (const std::size_t length : {text.size() / 3, text.size() - 1})
    EXPECT_EQ(told(text.substr(0, length), 3), told(text.substr(0, length), 1));
}

TEST(ReadJson, PolygonsHaveSizes) {
  const auto input = parse_json(R"({"polygons": [
    {"material": "a", "size": 0.5, "rings": [[[0, 0], [1, 0], [1, 1]]]},
    {"material": "b", "rings": [[[0, 0], [1, 0], [1, 1]]]}]})",
                                "deck.json");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->polygons[0].size, 0.5);
  EXPECT_FALSE(input->polygons[1].size);
  EXPECT_EQ(message_of(R"({"polygons": [{"material": "a", "size": 0, "rings": []}]})"),
            "deck.json: polygons[0].size: expected a number above zero, found 0");
}

TEST(ReadJson, SaysLineAndColumnOfBrokenSyntax) {
  const std::string text = message_of("{\"points\": [[0, 0],\n  [1, ]]}");
  EXPECT_NE(text.find("line 2, column 7"), std::string::npos) << text;
  EXPECT_NE(message_of("{\"points\": [[1e999, 0]]}").find("number overflow"), std::string::npos);
  message_of("");
  message_of("{\"points\": [[NaN, 0]]}");
}

TEST(ReadJson, RefusesImpossibleCurves) {
  const auto ring = [](const std::string& item) {
    return message_of(R"({"polygons": [{"material": "a", "rings": [[)" + item + "]]}]}");
  };
  EXPECT_EQ(
      ring(R"({"circle": {"centre": [0, 0], "radius": 0, "chords": 8}})"),
      "deck.json: polygons[0].rings[0][0].circle.radius: expected a number above zero, found 0");
  EXPECT_EQ(ring(R"({"circle": {"centre": [0, 0], "radius": 1}})"),
            "deck.json: polygons[0].rings[0][0].circle: give \"chords\" or \"chord_error\" (or "
            "\"chord_error\" for all curves)");
  EXPECT_EQ(
      ring(R"({"arc": {"centre": [0, 0], "radius": 1, "from": 0, "to": 400, "chords": 3}})"),
      "deck.json: polygons[0].rings[0][0].arc: an arc spans more than 0 and at most 360 degrees");
  EXPECT_NE(ring(R"({"circle": {"centre": [0, 0], "radius": 1, "chord_error": 1e-18}})")
                .find("more than 4194304 points"),
            std::string::npos);
  EXPECT_NE(message_of(R"({"points": [[1, 0], [3, 0]], "segments": [{"points": [0, 1],
                        "arc": {"centre": [0, 0], "chords": 3}}]})")
                .find("are not equally far from the centre"),
            std::string::npos);
}

TEST(ReadJson, TellsWhatHelpsAgainstOtherLettersAndLines) {
  EXPECT_NE(message_of("{\"name\": \"Gr\xfcn\"}").find("ill-formed UTF-8 byte"), std::string::npos);
  EXPECT_NE(message_of("{\"name\": \"Gr\xfcn\"}").find("; JSON is in UTF-8: 'iconv -f LATIN1 -t"),
            std::string::npos);
  EXPECT_NE(message_of("{}\n{}\n").find("; one document is read, not one in each line: 'jq -s'"),
            std::string::npos);
}

TEST(ReadJson, TellsOfArcsWhoseEndsAreNotEquallyFarFromTheCentre) {
  const auto warnings = [](const char* end) {
    return parse_json(fmt::format(R"({{"points": [[0.3, 0], [{}]], "segments": [{{"points": [0, 1],
                                   "arc": {{"centre": [0, 0], "chords": 4}}}}, [1, 0]]}})",
                                  end),
                      "deck.json")
        ->warnings;
  };
  EXPECT_EQ(warnings("0, 0.3").size(), 0U);
  EXPECT_EQ(warnings("0.21213203435596426, 0.21213203435596426").size(), 0U);
  EXPECT_EQ(warnings("0, 0.30002"),
            (std::vector<std::string>{"1 arc between two points has ends that are not equally far "
                                      "from the centre, by up to 2e-05: the radius is the mean of "
                                      "both"}));
}

TEST(ReadJson, LimitsTheCurvePointsOfAFileAsAWhole) {
  std::string text = R"({"polygons": [)";
  for (int k = 0; k < 20; ++k)
    text +=
        std::string(k ? "," : "") +
        R"({"material": "a", "rings": [[{"circle": {"centre": [0, 0], "radius": 1, "chords": 400000}}]]})";
  EXPECT_NE(message_of(text + "]}").find("more than 4194304 points"), std::string::npos);
}

TEST(ReadJson, SurvivesDeepNesting) {
  const std::string open(200000, '['), close(200000, ']');
  EXPECT_NE(message_of("{\"points\": [" + open + close + "]}"), "");
  EXPECT_NE(message_of(open), "");
}

TEST(ReadJson, ReadsEveryCaseThatIsThere) {
  const std::filesystem::path folder = cases_folder();
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no folder " << folder;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const Result<Input> input = read_input(entry.path().string());
    ASSERT_TRUE(input.has_value()) << input.error().message;
    EXPECT_TRUE(!input->segments.empty() || !input->polygons.empty()) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace cover
