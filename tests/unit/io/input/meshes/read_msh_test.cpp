#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <initializer_list>

#include <cover/cover_mesh.hpp>

#include "io/input/formats.hpp"

namespace cover {
namespace {

// Two squares of two triangles each; the line between them and the left side are named.
constexpr std::string_view kMesh22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
whatever 1 2 3
$EndComments
$PhysicalNames
3
1 11 "left contact"
2 1 "Si"
2 2 "SiO2"
$EndPhysicalNames
$Nodes
7
1 0 0 3
2 1 0 3
30 2 0 3
4 0 1 3
5 1 1 3
6 2 1 3
7 9 9 0
$EndNodes
$Elements
8
1 1 2 11 4 4 1
2 1 2 21 5 2 5
3 1 2 0 6 1 2
4 2 2 1 1 1 2 5
5 2 2 1 1 1 5 4
6 2 2 2 2 2 30 6
7 2 2 2 2 2 6 5
8 15 2 3 1 1
$EndElements
)";

constexpr std::string_view kMesh41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 11 "left contact"
2 1 "Si"
2 2 "SiO2"
$EndPhysicalNames
$Entities
1 2 2 0
1 0 0 3 0
4 0 0 3 0 1 3 1 11 2 1 -2
5 1 0 3 1 1 3 1 21 0
1 0 0 3 1 1 3 1 1 4 1 2 3 4
2 1 0 3 2 1 3 1 2 4 1 2 3 4
$EndEntities
$Nodes
2 6 1 30
2 1 0 4
1
2
4
5
0 0 3
1 0 3
0 1 3
1 1 3
2 2 1 2
30
6
2 0 3 0.5 0.5
2 1 3 0.5 0.5
$EndNodes
$Elements
4 6 1 7
1 4 1 1
1 4 1
1 5 1 1
2 2 5
2 1 2 2
4 1 2 5
5 1 5 4
2 2 2 2
6 2 30 6
7 2 6 5
$EndElements
)";

class ReadMsh : public ::testing::TestWithParam<std::string_view> {};

TEST_P(ReadMsh, TakesTheBordersOfPhysicalGroups) {
  const Result<Input> input = parse_msh(GetParam(), "dev.msh");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->points.size(), 6u);
  EXPECT_EQ(input->segments.size(), 7u);
  ASSERT_EQ(input->seeds.size(), 2u);
  EXPECT_EQ(input->seeds[0].material, "Si");
  EXPECT_EQ(input->seeds[1].material, "SiO2");
  int contact = 0, unnamed_group = 0;
  for (const InputSegment& s : input->segments) {
    contact += s.name == "left contact" && s.marker == 11 && s.id == 1;
    unnamed_group += s.name == "21" && s.marker == 21;
  }
  EXPECT_EQ(contact, 1);
  EXPECT_EQ(unnamed_group, 1);
}

INSTANTIATE_TEST_SUITE_P(Versions, ReadMsh, ::testing::Values(kMesh22, kMesh41),
                         [](const auto& sample) { return sample.index == 0 ? "msh22" : "msh41"; });

std::string msh_message(std::string text) {
  const Result<Input> input = parse_msh(text, "dev.msh");
  EXPECT_FALSE(input.has_value());
  return input ? "" : input.error().message;
}

