#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "io/input/formats.hpp"
#include "support/inputs/soups.hpp"
#include "support/read_result.hpp"

namespace cover {
namespace {

Input read(const std::string& text) { return testing::must_read(parse_sde(text, "a.cmd")); }

std::string refusal(const std::string& text) {
  SCOPED_TRACE(text);
  return testing::must_refuse(parse_sde(text, "a.cmd"));
}

constexpr const char* kBody =
    "(sdegeo:create-rectangle (position 0 0 0) (position 4 2 0) \"Silicon\" \"R.Body\")\n";

TEST(ReadSde, BodiesOfDefinedLengths) {
  const Input input = read(R"(; a comment
(sde:clear)
(define W 2.0) #| another
one |#
(define (twice x) (* 2 x))
(sdegeo:create-rectangle
  (position 0.0 0.0 0.0)
  (position (+ W 1 (- 1)) (/ (twice W) 4) 0.0)
  "Silicon" "R.Body")
(let* ((a 1) (b (+ a 1)))
  (if (> b a) (sdegeo:create-polygon (list (position 0 1 0) (position a 1 0) (position 0 b 0) (position 0 1 0))
    (string-append "Si" "O2") "R.Ox")
    (no-such-command)))
(sdegeo:create-circle (position 5 5 0) (max 0.5 0.25) "Cu" "R.Wire")
)");
  EXPECT_TRUE(input.warnings.empty()) << input.warnings[0];
  EXPECT_EQ(input.unit, "um");
  ASSERT_EQ(input.polygons.size(), 3U);
  EXPECT_EQ(input.polygons[0].material, "Silicon");
  EXPECT_EQ(input.polygons[0].region, "R.Body");
  EXPECT_EQ(input.polygons[0].rings[0], (std::vector<Point>{{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  EXPECT_EQ(input.polygons[1].material, "SiO2");
  EXPECT_EQ(input.polygons[1].rings[0], (std::vector<Point>{{0, 1}, {1, 1}, {0, 2}}));
  EXPECT_EQ(input.polygons[2].rings[0].size(), 72U);
}

TEST(ReadSde, CirclesAreArcsOfChordsAsOptionsSay) {
  const std::string text = R"(
(sdegeo:create-rectangle (position 0 0 0) (position 4 4 0) "Silicon" "R.Body")
(define wire (sdegeo:create-circle (position 1 1 0) 0.5 "Cu" "R.Wire"))
(sdegeo:create-circle (position 3 3 0) 0.5 "Cu" "R.Other")
(sdegeo:define-2d-contact wire "pin")
)";
  ReadOptions options;
  options.chord_angle = 10;
  const Input input = testing::must_read(parse_sde(text, "a.cmd", options));
  ASSERT_EQ(input.polygons.size(), 3U);
  EXPECT_TRUE(input.polygons[0].circles.empty());
  EXPECT_EQ(input.polygons[1].rings[0].size(), 36U);
  using Circles = std::vector<std::vector<std::uint32_t>>;
  EXPECT_EQ(input.polygons[1].circles, Circles{std::vector<std::uint32_t>(36, 1)});
  EXPECT_EQ(input.polygons[2].circles, Circles{std::vector<std::uint32_t>(36, 2)});
  EXPECT_EQ(input.circles, (std::vector<ArcCircle>{{{1, 1}, 0.5}, {{3, 3}, 0.5}}));
  ASSERT_EQ(input.lines.size(), 1U);
  EXPECT_EQ(input.lines[0].points.size(), 37U);
  EXPECT_EQ(input.lines[0].circles.front(), 1U);
  EXPECT_EQ(input.lines[0].circles.back(), 0U);
  options.chord_error = 0.5 * (1 - std::cos(0.05));  // half of a chord of 5.7 degrees
  const Input fine = testing::must_read(parse_sde(text, "a.cmd", options));
  EXPECT_EQ(fine.polygons[1].rings[0].size(), 63U);
  options.chord_error = 1e-15;
  EXPECT_NE(testing::must_refuse(parse_sde(text, "a.cmd", options)).find("chords"),
            std::string::npos);
}

TEST(ReadSde, AChordWithACornerIsOneOfNoCircle) {
  constexpr double kStep = std::numbers::pi / 36;
  const Point middle{1 + 0.25 * (1 + std::cos(kStep)), 1 + 0.25 * std::sin(kStep)};
  const std::string text = fmt::format(R"(
(define wire (sdegeo:create-circle (position 1 1 0) 0.5 "Cu" "R.Wire"))
(sdegeo:define-2d-contact wire "pin")
(sdegeo:insert-vertex (position {:.17g} {:.17g} 0)))",
                                       middle.x, middle.y);
  const Input input = testing::must_read(parse_sde(text, "a.cmd"));
  EXPECT_TRUE(input.changes.empty());
  ASSERT_EQ(input.polygons.size(), 1U);
  const std::vector<std::uint32_t>& circles = input.polygons[0].circles[0];
  EXPECT_EQ(input.polygons[0].rings[0].size(), 73U);
  ASSERT_EQ(circles.size(), 73U);
  EXPECT_EQ(std::count(circles.begin(), circles.end(), 0U), 2);
  ASSERT_EQ(input.lines.size(), 1U);
  EXPECT_EQ(input.lines[0].points.size(), input.lines[0].circles.size());
}

TEST(ReadSde, BooleansSayWhoWins) {
  const Input input = read(std::string(kBody) + R"(
(sdegeo:create-rectangle (position 1 1 0) (position 2 3 0) "Oxide" "over")
(sdegeo:set-default-boolean "BAB")
(sdegeo:create-rectangle (position 3 1 0) (position 5 3 0) "Nitride" "under")
(sdegeo:set-default-boolean "ABA")
(sdegeo:create-rectangle (position 3 0 0) (position 4 0.5 0) "Metal" "last"))");
  const auto cleaned = testing::clean(input);
  ASSERT_TRUE(cleaned) << cleaned.error().message;
  EXPECT_DOUBLE_EQ(cleaned->area("Silicon"), 8 - 1 - 0.5);
  EXPECT_DOUBLE_EQ(cleaned->area("Oxide"), 2);
  EXPECT_DOUBLE_EQ(cleaned->area("Nitride"), 4 - 1);
  EXPECT_DOUBLE_EQ(cleaned->area("Metal"), 0.5);
}

TEST(ReadSde, ContactsEndAtCornersAndCrossings) {
  const Input input = read(std::string(kBody) + R"(
(sdegeo:create-rectangle (position 1 2 0) (position 3 2.5 0) "Oxide" "R.Ox")
(sdegeo:create-rectangle (position 3.5 -1 0) (position 3.75 0.5 0) "Metal" "R.Via")
(sdegeo:insert-vertex (position 0 0.5 0))
(sdegeo:define-contact-set "source" 4 (color:rgb 1 0 0) "##")
(sdegeo:set-current-contact-set "source")
(sdegeo:set-contact-edges (find-edge-id (position 0.5 2 0)))
(sdegeo:define-2d-contact (find-edge-id (position 2 2.5 0)) "gate")
(sdegeo:define-2d-contact (list (car (find-edge-id (position 1 0 0)))) "bulk")
(sdegeo:define-2d-contact (find-edge-id (position 0 1 0)) "side")
(sdegeo:define-2d-contact (find-edge-id (position 2 1 0)) "nowhere")
(sdegeo:set-contact (find-region-id "R.Via") "via"))");
  ASSERT_EQ(input.lines.size(), 5U);
  const auto points = [&](const std::string& name) {
    for (const InputLine& line : input.lines)
      if (line.name == name) return line.points;
    return std::vector<Point>();
  };
  using Points = std::vector<Point>;
  EXPECT_EQ(points("source"), (Points{{1, 2}, {0, 2}}));  // to the corner of the oxide
  EXPECT_EQ(points("gate"), (Points{{3, 2.5}, {1, 2.5}}));
  EXPECT_EQ(points("bulk"), (Points{{0, 0}, {3.5, 0}}));  // to the crossing with the via
  EXPECT_EQ(points("side"), (Points{{0, 2}, {0, 0.5}}));
  EXPECT_EQ(points("via").size(), 5U);
  EXPECT_TRUE(input.warnings.empty()) << input.warnings[0];
  ASSERT_EQ(input.changes.size(), 1U);
  EXPECT_EQ(input.changes[0].message, "a.cmd:12: contact 'nowhere': no edge at (2, 1): left out");
  EXPECT_EQ(input.changes[0].where, (Points{{2, 1}}));
}

TEST(ReadSde, VerticesAreCornersOfAllBodiesThere) {
  const Input input = read(std::string(kBody) + R"(
(sdegeo:create-rectangle (position 0 2 0) (position 4 3 0) "Oxide" "R.Ox")
(sdegeo:insert-vertex (position 1 2 0))
(sdegeo:insert-vertex (position 1 2 0))
(sdegeo:insert-vertex (position 0 1 0))
(sdegeo:insert-vertex (position 4 3 0))
(sdegeo:insert-vertex (position 1 1 0))
(sdegeo:set-contact (find-region-id "R.Ox") "all"))");
  using Points = std::vector<Point>;
  ASSERT_EQ(input.polygons.size(), 2U);
  EXPECT_EQ(input.polygons[0].rings[0], (Points{{0, 0}, {4, 0}, {4, 2}, {1, 2}, {0, 2}, {0, 1}}));
  EXPECT_EQ(input.polygons[1].rings[0], (Points{{0, 2}, {1, 2}, {4, 2}, {4, 3}, {0, 3}}));
  ASSERT_EQ(input.lines.size(), 1U);
  EXPECT_EQ(input.lines[0].points, (Points{{0, 2}, {1, 2}, {4, 2}, {4, 3}, {0, 3}, {0, 2}}));
  ASSERT_EQ(input.changes.size(), 1U);
  EXPECT_EQ(input.changes[0].message, "a.cmd:8: vertex: no edge at (1, 1): left out");
  const auto cleaned = testing::clean(input);
  ASSERT_TRUE(cleaned) << cleaned.error().message;
  EXPECT_EQ(cleaned->pslg.points.size(), 8U);
}

TEST(ReadSde, WhatIsNotUnderstoodIsNamed) {
  const Input input = read(std::string("#if @x@ == 1\n#endif\n#set x 1\n#set y 2\n") + kBody + R"(
(sdegeo:create-rectangle (position 0 0 0) (position Width 2 0) "Silicon" "R")
(sdegeo:fillet-2d (find-vertex-id (position 0 0 0)) 0.5)
(sdegeo:fillet-2d (find-vertex-id (position 4 0 0)) 0.5)
(sdegeo:create-cuboid (position 0 0 0) (position 1 1 1) "Silicon" "box")
(sdegeo:set-default-boolean "XX")
(sdedr:define-constant-profile "p" "Boron" 1e17)
(sdedr:define-constant-profile "q" "Boron" 1e17)
(sde:build-mesh "snmesh" "" "a")
(sdeio:read-tdr-bnd "b.tdr"))");
  EXPECT_EQ(input.polygons.size(), 1U);
  ASSERT_EQ(input.changes.size(), 1U);
  EXPECT_EQ(input.changes[0].kind, Change::Kind::dropped);
  EXPECT_EQ(input.changes[0].message,
            "not understood and left out: Width (line 7), a line of the preprocessor (line 3, 2 "
            "times), all between a condition of the preprocessor and its #endif (line 1), "
            "sdegeo:create-cuboid (line 10), sdegeo:create-rectangle (line 7), sdegeo:fillet-2d "
            "(line 8, 2 times), sdegeo:set-default-boolean \"XX\" (line 11), "
            "sdeio:read-tdr-bnd (line 15)");
  ASSERT_EQ(input.warnings.size(), 1U);
  EXPECT_EQ(input.warnings[0],
            "commands of doping and meshing are left out: sde (line 14), sdedr (line 12, 2 times)");
}

std::string pillar(const char* name) {
  return std::string("(sdegeo:create-rectangle (position 0 2 0) (position 1 2.5 0) \"W\" \"") +
         name + "\")";
}

/// The names of all regions but the body, one after the other.
std::string built(const std::string& text, std::string* change = nullptr) {
  const Input input = read(kBody + text);
  std::string names;
  for (std::size_t k = 1; k < input.polygons.size(); ++k) names += input.polygons[k].region;
  if (change != nullptr) *change = input.changes.empty() ? "" : input.changes[0].message;
  return names;
}

TEST(ReadSde, ConditionsOfTextsAndNumbers) {
  const std::string a = pillar("a"), b = pillar("b");
  std::string change;
  const auto branch = [&](const std::string& test) {
    return built("(define mode \"fin\")(define n 3)(if " + test + " " + a + " " + b + ")", &change);
  };
  for (const char* test : {"(equal? mode \"fin\")", "(string=? mode \"fin\")", "(eq? n 3)",
                           "(odd? n)", "(not (even? n))", "(and (positive? n) (not (zero? n)))",
                           "(equal? (list 1 mode) (list 1 \"fin\"))"}) {
    EXPECT_EQ(branch(test), "a") << test;
    EXPECT_EQ(branch("(not " + std::string(test) + ")"), "b") << test;
    EXPECT_EQ(change, "") << test;
  }
}

/// Neither branch is built: which one is meant, nobody knows.
TEST(ReadSde, WhatHangsOnUnknownConditionsIsLeftOut) {
  const std::string a = pillar("a"), b = pillar("b");
  std::string change;
  for (const std::string& text :
       {"(if (of-old? 1) " + a + " " + b + ")", "(if (not (of-old? 1)) " + a + " " + b + ")",
        "(cond ((of-old? 1) " + a + ") (else " + b + "))", "(when (of-old? 1) " + a + ")",
        "(unless (and #t (of-old? 1)) " + a + ")",
        "(if (equal? (of-old? 1) 1) " + a + " " + b + ")"}) {
    EXPECT_EQ(built(text, &change), "") << text;
    EXPECT_EQ(change, "not understood and left out: of-old? (line 2)") << text;
  }
  EXPECT_EQ(built("(if (begin) " + a + ")", &change), "");
  EXPECT_EQ(change, "not understood and left out: a condition (line 2)");
}

TEST(ReadSde, ConditionsOfThePreprocessor) {
  const std::string a = pillar("a") + "\n", b = pillar("b") + "\n", c = pillar("c") + "\n";
  std::string change;
  EXPECT_EQ(built("#if 0\n" + a + "#else\n" + b + "#endif\n" + c, &change), "bc");
  EXPECT_EQ(change, "");
  EXPECT_EQ(built("#if 1\n" + a + "  #if 0\n" + b + "#endif\n#else\n(\n#endif\n" + c), "ac");
  EXPECT_EQ(built("#if 1 ; as it was\n" + a + "#endif\n#if 0 // off\n" + b + "#endif\n", &change),
            "a");
  EXPECT_EQ(change, "");
  EXPECT_EQ(built("#if 1/x\n" + a + "#endif\n" + b), "b");
  EXPECT_EQ(built("#if 0\n" + a + "#elif 1\n" + b + "#else\n" + c + "#endif\n"), "b");
  EXPECT_EQ(built("#if @type@ == 1\n" + a + "#else\n" + b + "#endif\n" + c, &change), "c");
  EXPECT_EQ(change,
            "not understood and left out: all between a condition of the preprocessor and its "
            "#endif (line 2)");
  EXPECT_EQ(refusal(std::string(kBody) + "#if 0\n" + a),
            "a.cmd:2: this condition of the preprocessor has no #endif");
}

TEST(ReadSde, LoopsByLetWithAName) {
  const std::string step = pillar("p");
  EXPECT_EQ(built("(let loop ((i 0)) (if (< i 200) (begin " + step + " (loop (+ i 1)))))").size(),
            200U);
  EXPECT_EQ(built("(let out ((i 0)) (cond ((< i 3) (let in ((j 0)) (if (< j i) (begin " + step +
                  " (in (+ j 1))) (out (+ i 1)))))))"),
            "ppp");
  // A loop among the arguments of the call that goes on.
  EXPECT_EQ(built("(let loop ((i 0)) (if (< i 3) (begin " + step +
                  " (loop (let in ((j i)) (if (< j (+ i 1)) (in (+ j 1)) j))))))"),
            "ppp");
  EXPECT_EQ(built("(define (next i) (let in ((j i)) (if (< j (+ i 1)) (in (+ j 1)) j)))\n"
                  "(let loop ((i 0)) (if (< i 3) (begin " +
                  step + " (loop (next i)))))"),
            "ppp");
  std::string change;
  EXPECT_EQ(built("(let loop ((i 0)) (if (< i 3) (begin (loop (+ i 1)) " + step + ")))", &change),
            "p");  // no loop of this kind: the call is not its last
  EXPECT_EQ(change, "not understood and left out: loop (line 2)");
  EXPECT_EQ(built("(define x)", &change), "");
  EXPECT_EQ(change, "not understood and left out: define (line 2)");
  EXPECT_NE(refusal("(let loop () (loop))").find("too many steps"), std::string::npos);
}

TEST(ReadSde, Mistakes) {
  EXPECT_EQ(refusal("(define x 1"), "a.cmd:1: this parenthesis is not closed");
  EXPECT_EQ(refusal("\n)"), "a.cmd:2: this parenthesis closes nothing");
  EXPECT_EQ(refusal("\n\"abc"), "a.cmd:2: this text has no end");
  EXPECT_EQ(refusal("#| abc"), "a.cmd:1: this comment has no end");
  EXPECT_EQ(refusal("(foo)"),
            "a.cmd: no sdegeo:create-rectangle, -polygon or -circle that is understood; not "
            "understood: foo (line 1)");
  EXPECT_EQ(refusal("#if @x@ == 1\n" + std::string(kBody) + "#endif\n#set y 1\n"),
            "a.cmd: no sdegeo:create-rectangle, -polygon or -circle that is understood; not "
            "understood: a line of the preprocessor (line 4), all between a condition of the "
            "preprocessor and its #endif (line 1)");
  EXPECT_EQ(
      refusal("(sdegeo:create-rectangle (position 0 0 0) (position (/ 1 0) 2 0) \"a\" \"b\")"),
      "a.cmd:1: a coordinate is not finite");
}

/// Programs that would run for ever, or write books, end soon.
TEST(ReadSde, HostilePrograms) {
  EXPECT_NE(refusal(std::string(100000, '(')).find("too many lists one in the other"),
            std::string::npos);
  EXPECT_NE(refusal("(define (f x) (f x))\n(f 1)").find("a.cmd:1: too many calls one in the other"),
            std::string::npos);
  EXPECT_NE(refusal("(define (f n) (if (> n 0) (begin (f (- n 1)) (f (- n 1))) 0))\n(f 40)")
                .find("too many"),
            std::string::npos);
  std::string doubling = "(define a \"xxxxxxxxxxxxxxxx\")\n", lists = "(define a (list 1 2 3 4))\n";
  for (int k = 0; k < 60; ++k) {
    doubling += "(define a (string-append a a))\n";
    lists += "(define a (list a a))\n";
  }
  EXPECT_NE(refusal(doubling).find("this puts too long a text together"), std::string::npos);
  EXPECT_NE(refusal(lists).find("this makes too long a list"), std::string::npos);
}

}  // namespace
}  // namespace cover
