// The dispatch by extension.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <cover/mesh_class.hpp>
#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"

namespace cover {
namespace {

TEST(WriteMesh, WritesEveryFormatAndNothingElse) {
  const Output output = testing::odd_device();
  for (const std::string& extension : write_formats()) {
    const testing::TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / ("x" + extension);
    const Status status = write_mesh(output, path.string());
    ASSERT_TRUE(status) << status.error().message;
    EXPECT_TRUE(std::filesystem::file_size(path) > 0) << extension;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      EXPECT_EQ(entry.path().stem(), "x") << "left behind";
  }
}

TEST(WriteMesh, SecondOrderWhereTheFormatHasIt) {
  WriteOptions options;
  options.order = 2;
  for (const char* path : {"x.msh", "x.vtk", "x.xdmf", "x.mesh", "x.inp", "x.ele", "x.json"})
    EXPECT_TRUE(can_write(path, options)) << path;
  for (const char* path : {"x.obj", "x.off", "x.ply"}) {
    const Status status = can_write(path, options);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::bad_option);
    EXPECT_NE(status.error().message.find("no second-order triangles"), std::string::npos);
  }
}

TEST(WriteMesh, TellsOfItsFormats) {
  for (const char* path : {"x.msh", "x.MSH", "a.b/c.Vtu"}) EXPECT_TRUE(can_write(path)) << path;
  EXPECT_EQ(companions_of("a/x.ele"), (std::vector<std::string>{"a/x.node", "a/x.edge"}));
  EXPECT_EQ(companions_of("a/x.VTM"), std::vector<std::string>{"a/x"});
  EXPECT_EQ(companions_of("x.pvtu"), std::vector<std::string>{"x.parts"});
  EXPECT_EQ(companions_of("x.msh"), std::vector<std::string>{});
  EXPECT_EQ(companions_of("x.node"), std::vector<std::string>{});
  const std::vector<std::string> all = write_formats();
  for (const auto& some :
       {attribute_formats(), word_formats(), value_formats(), point_formats(), number_formats()}) {
    EXPECT_FALSE(some.empty());
    for (const std::string& format : some)
      EXPECT_NE(std::find(all.begin(), all.end(), format), all.end()) << format;
  }
}

TEST(WriteMesh, RefusesWhatItDoesNotKnow) {
  for (const char* path : {"x", "x.foo", "x.msh2", ".msh"}) {
    const Status status = can_write(path);
    ASSERT_FALSE(status) << path;
    EXPECT_EQ(status.error().code, ErrorCode::unsupported_format);
    EXPECT_NE(status.error().message.find(".vtu, .vtm, .vtkhdf, .vtk, .msh"), std::string::npos);
  }
  for (const WriteOptions& options :
       {WriteOptions{.order = 3}, WriteOptions{.msh = "4.0"}, WriteOptions{.inp_element = "C3D"}})
    EXPECT_EQ(can_write("x.msh", options).error().code, ErrorCode::bad_option);
}

// A name that is there with exit 0 and cannot be read back.
TEST(WriteMesh, RefusesNamesThatItsXmlCannotHold) {
  WriteOptions hdf5;
  hdf5.xdmf = "hdf5";
  for (const std::string name : {"a\x1b", "a\nb", "a\xff"}) {
    EXPECT_FALSE(can_write(name + ".vtm")) << name;
    EXPECT_FALSE(can_write(name + ".pvtu")) << name;
    EXPECT_FALSE(can_write(name + ".xdmf", hdf5)) << name;
    for (const char* alone : {".xdmf", ".vtu", ".vtkhdf", ".msh"})
      EXPECT_TRUE(can_write(name + alone)) << name << alone;
  }
  EXPECT_TRUE(can_write("a&<b>\"' \u00fc.vtm"));
}

TEST(WriteMesh, AFolderThatIsNotThere) {
  const Output output = testing::structured_mesh(2, 1);
  const testing::TemporaryFolder folder;
  for (const char* name : {"none/x.msh", "none/x.ele", "none/x.json"}) {
    const Status status = write_mesh(output, (folder.path() / name).string());
    ASSERT_FALSE(status) << name;
    EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
  }
}

/// Whatever the name of the file is.
TEST(WriteMesh, WritersOfSingleFormatsRefuseWhatItRefuses) {
  const Output output = testing::odd_device();
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "x.any";
  const auto expect_refused = [&](auto write, const WriteOptions& options) {
    const Status status = write(output, path, options);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::bad_option) << status.error().message;
  };
  WriteOptions parts, many, version, order, element, ids, xdmf;
  parts.parts = -3;
  many.parts = 501;
  many.msh = "4.1";
  version.msh = "9";
  order.order = 7;
  element.inp_element = "X";
  ids.ids = "q";
  xdmf.xdmf = "x";
  expect_refused(write_pvtu, parts);
  expect_refused(write_msh, many);
  for (const WriteOptions& options : {parts, version, order, element, ids, xdmf}) {
    for (const auto write :
         {write_vtu, write_vtk, write_vtkhdf, write_vtm, write_pvtu, write_msh, write_xdmf,
          write_medit, write_inp, write_triangle, write_obj, write_off, write_ply, write_manifest})
      expect_refused(write, options);
  }
  WriteOptions beside;  // those of a .msh in parts, for its manifest
  beside.parts = 3;
  beside.msh = "4.1";
  EXPECT_TRUE(write_manifest(output, folder.path() / "x.json", beside));
}

TEST(WriteMesh, StopsBeforeAnyFile) {
  const Output output = testing::odd_device();
  std::stop_source source;
  source.request_stop();
  WriteOptions options;
  options.stop = source.get_token();
  for (const std::string& extension : write_formats()) {
    const testing::TemporaryFolder folder;
    const Status status = write_mesh(output, folder.path() / ("x" + extension), options);
    ASSERT_FALSE(status) << extension;
    EXPECT_EQ(status.error().code, ErrorCode::cancelled) << extension;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << extension;
  }
}

TEST(WriteMesh, RefusesAnOutputWithoutTriangles) {
  const testing::TemporaryFolder folder;
  Output output = testing::odd_device();
  const Output moved = std::move(output);
  Output elsewhere = moved;  // as that of a streamed mesh
  elsewhere.mesh = Mesh();
  const auto expect_refused = [](const Status& status, const std::string& words) {
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
    EXPECT_NE(status.error().message.find(words), std::string::npos) << status.error().message;
  };
  for (const std::string& extension : write_formats()) {
    SCOPED_TRACE(extension);
    const std::string path = folder.path() / ("x" + extension);
    // NOLINTNEXTLINE(bugprone-use-after-move): that is the point
    expect_refused(write_mesh(output, path), "it was moved from");
    if (extension == ".poly") continue;  // has no triangles anyway
    expect_refused(write_mesh(elsewhere, path), "write_streamed_mesh() writes them");
    WriteOptions second;
    second.order = 2;
    EXPECT_FALSE(write_mesh(output, path, second));
  }
  for (const auto write :
       {write_vtu, write_vtk, write_vtkhdf, write_vtm, write_pvtu, write_msh, write_xdmf,
        write_medit, write_inp, write_triangle, write_obj, write_off, write_ply, write_manifest})
    expect_refused(write(elsewhere, folder.path() / "x.any", {}), "the output has no triangles");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_TRUE(write_mesh(elsewhere, folder.path() / "x.poly"));
}

}  // namespace
}  // namespace cover
