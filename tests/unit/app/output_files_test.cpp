// What is known of the files to be written before they are, and that all of them are.
#include "files/output_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <string>
#include <vector>

#include <spdlog/logger.h>
#include <CLI/CLI.hpp>

#include <cover/cover_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace cover::app {
namespace {

using Strings = std::vector<std::string>;

/// What a command line says of files.
struct Asked {
  Asked(std::initializer_list<std::string> words) {
    files.add_meshes(app, "stdout");
    files.add_formats(app, "Files");
    files.add_reports(app, "Files");
    app.parse(Strings(std::rbegin(words), std::rend(words)));
  }

  CLI::App app;
  OutputFiles files;
};

ErrorCode refusal(std::initializer_list<std::string> words) {
  Asked asked(words);
  const Status planned = asked.files.plan();
  return planned ? ErrorCode::internal : planned.error().code;
}

TEST(OutputFiles, MeshesComeBeforeReports) {
  const Asked asked{"--report", "a.json", "-o", "a.vtu", "-o", "-"};
  EXPECT_EQ(asked.files.paths(), (Strings{"a.vtu", "-", "a.json"}));
  EXPECT_TRUE(asked.files.has_stdout());
  const std::vector<NamedFile> named = asked.files.named_files();
  ASSERT_EQ(named.size(), 3u);
  EXPECT_TRUE(named[0].is_mesh);
  EXPECT_EQ(named[2].option, "--report");
  EXPECT_FALSE(named[2].is_mesh);
}

TEST(OutputFiles, WhatCannotBeWrittenIsKnownBefore) {
  EXPECT_EQ(refusal({"-o", "a.xyz"}), ErrorCode::unsupported_format);
  EXPECT_EQ(refusal({"--report", "a.vtu"}), ErrorCode::unsupported_format);
  EXPECT_EQ(refusal({"-o", "-", "--format", "vtm"}), ErrorCode::bad_option);
}

TEST(OutputFiles, WarnsOfWhatIsLost) {
  const std::vector<Attribute> attributes{{"owner", false, {}, {}}};
  EXPECT_EQ(Asked({"-o", "a.vtu"}).files.warnings(attributes, {}, {}), Strings{});
  EXPECT_EQ(Asked({"-o", "a.inp"}).files.warnings({}, {}, {}), Strings{});
  EXPECT_EQ(Asked({"-o", "a.inp", "-o", "a.json"}).files.warnings(attributes, {}, {}), Strings{});
  const Strings lost = Asked({"-o", "-", "--format", "inp"}).files.warnings(attributes, {}, {});
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].find("attributes (owner) are not in standard output: "), 0u) << lost[0];
  Attribute code{"code", true, {"07", "12"}, {1, 2}};
  const std::string told =
      "texts (code: 1 = 07, 2 = 12) are not in a.vtu: formats that hold them are .vtm, .vtkhdf, "
      ".json";
  EXPECT_EQ(Asked({"-o", "a.vtu"}).files.warnings({code}, {}, {}), Strings{told});
  for (const char* holding : {"a.json", "a.vtm"})
    EXPECT_EQ(Asked({"-o", "a.vtu", "-o", holding}).files.warnings({code}, {}, {}), Strings{});
  EXPECT_EQ(Asked({"-o", "a.vtkhdf"}).files.warnings({code}, {}, {}), Strings{});
  const Strings neither = Asked({"-o", "a.inp"}).files.warnings({code}, {}, {});
  ASSERT_EQ(neither.size(), 1u) << "nor are the numbers";
  EXPECT_EQ(neither[0].find("attributes (code) are"), 0u);
  code.words.assign(12, "x");
  EXPECT_NE(Asked({"-o", "a.vtu"}).files.warnings({code}, {}, {})[0].find("10 = x, ...)"),
            std::string::npos);
  const std::vector<PlaneField::Array> doping{{"Net", {}}};
  EXPECT_EQ(Asked({"-o", "a.vtk", "-o", "b.poly", "-o", "c.svg"}).files.warnings({}, doping, {}),
            Strings{});
  const Strings values = Asked({"-o", "a.mesh", "-o", "a.json"}).files.warnings({}, doping, {});
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(values[0].find("values at points (Net) are not in a.mesh: "), 0u) << values[0];
  std::vector<PeriodicRule> sides(1);
  sides[0].from = "left";
  sides[0].to = "right";
  EXPECT_EQ(Asked({"-o", "a.msh", "-o", "b.pvtu", "-o", "c.vtkhdf"}).files.warnings({}, {}, sides),
            Strings{});
  EXPECT_EQ(Asked({"-o", "a.inp", "-o", "a.json"}).files.warnings({}, {}, sides), Strings{});
  const Strings pairs = Asked({"-o", "a.xdmf", "-o", "b.vtu", "-o", "c.inp", "-o", "d.mesh"})
                            .files.warnings({}, {}, sides);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0],
            "pairs on periodic sides ('left' and 'right') are not in a.xdmf, c.inp, d.mesh: "
            "formats that hold them are "
            ".vtu, .vtm, .vtkhdf, .vtk, .msh, .pvtu, .json");
  const Strings wells{"well", "probe", "well"};
  EXPECT_EQ(Asked({"-o", "a.vtm", "-o", "a.vtu"}).files.warnings({}, {}, {}, wells), Strings{});
  EXPECT_EQ(Asked({"-o", "a.vtu", "-o", "a.json"}).files.warnings({}, {}, {}, wells), Strings{});
  EXPECT_EQ(Asked({"-o", "a.xdmf", "-o", "b.inp", "-o", "c.vtk"}).files.warnings({}, {}, {}, wells),
            Strings{"names of points (well, probe) are not in a.xdmf, c.vtk: formats that hold "
                    "them are .vtm, .vtkhdf, .msh, .mesh, .inp, .json"});
  const Strings many{"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "b", "l"};
  const Strings some = Asked({"-o", "a.vtk"}).files.warnings({}, {}, {}, many);
  ASSERT_EQ(some.size(), 1u);
  EXPECT_EQ(some[0].find("names of points (a, b, c, d, e, f, g, h, i, j and 2 more) are"), 0u);
  const Strings idle = Asked({"-o", "a.vtu", "--xdmf", "hdf5"}).files.warnings({}, {}, {});
  EXPECT_EQ(idle, Strings{"--xdmf does nothing: it counts with .xdmf only"});
}

