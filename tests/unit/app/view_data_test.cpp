// What a page gets to know of a mesh, decoded again.
#include "page/view_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"

namespace cover::app {
namespace {

using Json = nlohmann::json;

std::vector<std::uint32_t> unpacked(const std::string& text, std::size_t width) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned> bytes;
  for (std::size_t i = 0; i < text.size(); i += 4) {
    unsigned block = 0, padding = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      padding += text[i + k] == '=' ? 1 : 0;
      block = block << 6U | (text[i + k] == '=' ? 0U : unsigned(digits.find(text[i + k])));
    }
    for (unsigned k = 0; k + padding < 3; ++k) bytes.push_back(block >> (16 - 8 * k) & 255U);
  }
  std::vector<std::uint32_t> out(bytes.size() / width);
  for (std::size_t k = 0; k < out.size(); ++k)
    for (std::size_t b = 0; b < width; ++b) out[k] |= bytes[width * k + b] << (8 * b);
  return out;
}

TEST(ViewData, HoldsTheMesh) {
  Input input = testing::checker(6, 8, 5);
  input.segments[0].name = "gate";
  const Result<Output> output = cover_mesh(input);
  ASSERT_TRUE(output);
  const Json data = Json::parse(view_data(*output, 1000000));
  const TriangleSoup soup = triangle_soup(output->mesh);
  const std::size_t n = soup.triangles.size(), width = data["indexBytes"];
  EXPECT_EQ(data["all"], n);
  const auto points = unpacked(data["points"], 4), corners = unpacked(data["corners"], width),
             lines = unpacked(data["lines"], width), angles = unpacked(data["angles"], 3);
  ASSERT_EQ(corners.size(), 3 * n);
  ASSERT_EQ(angles.size(), 2 * n);
  const double step = data["step"], low_x = data["low"][0], low_y = data["low"][1];
  double largest = 0;
  for (std::size_t t = 0; t < n; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point at = soup.points[soup.triangles[t][k]];
      EXPECT_NEAR(low_x + step * points[2 * corners[3 * t + k]], at.x, step);
      EXPECT_NEAR(low_y + step * points[2 * corners[3 * t + k] + 1], at.y, step);
    }
    largest = std::max(largest, angles[2 * t] * 180 / 16777215.0);
  }
  EXPECT_NEAR(largest, output->report.quality.largest_nu.supplement().in_degrees(), 2e-5);
  std::size_t counted = 0;
  for (const Json& count : data["counts"]) counted += count.get<std::size_t>();
  EXPECT_EQ(counted, n);
  EXPECT_EQ(lines.size(), 2 * output->pslg.segments.size());
  ASSERT_EQ(data["contacts"].size(), 1U);
  EXPECT_EQ(data["contacts"][0][0], "gate");
  EXPECT_EQ(data["plainLines"].get<std::size_t>() + data["contacts"][0][1].get<std::size_t>(),
            output->pslg.segments.size());
  const std::size_t bytes =
      data["points"].get<std::string>().size() + data["corners"].get<std::string>().size() +
      data["lines"].get<std::string>().size() + data["angles"].get<std::string>().size();
  EXPECT_LT(bytes, 40 * n);
  // The worst triangle of each region is one of the region's, and the worst.
  std::size_t first = 0;
  for (std::size_t r = 0; r < data["regions"].size(); ++r) {
    const std::size_t worst = data["regions"][r][6], count = data["counts"][r];
    ASSERT_GE(worst, first);
    ASSERT_LT(worst, first + count);
    for (std::size_t t = first; t < first + count; ++t) EXPECT_LE(angles[2 * t], angles[2 * worst]);
    first += count;
  }
}

TEST(ViewData, OfLargeMeshesWhatIsNearTheWorst) {
  const Result<Output> output = cover_mesh(testing::checker(6, 8, 5));
  ASSERT_TRUE(output);
  const Json data = Json::parse(view_data(*output, 50));
  EXPECT_EQ(unpacked(data["corners"], data["indexBytes"]).size(), 3U * 50U);
  EXPECT_EQ(data["all"], triangle_soup(output->mesh).triangles.size());
  EXPECT_EQ(unpacked(data["lines"], data["indexBytes"]).size(), 2 * output->pslg.segments.size());
  double largest = 0;
  for (const std::uint32_t angle : unpacked(data["angles"], 3))
    largest = std::max(largest, angle * 180 / 16777215.0);
  EXPECT_NEAR(largest, output->report.quality.largest_nu.supplement().in_degrees(), 2e-5);
}

TEST(ViewData, EndsNoElement) {
  Result<Output> output = cover_mesh(testing::checker(2, 2, 5));
  ASSERT_TRUE(output);
  output->table.regions[0].name = "</script><!-- \xff";
  const std::string text = view_data(*output, 1000);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(text)["regions"][0][0], "</script><!-- \xef\xbf\xbd");
}

}  // namespace
}  // namespace cover::app