std::string with_replaced(std::string_view from, std::string_view to) {
  std::string text(kMesh22);
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST(ReadMshNames, OfPhysicalPoints) {
  const Result<Input> input = parse_msh(
      with_replaced("$PhysicalNames\n3\n", "$PhysicalNames\n4\n0 3 \"well\"\n"), "dev.msh");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  ASSERT_EQ(input->point_names.size(), 1U);
  EXPECT_EQ(input->point_names[0].name, "well");
  EXPECT_EQ(input->points[input->point_names[0].point], (Point{0, 0}));
  EXPECT_TRUE(parse_msh(kMesh22, "dev.msh")->point_names.empty());  // its group has none
}

TEST(ReadMshNames, OfPhysicalSurfacesStayIfTheyAreNumbers) {
  const Result<Input> input = parse_msh(with_replaced("2 1 \"Si\"", "2 1 \"7\""), "dev.msh");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  const Result<Prepared> prepared = prepare(*input, {});
  ASSERT_TRUE(prepared.has_value()) << prepared.error().message;
  ASSERT_EQ(prepared->table.regions.size(), 2U);
  EXPECT_EQ(prepared->table.regions[0].name, "7");
  EXPECT_EQ(prepared->table.regions[0].material, 7);
  EXPECT_EQ(prepared->table.regions[1].name, "SiO2");
  EXPECT_EQ(prepared->table.regions[1].material_name, "SiO2");
}

TEST(ReadMshErrors, SayFileAndLine) {
  EXPECT_EQ(msh_message(with_replaced("2.2 0 8", "2.2 1 8")),
            "dev.msh:2: a binary .msh with another order of bytes than this machine's");
  EXPECT_EQ(msh_message(with_replaced("2.2 0 8", "2.2 7 8")),
            "dev.msh:2: the file type is 7; 0 is text, 1 binary");
  EXPECT_EQ(msh_message(with_replaced("2.2 0 8", "4 0 8")),
            "dev.msh:2: version 4 of .msh; versions 2.2 and 4.1 are read (gmsh -format msh22 or "
            "msh41)");
  EXPECT_EQ(msh_message(with_replaced("6 2 1 3\n7", "6 2 one 3\n7")),
            "dev.msh:20: expected a coordinate, found 'one'");
  EXPECT_EQ(msh_message(with_replaced("1 2 5\n5", "1 2 99\n5")),
            "dev.msh:28: element 4 has the node 99, which is not given");
  EXPECT_EQ(msh_message(with_replaced("4 2 2 1 1", "4 4 2 1 1")),
            "dev.msh:28: elements of type 4; points, lines, triangles and quadrangles of a plane "
            "mesh are read");
  EXPECT_EQ(msh_message(with_replaced("7 9 9 0", "6 9 9 0")), "dev.msh:21: node 6 is given twice");
  EXPECT_EQ(msh_message("$NOD"), "dev.msh:1: expected $MeshFormat, found '$NOD'");
  EXPECT_NE(msh_message(with_replaced("6 2 1 3", "6 2 1 4")).find("not in a plane z = constant"),
            std::string::npos);
  EXPECT_NE(msh_message(std::string(kMesh22.substr(0, 300))), "");
}

/// A file as gmsh writes it with Mesh.Binary = 1.
class BinaryMsh {
 public:
  explicit BinaryMsh(std::string_view version) {
    text("$MeshFormat\n").text(version).text(" 1 8\n").ints({1}).text("\n$EndMeshFormat\n");
    text("$PhysicalNames\n1\n2 5 \"Si\"\n$EndPhysicalNames\n");
  }
  BinaryMsh& text(std::string_view words) {
    bytes_ += words;
    return *this;
  }
  BinaryMsh& ints(std::initializer_list<std::int32_t> numbers) { return add(numbers); }
  BinaryMsh& sizes(std::initializer_list<std::int64_t> numbers) { return add(numbers); }
  BinaryMsh& reals(std::initializer_list<double> numbers) { return add(numbers); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  BinaryMsh& add(std::initializer_list<T> numbers) {
    for (const T number : numbers) {
      std::array<char, sizeof(T)> raw{};
      std::memcpy(raw.data(), &number, sizeof(T));
      bytes_.append(raw.data(), raw.size());
    }
    return *this;
  }
  std::string bytes_;
};

// Two triangles of different groups, one of which has a name, and a line in a third one. Numbers
// whose bytes are blanks (10, 13, 32) are taken as they are.
std::string binary22() {
  BinaryMsh file("2.2");
  file.text("$Nodes\n4\n").ints({10}).reals({0, 0, 0}).ints({13}).reals({2, 0, 0});
  file.ints({32}).reals({2, 2, 0}).ints({7}).reals({0, 2, 0}).text("\n$EndNodes\n");
  file.text("$Elements\n3\n").ints({1, 1, 2}).ints({1, 9, 1, 10, 13});
  file.ints({2, 2, 2}).ints({2, 5, 1, 10, 13, 32}).ints({3, 6, 2, 10, 32, 7});
  return file.text("\n$EndElements\n").bytes();
}

std::string binary41() {
  BinaryMsh file("4.1");
  file.text("$Entities\n").sizes({0, 1, 2, 0});
  file.ints({1}).reals({0, 0, 0, 2, 0, 0}).sizes({2}).ints({9, 8}).sizes({0});
  file.ints({1}).reals({0, 0, 0, 2, 2, 0}).sizes({1}).ints({5}).sizes({1}).ints({1});
  file.ints({2}).reals({0, 0, 0, 2, 2, 0}).sizes({1}).ints({6}).sizes({0}).text("\n$EndEntities\n");
  file.text("$Nodes\n").sizes({1, 4, 7, 32}).ints({2, 1, 0}).sizes({4, 10, 13, 32, 7});
  file.reals({0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0}).text("\n$EndNodes\n");
  file.text("$Elements\n").sizes({3, 3, 1, 3}).ints({1, 1, 1}).sizes({1, 1, 10, 13});
  file.ints({2, 1, 2}).sizes({1, 2, 10, 13, 32}).ints({2, 2, 2}).sizes({1, 3, 10, 32, 7});
  return file.text("\n$EndElements\n").bytes();
}

TEST(ReadMshBinary, GivesWhatAsciiDoes) {
  for (const std::string& whole : {binary22(), binary41()}) {
    const Result<Input> input = parse_msh(whole, "dev.msh");
    ASSERT_TRUE(input.has_value()) << input.error().message;
    EXPECT_EQ(input->points.size(), 4u);
    EXPECT_EQ(input->points[2], (Point{2, 2}));
    EXPECT_EQ(input->point_ids[1], 13);
    EXPECT_EQ(input->segments.size(), 5u);
    ASSERT_EQ(input->seeds.size(), 2u);
    EXPECT_EQ(input->seeds[0].material, "Si");
    EXPECT_EQ(input->seeds[1].material, "6");
    EXPECT_EQ(std::count_if(input->segments.begin(), input->segments.end(),
                            [](const InputSegment& s) { return s.name == "9"; }),
              1);
    for (std::size_t n = 0; n + 2 < whole.size(); ++n)
      ASSERT_FALSE(parse_msh(whole.substr(0, n), "dev.msh").has_value()) << n;
  }
  EXPECT_TRUE(parse_msh(binary22(), "dev.msh")->warnings.empty());
  EXPECT_EQ(parse_msh(binary41(), "dev.msh")->warnings.at(0),
            "curves and surfaces are in 1 further physical group: the first of each counts");
}

TEST(ReadMshPeriodic, IsNotTakenOverAndSaysSo) {
  for (const std::string_view whole : {kMesh22, kMesh41}) {
    ASSERT_TRUE(parse_msh(whole, "dev.msh")->warnings.empty());
    const std::string text =
        std::string(whole) + "$Periodic\n1\n1 5 4\n2\n5 4\n2 1\n$EndPeriodic\n";
    const Result<Input> input = parse_msh(text, "dev.msh");
    ASSERT_TRUE(input.has_value()) << input.error().message;
    EXPECT_EQ(input->segments.size(), 7u);
    EXPECT_TRUE(input->periodic.empty());
    ASSERT_EQ(input->warnings.size(), 1u);
    EXPECT_EQ(input->warnings[0],
              "which lines are images of each other ($Periodic) is not taken over: --periodic A=B "
              "says it, with names of lines");
  }
}

TEST(ReadMshErrors, OfEveryTruncationAreErrors) {
  for (const std::string_view whole : {kMesh22, kMesh41})
    for (std::size_t n = 0; n + 2 < whole.size(); ++n) {
      const Result<Input> input = parse_msh(whole.substr(0, n), "dev.msh");
      ASSERT_FALSE(input.has_value()) << n;
    }
}

TEST(ReadMshHigherOrder, TakesCornersAndSaysSo) {
  const Result<Input> input = parse_msh(R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
6
1 0 0 0
2 2 0 0
3 0 2 0
4 1 0 0
5 1 1 0
6 0 1 0
$EndNodes
$Elements
1
1 9 2 0 8 1 2 3 4 5 6
$EndElements
)",
                                        "dev.msh");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->points.size(), 3u);
  EXPECT_EQ(input->seeds[0].material, "surface_8");
  EXPECT_EQ(input->warnings.size(), 1u);
}

}  // namespace
}  // namespace cover
