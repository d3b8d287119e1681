// VTKHDF: read by VTK's own reader, and by ours, which shares nothing with HDF5's library.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/read_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "io/hdf5/parse_hdf5.hpp"
#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

/// A device with odd names, a contact, markers.
Output named_device() {
  Output output = testing::odd_device();
  output.table.regions[1].name = "Gr\xc3\xb6\xc3\x9f\x65 \xc2\xb5m \xe6\x97\xa5\xe6\x9c\xac";
  output.table.regions[1].material_name = "Si:As";
  output.report.unit = "nm";
  output.report.scale = 0.1;
  return output;
}

/// With attributes of regions and values at points, which are not read back.
Output device_with_values() {
  Output output = named_device();
  std::vector<double> by_region, by_vertex;
  for (std::size_t r = 0; r < output.table.regions.size(); ++r)
    by_region.push_back(static_cast<double>(r % 3));
  for (std::size_t v = 0; v < output.mesh.vertices(); ++v)
    by_vertex.push_back(1e15 / (1 + static_cast<double>(v)));
  output.table.attributes = {{"N\xc3\xa4he & \"use\"", true, {"W\xc3\xa4lder", "b"}, by_region},
                             {"height", false, {}, by_region}};
  output.fields = {{"Net/1e17", by_vertex}};
  return output;
}

template <class Reader>
vtkSmartPointer<vtkUnstructuredGrid> grid_of(const std::string& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return vtkUnstructuredGrid::SafeDownCast(reader->GetOutputAsDataSet());
}

TEST(WriteVtkHdf, VtkReadsWhatItReadsFromVtu) {
  const testing::TemporaryFolder folder;
  const Output output = device_with_values();
  for (const int order : {1, 2}) {
    SCOPED_TRACE(order);
    const std::string hdf = folder.path() / "x.vtkhdf", vtu = folder.path() / "x.vtu";
    ASSERT_TRUE(write_mesh(output, hdf, {.order = order}));
    ASSERT_TRUE(write_mesh(output, vtu, {.order = order}));
    const auto a = grid_of<vtkHDFReader>(hdf), b = grid_of<vtkXMLUnstructuredGridReader>(vtu);
    ASSERT_TRUE(a);
    ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
    ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
    ASSERT_GT(a->GetNumberOfCells(), 0);
    EXPECT_EQ(a->GetPoints()->GetDataType(), VTK_DOUBLE);
    for (vtkIdType p = 0; p < a->GetNumberOfPoints(); ++p)
      for (int k = 0; k < 3; ++k) EXPECT_EQ(a->GetPoint(p)[k], b->GetPoint(p)[k]);
    for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c) {
      ASSERT_EQ(a->GetCellType(c), b->GetCellType(c));
      vtkNew<vtkIdList> of_a, of_b;
      a->GetCellPoints(c, of_a);
      b->GetCellPoints(c, of_b);
      ASSERT_EQ(of_a->GetNumberOfIds(), of_b->GetNumberOfIds());
      for (vtkIdType k = 0; k < of_a->GetNumberOfIds(); ++k)
        EXPECT_EQ(of_a->GetId(k), of_b->GetId(k));
    }
    ASSERT_EQ(a->GetPointData()->GetNumberOfArrays(), 1);
    vtkDataArray* const doping = a->GetPointData()->GetArray("Net_1e17");
    vtkDataArray* const in_vtu = b->GetPointData()->GetArray("Net_1e17");
    ASSERT_TRUE(doping && in_vtu);
    for (vtkIdType p = 0; p < a->GetNumberOfPoints(); ++p)
      EXPECT_EQ(doping->GetTuple1(p), in_vtu->GetTuple1(p));
    for (std::size_t v = 0; v < output.mesh.vertices(); ++v)
      EXPECT_EQ(doping->GetTuple1(static_cast<vtkIdType>(v)), output.fields[0].values[v]);
    vtkDataArray* const regions = b->GetCellData()->GetArray("RegionId");
    for (const char* name : {"N\xc3\xa4he & _use_", "height"}) {
      vtkDataArray* const kept = b->GetCellData()->GetArray(name);
      ASSERT_NE(kept, nullptr) << name;
      for (vtkIdType c = 0; c < b->GetNumberOfCells(); ++c)
        EXPECT_EQ(kept->GetTuple1(c), static_cast<int>(regions->GetTuple1(c) - 1) % 3);
    }
    auto* const words = vtkStringArray::SafeDownCast(
        a->GetFieldData()->GetAbstractArray("N\xc3\xa4he & _use__names"));
    ASSERT_NE(words, nullptr);
    ASSERT_EQ(words->GetNumberOfValues(), 2);
    EXPECT_EQ(words->GetValue(0), "W\xc3\xa4lder");
    ASSERT_EQ(a->GetCellData()->GetNumberOfArrays(), b->GetCellData()->GetNumberOfArrays());
    for (int k = 0; k < b->GetCellData()->GetNumberOfArrays(); ++k) {
      vtkDataArray* const from_vtu = b->GetCellData()->GetArray(k);
      vtkDataArray* const found = a->GetCellData()->GetArray(from_vtu->GetName());
      ASSERT_NE(found, nullptr) << from_vtu->GetName();
      EXPECT_EQ(found->GetDataType(), from_vtu->GetDataType());
      for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
        EXPECT_EQ(found->GetTuple1(c), from_vtu->GetTuple1(c));
    }
    auto* const names =
        vtkStringArray::SafeDownCast(a->GetFieldData()->GetAbstractArray("RegionName"));
    ASSERT_NE(names, nullptr);
    ASSERT_EQ(names->GetNumberOfValues(), static_cast<vtkIdType>(output.table.regions.size()));
    for (vtkIdType r = 0; r < names->GetNumberOfValues(); ++r)
      EXPECT_EQ(names->GetValue(r), output.table.regions[static_cast<std::size_t>(r)].name);
    vtkDataArray* const lines = a->GetFieldData()->GetArray("LineNodes");
    ASSERT_NE(lines, nullptr);
    EXPECT_GT(lines->GetNumberOfTuples(), 0);
    EXPECT_EQ(lines->GetNumberOfComponents(), order + 1);
  }
}

