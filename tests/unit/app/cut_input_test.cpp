// Cuts of segments that were meant, and others.
#include "commands/check/cut_input.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"
#include "support/temporary_folder.hpp"

namespace cover::app {
namespace {

/// A mesh with cut segments, and its input.
struct Case {
  Case() {
    const Input input = testing::checker(2, 1, 5);
    Options options;
    options.method = Method::nonobtuse;
    output = testing::must_mesh(input, options);
    mesh.soup = triangle_soup(output.mesh);
    Result<Prepared> clean = prepare(input, {});
    EXPECT_TRUE(clean);
    prepared = *std::move(clean);
    found = verify_cover(prepared.pslg, prepared.table, mesh.soup);
  }

  Output output;
  MeshTriangles mesh;
  Prepared prepared;
  Verification found;
};

TEST(CutInput, HasThePointsOfTheMesh) {
  const Case one;
  const CutInput cut = cut_as(one.prepared, one.mesh.soup);
  EXPECT_GT(cut.points, 0u);
  EXPECT_EQ(cut.pslg.points.size(), one.prepared.pslg.points.size() + cut.points);
  EXPECT_TRUE(verify_cover(cut.pslg, cut.table, one.mesh.soup).violations.empty());
  EXPECT_EQ(cut_as({cut.pslg, cut.table, {}}, one.mesh.soup).points, 0u);
}

TEST(CutInput, TakesCutsThatWereMeant) {
  Case one;
  one.mesh.cut_vertices = 1;  // so says the file of a run that was to cut
  const auto cuts = take_own_cuts("nowhere.vtu", one.mesh, {}, one.prepared, one.found);
  ASSERT_TRUE(cuts);
  EXPECT_TRUE(cuts->are_meant);
  EXPECT_FALSE(cuts->are_on_arcs);
  EXPECT_TRUE(cuts->are_pieces_sound);
  EXPECT_TRUE(one.found.violations.empty());
  EXPECT_EQ(cut_as(one.prepared, one.mesh.soup).points, 0u);
}

TEST(CutInput, KnowsTheOptionFromTheManifest) {
  Case one;
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "a.vtm";
  ASSERT_TRUE(write_mesh(one.output, path));
  const auto cuts = take_own_cuts(path, one.mesh, {}, one.prepared, one.found);
  ASSERT_TRUE(cuts);
  EXPECT_EQ(cuts->option, "--method nonobtuse");
}

TEST(CutInput, ListsCutSegmentsIfNobodyMeantThem) {
  Case one;
  const std::size_t points = one.prepared.pslg.points.size();
  const auto cuts = take_own_cuts("nowhere.vtu", one.mesh, {}, one.prepared, one.found);
  ASSERT_TRUE(cuts);
  EXPECT_FALSE(cuts->are_meant);
  EXPECT_EQ(cuts->option, "");
  EXPECT_EQ(one.prepared.pslg.points.size(), points);
  EXPECT_FALSE(one.found.violations.empty());
  EXPECT_TRUE(std::all_of(one.found.violations.begin(), one.found.violations.end(),
                          [](const Violation& violation) { return violation.promise == 1; }));
}

TEST(CutInput, ABrokenMeshIsNotOnlyCut) {
  Case one;
  one.mesh.soup.triangles.pop_back();
  one.found = verify_cover(one.prepared.pslg, one.prepared.table, one.mesh.soup);
  const std::size_t before = one.found.violation_count;
  EXPECT_FALSE(take_own_cuts("nowhere.vtu", one.mesh, {}, one.prepared, one.found));
  EXPECT_EQ(one.found.violation_count, before);
  // What the run cut is not broken, and hides nothing else.
  one.mesh.cut_vertices = 1;
  EXPECT_TRUE(take_own_cuts("nowhere.vtu", one.mesh, {}, one.prepared, one.found));
  EXPECT_GT(one.found.violation_count, 0U);
  EXPECT_LT(one.found.violation_count, before);
}

}  // namespace
}  // namespace cover::app
