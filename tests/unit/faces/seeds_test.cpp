// What seeds say of the faces that they lie in.
#include "faces/seeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cover {
namespace {

/// Three squares inside each other: outer ring, ring, core.
class SeedsOfNestedSquares : public ::testing::Test {
 protected:
  SeedsOfNestedSquares() {
    pslg_.source = "nested.poly";
    for (const double low : {0.0, 1.0, 2.0}) {
      const double high = 9 - low;
      const auto first = static_cast<std::uint32_t>(pslg_.points.size());
      pslg_.points.insert(pslg_.points.end(), {{low, low}, {high, low}, {high, high}, {low, high}});
      for (std::uint32_t k = 0; k < 4; ++k)
        pslg_.segments.push_back({VertexId{first + k}, VertexId{first + (k + 1) % 4}});
    }
    std::vector<IndexPair> segments;
    for (const Segment& s : pslg_.segments) segments.push_back({s.a.value(), s.b.value()});
    faces_ = find_faces(pslg_.points, segments, false);
  }

  /// The face on the left of a square's sides.
  [[nodiscard]] std::uint32_t inside(std::size_t square) const {
    return faces_.of_segment[4 * square][0];
  }

  void add_seed(Point at, std::string material, std::string region = "") {
    RegionSeed seed;
    seed.at = at;
    seed.material = std::move(material);
    seed.region = std::move(region);
    seed.id = static_cast<long>(pslg_.seeds.size() + 1);
    pslg_.seeds.push_back(std::move(seed));
  }

  [[nodiscard]] SeededFaces applied() {
    Result<SeededFaces> out = apply_seeds(pslg_, faces_, notes_);
    EXPECT_TRUE(out) << out.error().message;
    return out ? *std::move(out) : SeededFaces{};
  }
  [[nodiscard]] ErrorCode refusal() {
    const Result<SeededFaces> out = apply_seeds(pslg_, faces_, notes_);
    return out ? ErrorCode::internal : out.error().code;
  }

