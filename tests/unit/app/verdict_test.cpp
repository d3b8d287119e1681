// What a report says of a mesh: good ones, missed targets, changed input, broken promises.
#include "words/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <cover/cover_mesh.hpp>
#include <cover/options.hpp>

#include "page/html_report.hpp"
#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover::app {
namespace {

using Grade = Finding::Grade;

Output mesh_of(const Input& input, const Options& options = {}) {
  Result<Output> output = cover_mesh(input, options);
  EXPECT_TRUE(output) << output.error().message;
  return std::move(output).value();
}

Finding finding(const std::vector<Finding>& findings, const std::string& what) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const Finding& f) { return f.what == what; });
  return found == findings.end() ? Finding{Grade::bad, what, "missing"} : *found;
}

std::string page_of(const Output& output) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "page.html";
  EXPECT_TRUE(write_report_html(output, path));
  return testing::content(path);
}

TEST(Verdict, AGoodMesh) {
  const Output output = mesh_of(testing::checker(3, 4, 5));
  const auto findings = findings_of(output);
  EXPECT_EQ(verdict_of(findings), Grade::good);
  EXPECT_EQ(finding(findings, "Largest angle").grade, Grade::good);
  EXPECT_NE(page_of(output).find("A good mesh"), std::string::npos);
}

TEST(Verdict, WithoutTargetsAnglesAreFacts) {
  Options options;
  options.method = Method::almond;
  const auto findings = findings_of(mesh_of(testing::checker(3, 4, 5), options));
  EXPECT_EQ(verdict_of(findings), Grade::good);
  EXPECT_EQ(finding(findings, "Largest angle").grade, Grade::fact);
}

TEST(Verdict, TargetsAreThoseOfTheRun) {
  Options options;
  options.max_angle = Angle::degrees(150);
  options.min_angle = Angle::degrees(59);
  const auto findings = findings_of(mesh_of(testing::checker(3, 4, 5), options));
  EXPECT_NE(finding(findings, "Largest angle").text.find("target of 150°"), std::string::npos);
  EXPECT_EQ(finding(findings, "Smallest angle").grade, Grade::caution);
  EXPECT_NE(finding(findings, "Smallest angle").text.find("target of 59°"), std::string::npos);
}

TEST(Verdict, AMissIsForcedOnlyAsFarAsTheBoundSays) {
  Output output = mesh_of(testing::checker(3, 4, 5));
  const auto set = [&](std::size_t region, double reached, double lowest) {
    output.report.regions[region].quality.largest_nu = Angle::degrees(180 - reached);
    output.report.regions[region].nu_opt = Angle::degrees(180 - lowest);
  };
  const auto says = [&](const std::string& part) {
    const std::string text = finding(findings_of(output), "Largest angle").text;
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  set(0, 130, 130);
  says("missed in 1 of 9 regions, where no mesh is better.");
  set(0, 130, 119);
  says("missed in 1 of 9 regions, where no mesh reaches it, though a better one is not ruled out.");
  set(0, 101, 80);
  says("missed in 1 of 9 regions, where the input does not force it.");
  set(1, 130, 119);
  set(2, 150, 150);
  set(3, 151, 151);
  says(
      "missed in 4 of 9 regions: in 2 no mesh is better, in 1 no mesh reaches it, though a better "
      "one is not ruled out, in 1 the input does not force it.");
}

TEST(Verdict, TheNonobtuseMethodHasItsOwnLimit) {
  Options options;
  options.method = Method::nonobtuse;
  Output output = mesh_of(testing::checker(2, 2, 5), options);
  const auto largest = [&](double angle) {
    output.report.regions[0].quality.largest_nu = Angle::degrees(180 - angle);
    output.report.regions[0].quality.obtuse = 1;
    return finding(findings_of(output), "Largest angle");
  };
  EXPECT_EQ(largest(90.09).grade, Grade::good);
  EXPECT_NE(largest(90.09).text.find("90.09°: the target of 90.1° is reached"), std::string::npos);
  EXPECT_EQ(largest(90.2).grade, Grade::caution);
}

TEST(Verdict, AChangedInputIsAReasonToLook) {
  const Input input = testing::segments_between({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {1, 2}},
                                                {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
  const auto findings = findings_of(mesh_of(input));
  EXPECT_EQ(verdict_of(findings), Grade::caution);
  EXPECT_EQ(
      finding(findings, "Input").text,
      "Changed in 2 places, of which the first of each kind are told below; all stand in the JSON "
      "report.");
  EXPECT_EQ(finding(findings, "Mesh").grade, Grade::good);
}

TEST(Verdict, AMissedBoundIsBad) {
  Output output = mesh_of(testing::checker(3, 4, 5));
  output.report.regions[4].bound_held = false;
  const auto findings = findings_of(output);
  EXPECT_EQ(verdict_of(findings), Grade::bad);
  EXPECT_NE(finding(findings, "Bound").text.find("missed in region 5"), std::string::npos);
  const std::string page = page_of(output);
  EXPECT_NE(page.find("Do not use"), std::string::npos);
  EXPECT_NE(page.find("class=\"missed\""), std::string::npos);
  // Where doubles cannot hold it, the mesh is as good as it can be.
  output.report.regions[4].notes.push_back({Note::Kind::below_resolution, RegionId(5), "flat", {}});
  EXPECT_EQ(verdict_of(findings_of(output)), Grade::caution);
}

TEST(Verdict, TheMeshIsCheckedAndNotBelieved) {
  Output output = mesh_of(testing::checker(3, 4, 5));
  const TriMesh::VertexHandle moved(0);
  output.mesh.tri().set_point(moved, output.mesh.tri().point(moved) - TriMesh::Point(1e-9, 0, 0));
  const auto findings = findings_of(output);
  EXPECT_EQ(verdict_of(findings), Grade::bad);
  EXPECT_EQ(finding(findings, "Mesh").text.rfind("NOT VALID: ", 0), 0U);
  EXPECT_NE(page_of(output).find("NOT VALID"), std::string::npos);
}

}  // namespace
}  // namespace cover::app