TEST(WriteVtkHdf, AloneGivesBackAll) {
  const testing::TemporaryFolder folder;
  const Output written = named_device();
  for (const int order : {1, 2}) {
    SCOPED_TRACE(order);
    const std::string path = folder.path() / "x.vtkhdf";
    ASSERT_TRUE(write_mesh(written, path, {.order = order}));
    const Result<Output> read = read_output(path);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(read->report.notes.empty());
    EXPECT_EQ(read->report.unit, "nm");
    EXPECT_EQ(read->report.scale, 0.1);
    EXPECT_EQ(read->report.provenance.settings, written.report.provenance.settings);
    ASSERT_EQ(read->table.interfaces.size(), written.table.interfaces.size());
    // All of it, byte for byte: names, markers, sides, input points.
    for (const char* name : {"x.msh", "x.json", "x.vtm"}) {
      ASSERT_TRUE(write_mesh(written, folder.path() / (std::string("a-") + name)));
      ASSERT_TRUE(write_mesh(*read, folder.path() / (std::string("b-") + name)));
    }
    EXPECT_EQ(testing::content(folder.path() / "a-x.msh"),
              testing::content(folder.path() / "b-x.msh"));
    for (std::size_t r = 0; r < written.table.regions.size(); ++r) {
      EXPECT_EQ(read->table.regions[r].name, written.table.regions[r].name);
      EXPECT_EQ(read->table.regions[r].material_name, written.table.regions[r].material_name);
    }
    for (std::size_t k = 0; k < written.table.interfaces.size(); ++k) {
      EXPECT_EQ(read->table.interfaces[k].name, written.table.interfaces[k].name);
      EXPECT_EQ(read->table.interfaces[k].kind, written.table.interfaces[k].kind);
      EXPECT_EQ(read->table.interfaces[k].left, written.table.interfaces[k].left);
      EXPECT_EQ(read->table.interfaces[k].right, written.table.interfaces[k].right);
    }
    if (order == 1) {
      ASSERT_TRUE(write_mesh(*read, folder.path() / "again.vtkhdf"));
      EXPECT_EQ(testing::content(path), testing::content(folder.path() / "again.vtkhdf"));
    }
  }
}

TEST(WriteVtkHdf, SameBytesForAnyNumberOfThreadsAndAnyRepeat) {
  const testing::TemporaryFolder folder;
  std::string first;
  for (const unsigned threads : {1U, 2U, 8U, 1U}) {
    Options options;
    options.threads = threads;
    Result<Output> output = cover_mesh(testing::checker(3, 4, 5), options);
    ASSERT_TRUE(output);
    const std::string path = folder.path() / "x.vtkhdf";
    ASSERT_TRUE(write_vtkhdf(*output, path));
    if (first.empty()) first = testing::content(path);
    EXPECT_EQ(testing::content(path), first) << threads << " threads";
  }
  EXPECT_GT(first.size(), 1000U);
}