TEST(OutputFiles, WhatAnEarlierRunLeftBesideTheMeshIsTold) {
  const testing::TemporaryFolder folder;
  const std::string stem = folder.path() / "x";
  const auto left = [](std::initializer_list<std::string> words) {
    return Asked(words).files.left_beside();
  };
  EXPECT_TRUE(left({"-o", stem + ".vtu"}).empty());
  EXPECT_FALSE(folder.write("x.json", "{\"type\": \"FeatureCollection\"}").empty());
  EXPECT_TRUE(left({"-o", stem + ".vtu"}).empty()) << "no manifest";
  const Output output = cover_mesh(testing::checker(2, 2, 1)).value();
  ASSERT_TRUE(write_manifest(output, stem + ".json"));
  ASSERT_TRUE(write_vtm(output, stem + ".vtm"));
  const Strings told = left({"-o", stem + ".vtu", "-o", stem + ".msh", "-o", "-"});
  ASSERT_EQ(told.size(), 2u) << "once each";
  EXPECT_EQ(told[0], stem + ".json stays beside " + stem +
                         ".vtu as an earlier run left it, and is read with it for names: remove "
                         "it, or write it, too (-o)");
  EXPECT_TRUE(told[1].starts_with(stem + ".vtm stays")) << told[1];
  const Strings of_hdf = left({"-o", stem + ".vtkhdf"});
  ASSERT_EQ(of_hdf.size(), 1u) << "which needs no .vtm";
  EXPECT_NE(of_hdf[0].find("for arcs and periodic sides"), std::string::npos) << of_hdf[0];
  EXPECT_TRUE(left({"-o", stem + ".obj"}).empty()) << "which is never read as a mesh";
  EXPECT_TRUE(left({"-o", stem + ".vtu", "-o", stem + ".json", "-o", stem + ".vtm"}).empty());
}

TEST(OutputFiles, NamedLinesThatAreLeftOutAreTold) {
  Input input = testing::checker(2, 2, 5);
  const Result<Output> unnamed = cover_mesh(input);
  ASSERT_TRUE(unnamed);
  const auto warnings = [](std::initializer_list<std::string> words, const Output& output) {
    return Asked(words).files.warnings_of(output);
  };
  EXPECT_EQ(warnings({"-o", "a.msh", "--no-inner-lines"}, *unnamed), Strings{});
  for (InputSegment& segment : input.segments) segment.name = "grid";
  const Result<Output> named = cover_mesh(input);
  ASSERT_TRUE(named);
  EXPECT_EQ(warnings({"-o", "a.msh"}, *named), Strings{});
  EXPECT_EQ(warnings({"-o", "a.vtk", "-o", "b.vtm", "--no-inner-lines"}, *named), Strings{});
  EXPECT_EQ(warnings({"-o", "a.msh", "-o", "a.json", "--no-inner-lines"}, *named), Strings{});
  EXPECT_EQ(warnings({"-o", "a.msh", "-o", "b.vtm", "-o", "c.vtk", "--no-inner-lines", "--lines"},
                     *named),
            Strings{"named lines with triangles on both sides (grid) are not in a.msh, c.vtk: "
                    "--no-inner-lines leaves them out"});
}

TEST(OutputFiles, AllAreWritten) {
  const testing::TemporaryFolder folder;
  const std::string mesh = folder.path() / "a.vtu", report = folder.path() / "b.json";
  Asked asked{"-o", mesh, "--report", report};
  ASSERT_TRUE(asked.files.plan());
  const Result<Output> output = cover_mesh(testing::checker(2, 2, 5));
  ASSERT_TRUE(output);
  EXPECT_EQ(asked.files.warnings_of(*output), Strings{});
  spdlog::logger silent("silent");
  EXPECT_TRUE(asked.files.write(*output, {}, ShowProgress::off, silent));
  EXPECT_TRUE(std::filesystem::exists(mesh));
  EXPECT_TRUE(std::filesystem::exists(report));
}

}  // namespace
}  // namespace cover::app