  Pslg pslg_;
  Faces faces_;
  std::vector<Note> notes_;
};

TEST_F(SeedsOfNestedSquares, ASeedSpeaksForItsFaceAlone) {
  add_seed({4, 4}, "7");
  add_seed({0.5, 0.5}, "2");
  const SeededFaces out = applied();
  EXPECT_EQ(out.seed[inside(2)], 0U);
  EXPECT_EQ(out.seed[inside(0)], 1U);
  EXPECT_FALSE(out.seed[inside(1)]);
  EXPECT_TRUE(out.is_void[kOutside]);
  for (const std::size_t square : {0U, 1U, 2U}) EXPECT_FALSE(out.is_void[inside(square)]);
}

TEST_F(SeedsOfNestedSquares, AHoleIsVoidAndWhatItEnclosesIsNot) {
  pslg_.holes = {{{1.5, 1.5}, 1, 0}};
  const SeededFaces out = applied();
  EXPECT_FALSE(out.is_void[inside(0)]);
  EXPECT_TRUE(out.is_void[inside(1)]);
  EXPECT_FALSE(out.is_void[inside(2)]);
}

TEST_F(SeedsOfNestedSquares, AHoleOutsideMakesNothingVoidAndIsTold) {
  pslg_.holes = {{{20, 20}, 3, 12}};
  const SeededFaces out = applied();
  for (const std::size_t square : {0U, 1U, 2U}) EXPECT_FALSE(out.is_void[inside(square)]);
  ASSERT_EQ(notes_.size(), 1U);
  EXPECT_EQ(notes_[0].message,
            "hole seed 3 at (20, 20) (line 12) lies outside of all segments: it makes nothing "
            "void");
}

TEST_F(SeedsOfNestedSquares, FacesWithoutASeedAreVoidByTheOtherRuleOnlyIfThereAreSeeds) {
  pslg_.void_rule = VoidRule::unseeded_faces;
  EXPECT_FALSE(applied().is_void[inside(1)]);
  add_seed({4, 4}, "silicon");
  const SeededFaces out = applied();
  EXPECT_TRUE(out.is_void[inside(0)]);
  EXPECT_TRUE(out.is_void[inside(1)]);
  EXPECT_FALSE(out.is_void[inside(2)]);
}

TEST_F(SeedsOfNestedSquares, TheSmallestWishOfAFaceCounts) {
  for (const double size : {0.5, 0.25, 0.75}) {
    add_seed({3 + size, 4}, "1");
    pslg_.seeds.back().size = size;
  }
  EXPECT_EQ(applied().size[inside(2)], 0.25);
}

TEST_F(SeedsOfNestedSquares, ASeedThatRepeatsAnotherIsTold) {
  add_seed({4, 4}, "1");
  add_seed({5, 5}, "1", "core");
  const SeededFaces out = applied();
  EXPECT_EQ(out.seed[inside(2)], 1U) << "the one that names the region";
  ASSERT_EQ(notes_.size(), 1U);
  EXPECT_EQ(notes_[0].message,
            "region seed 2 '1/core' at (5, 5) repeats region seed 1 '1' at (4, 4)");
}

TEST_F(SeedsOfNestedSquares, SeedsOfOneFaceMustAgree) {
  add_seed({4, 4}, "1", "a");
  add_seed({5, 5}, "1", "b");
  EXPECT_EQ(refusal(), ErrorCode::conflicting_seeds);
  pslg_.seeds[1].region = "a";
  pslg_.seeds[1].material = "2";
  EXPECT_EQ(refusal(), ErrorCode::conflicting_seeds);
  pslg_.seeds[1].at = {1.5, 1.5};
  (void)applied();
}

TEST_F(SeedsOfNestedSquares, ASeedOnASegmentOrItsEndHasNoFace) {
  add_seed({1, 4}, "1");
  EXPECT_EQ(refusal(), ErrorCode::seed_on_segment);
  pslg_.seeds[0].at = {2, 2};
  EXPECT_EQ(refusal(), ErrorCode::seed_on_segment);
  pslg_.seeds.clear();
  pslg_.holes = {{{8, 4}, 2, 0}};
  EXPECT_EQ(refusal(), ErrorCode::seed_on_segment);
}

TEST_F(SeedsOfNestedSquares, ASeedBetweenAnArcAndItsChordIsToldWhatMendsIt) {
  const std::string finer = "finer chords mend that (a smaller --chord-angle";
  pslg_.circles = {{{4.5, 4.5}, std::hypot(2.5, 2.5)}};  // through the corners of the core
  for (std::size_t s = 8; s < 12; ++s) pslg_.segments[s].circle = 1;
  add_seed({4.5, 1.5}, "1", "core");
  EXPECT_EQ(applied().seed[inside(1)], 0U);
  ASSERT_EQ(notes_.size(), 1U);
  EXPECT_NE(notes_[0].message.find("lies between an arc and its chord, and holds for what is "
                                   "beyond the chord; " +
                                   finer),
            std::string::npos)
      << notes_[0].message;

  const auto said = [&] {
    const Result<SeededFaces> out = apply_seeds(pslg_, faces_, notes_);
    return out ? std::string() : out.error().message;
  };
  add_seed({1.2, 1.2}, "1", "ring");
  EXPECT_NE(
      said().find("disagree on its region (the first lies between an arc and its chord: " + finer),
      std::string::npos)
      << said();
  pslg_.seeds[1].at = {4.5, 2};
  EXPECT_NE(said().find("lies on a segment, the chord of an arc: " + finer), std::string::npos);
  pslg_.seeds.resize(1);
  pslg_.holes = {{{1.2, 1.2}, 1, 0}};
  EXPECT_NE(said().find("lies in a hole (it lies between an arc and its chord: " + finer),
            std::string::npos);

  // Not where the circle is another one, or another face is there.
  pslg_.holes.clear();
  notes_.clear();
  pslg_.seeds[0].at = {1.2, 1.2};
  (void)applied();
  pslg_.seeds[0].at = {0.5, 4.5};
  (void)applied();
  EXPECT_TRUE(notes_.empty());
}

TEST_F(SeedsOfNestedSquares, ASeedInTheVoidIsRefused) {
  add_seed({9.5, 4}, "1");
  EXPECT_EQ(refusal(), ErrorCode::seed_in_void);
  pslg_.seeds[0].at = {5, 4};
  pslg_.holes = {{{4, 4}, 1, 0}};
  EXPECT_EQ(refusal(), ErrorCode::seed_in_void);
}

TEST_F(SeedsOfNestedSquares, WhatIsKnownOfSidesComesBeforePlaces) {
  add_seed({40, 40}, "1");  // no face is there
  pslg_.seeds[0].size = 0.5;
  pslg_.side_seeds.assign(pslg_.segments.size(), {0, 0});
  for (std::size_t s = 8; s < 12; ++s) pslg_.side_seeds[s] = {1, 0};
  const SeededFaces out = applied();
  EXPECT_EQ(out.seed[inside(2)], 0U);
  EXPECT_EQ(out.size[inside(2)], 0.5);
  EXPECT_FALSE(out.is_void[inside(2)]);
  EXPECT_TRUE(out.is_void[inside(1)]);
}

}  // namespace
}  // namespace cover