TEST(WriteVtkHdf, AStopLeavesTheOldFile) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.write("x.vtkhdf", "old");
  std::stop_source stop;
  stop.request_stop();
  WriteOptions options;
  options.stop = stop.get_token();
  const Status status = write_vtkhdf(named_device(), path, options);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cancelled);
  EXPECT_EQ(testing::content(path), "old");
}

TEST(ParseHdf5, ReadsTheTree) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "x.vtkhdf";
  ASSERT_TRUE(write_vtkhdf(named_device(), path));
  const std::string text = testing::content(path);
  const Result<Hdf5Tree> tree = parse_hdf5(text, "x");
  ASSERT_TRUE(tree) << tree.error().message;
  const Hdf5Object& root = tree->at("/VTKHDF");
  EXPECT_TRUE(root.is_group);
  EXPECT_EQ(root.attributes.at("Type").texts, std::vector<std::string>{"UnstructuredGrid"});
  const Hdf5Value& version = root.attributes.at("Version");
  EXPECT_EQ(version.shape, std::vector<std::uint64_t>{2});
  EXPECT_EQ(NumberView<std::int64_t>(version.bytes.data(), 2)[0], 1);
  EXPECT_EQ(tree->at("/VTKHDF/FieldData/Unit").value.texts, std::vector<std::string>{"nm"});
  EXPECT_EQ(tree->at("/VTKHDF/Types").value.type, NumberType::uint8);
}

TEST(ParseHdf5, EndsWellOnBrokenFiles) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "x.vtkhdf";
  ASSERT_TRUE(write_vtkhdf(named_device(), path));
  const std::string whole = testing::content(path);
  // Cut off anywhere: numbers come last, so nearly everything is missed.
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 200) {
    const Result<MeshFile> mesh = read_mesh(folder.write("cut.vtkhdf", whole.substr(0, size)));
    EXPECT_FALSE(mesh) << size;
    if (!mesh) {
      EXPECT_NE(mesh.error().message.find("cut.vtkhdf"), std::string::npos);
    }
  }
  // Bytes changed anywhere: a mesh or an error.
  constexpr unsigned kSeed = 17;
  std::mt19937 random(kSeed);
  int refused = 0;
  for (int n = 0; n < 400; ++n) {
    std::string text = whole;
    for (int k = 0; k < 4; ++k) text[random() % text.size()] = static_cast<char>(random());
    const Result<Output> read = read_output(folder.write("changed.vtkhdf", text));
    refused += read ? 0 : 1;
    if (!read) {
      EXPECT_FALSE(read.error().message.empty());
    }
  }
  EXPECT_GT(refused, 20) << "seed " << kSeed;
}

TEST(ParseHdf5, SizesThatLieCostNothing) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "x.vtkhdf";
  ASSERT_TRUE(write_vtkhdf(named_device(), path));
  const std::string whole = testing::content(path);
  const auto message = [&](const std::string& text) {
    const Result<MeshFile> mesh = read_mesh(folder.write("lies.vtkhdf", text));
    return mesh ? std::string("no error") : mesh.error().message;
  };
  EXPECT_NE(message("\x89HDF\r\n\x1a\n").find("bytes at 8"), std::string::npos);
  EXPECT_NE(message("no HDF5").find("not a file in HDF5"), std::string::npos);
  // A root group at its own superblock, and one far away.
  for (const std::uint64_t address : {std::uint64_t{0}, std::uint64_t{1} << 62U}) {
    std::string text = whole;
    for (std::size_t k = 0; k < 8; ++k) text[64 + k] = static_cast<char>(address >> (8 * k));
    EXPECT_NE(message(text), "no error");
  }
  // A thousand times the points, by the counts and by the shape.
  const std::uint64_t points = triangle_soup(named_device().mesh).points.size();
  std::string text = whole;
  std::string bytes(8, '\0'), large(8, '\0');
  for (std::size_t k = 0; k < 8; ++k) {
    bytes[k] = static_cast<char>(points >> (8 * k));
    large[k] = static_cast<char>((points << 40U) >> (8 * k));
  }
  int changed = 0;
  for (std::size_t at = text.find(bytes); at != text.npos; at = text.find(bytes, at + 8), ++changed)
    text.replace(at, 8, large);
  ASSERT_GE(changed, 2);
  EXPECT_NE(message(text), "no error");
}

}  // namespace
}  // namespace cover
