// Coordinates are whole numbers of 32 bits: the page sees 1/4,294,967,295 of the drawing's size.
// Angles come with the triangles, from the coordinates as they are: those of triangles too small
// for this are right, too. Tested by tests/unit/app/view_data_test.cpp.
#include "page/view_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <nlohmann/json.hpp>

#include <cover/mesh_view.hpp>

#include "page/base64_text.hpp"
#include "words/angle_text.hpp"

namespace cover::app {
namespace {

using Json = nlohmann::ordered_json;

/// Of an angle: with two, its steps of 0.003 degrees were seen beside the table's two places.
constexpr std::size_t kAngleBytes = 3;

/// Whole numbers without a sign, of so many bytes each, the lowest byte first, in base64.
std::string packed(const std::vector<std::uint32_t>& numbers, std::size_t width) {
  std::string bytes;
  bytes.reserve(width * numbers.size());
  for (const std::uint32_t number : numbers)
    for (std::size_t k = 0; k < width; ++k) bytes += static_cast<char>(number >> (8 * k) & 0xffU);
  return base64_text(bytes);
}

/// The largest and the smallest angle of a triangle, in degrees.
std::array<double, 2> extreme_angles_of(const MeshView& view, std::size_t t) {
  const std::array<Angle, 3> angles = angles_of(view, t);
  const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
  return {high->in_degrees(), low->in_degrees()};
}

class ViewData {
 public:
  ViewData(const Output& output, std::size_t most)
      : output_(output), view_(view_of(output, {})), most_(most) {}

  std::string text() {
    measure();
    choose();
    order_lines();
    number_points();
    Json json;
    frame(json);
    const std::size_t width = point_.size() <= 0x10000 ? 2 : point_.size() <= 0x1000000 ? 3 : 4;
    json["indexBytes"] = width;
    json["corners"] = packed(corners(), width);
    json["lines"] = packed(ends(), width);
    json["angles"] = packed(angles(), kAngleBytes);
    json["plainLines"] = plain_lines_;
    json["contacts"] = contacts_;
    json["counts"] = counts_;
    json["all"] = view_.triangles.size();
    json["regions"] = regions();
    std::string out = json.dump(-1, ' ', true, Json::error_handler_t::replace);
    // Nothing in it may end the element that it stands in, or begin another.
    for (std::size_t at = out.find('<'); at != out.npos; at = out.find('<', at))
      out.replace(at, 1, "\\u003c");
    return out;
  }

 private:
  void measure() {
    for (std::size_t t = 0; t < view_.triangles.size(); ++t)
      angle_.push_back(extreme_angles_of(view_, t));
    worst_ =
        static_cast<std::size_t>(std::max_element(angle_.begin(), angle_.end()) - angle_.begin());
  }

  /// The triangles that are shown, by region.
  void choose() {
    chosen_.resize(view_.triangles.size());
    std::iota(chosen_.begin(), chosen_.end(), std::size_t{0});
    if (chosen_.size() > most_) {
      const auto corner = [&](std::size_t t) { return view_.points[view_.triangles[t][0]]; };
      const Point centre = corner(worst_);
      const auto far = [&](std::size_t t) {
        const Point p = corner(t);
        return std::max(std::abs(p.x - centre.x), std::abs(p.y - centre.y));
      };
      std::nth_element(chosen_.begin(), chosen_.begin() + static_cast<std::ptrdiff_t>(most_),
                       chosen_.end(),
                       [&](std::size_t a, std::size_t b) { return far(a) < far(b); });
      chosen_.resize(most_);
      std::sort(chosen_.begin(), chosen_.end());
    }
    std::stable_sort(chosen_.begin(), chosen_.end(), [&](std::size_t a, std::size_t b) {
      return view_.region[a] < view_.region[b];
    });
    counts_.assign(output_.table.regions.size(), 0);
    for (const std::size_t t : chosen_) ++counts_[place_of(view_.region[t])];
  }

  /// Lines of contacts and markers last, name by name.
  void order_lines() {
    std::vector<std::vector<std::size_t>> groups(view_.line_groups.size());
    for (std::size_t l = 0; l < view_.lines.size(); ++l) groups[view_.line_group[l]].push_back(l);
    for (const bool named : {false, true}) {
      for (std::size_t g = 0; g < groups.size(); ++g) {
        if (groups[g].empty() || is_named(groups[g].front()) != named) continue;
        lines_.insert(lines_.end(), groups[g].begin(), groups[g].end());
        if (named) contacts_.push_back(Json::array({view_.line_groups[g].label, groups[g].size()}));
      }
      if (!named) plain_lines_ = lines_.size();
    }
  }
  [[nodiscard]] bool is_named(std::size_t line) const {
    const InterfaceId id = view_.interface[line];
    return view_.marker[line] != 0 ||
           (id != kNoInterface && output_.table.interface(id).kind == InterfaceKind::contact);
  }

  void number_points() {
    number_.assign(view_.points.size(), kUnused);
    const auto use = [&](std::uint32_t node) {
      if (number_[node] != kUnused) return;
      number_[node] = static_cast<std::uint32_t>(point_.size());
      point_.push_back(view_.points[node]);
    };
    for (const std::size_t t : chosen_)
      for (const std::uint32_t node : view_.triangles[t]) use(node);
    for (const std::size_t l : lines_)
      for (const std::uint32_t node : view_.lines[l]) use(node);
  }

  /// Where the whole numbers of the points are in the plane, and these numbers.
  void frame(Json& json) const {
    Point low = view_.points[0], high = low;
    for (const Point& p : view_.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    constexpr double kSteps = std::numeric_limits<std::uint32_t>::max();
    const double step =
        std::max(high.x / kSteps - low.x / kSteps, high.y / kSteps - low.y / kSteps);
    const auto steps = [&](double x, double from) {
      return static_cast<std::uint32_t>(
          std::clamp(std::round(x / step - from / step), 0.0, kSteps));
    };
    std::vector<std::uint32_t> numbers;
    for (const Point& p : point_) {
      numbers.push_back(steps(p.x, low.x));
      numbers.push_back(steps(p.y, low.y));
    }
    json["low"] = {low.x, low.y};
    json["step"] = step;
    json["extent"] = {steps(high.x, low.x), steps(high.y, low.y)};
    json["unit"] = output_.report.unit;
    json["points"] = packed(numbers, 4);
  }

  [[nodiscard]] std::vector<std::uint32_t> corners() const {
    std::vector<std::uint32_t> out;
    for (const std::size_t t : chosen_)
      for (const std::uint32_t node : view_.triangles[t]) out.push_back(number_[node]);
    return out;
  }
  [[nodiscard]] std::vector<std::uint32_t> ends() const {
    std::vector<std::uint32_t> out;
    for (const std::size_t l : lines_)
      for (const std::uint32_t node : view_.lines[l]) out.push_back(number_[node]);
    return out;
  }
  [[nodiscard]] std::vector<std::uint32_t> angles() const {
    constexpr double kFull = ((1U << (8 * kAngleBytes)) - 1) / 180.0;
    std::vector<std::uint32_t> out;
    for (const std::size_t t : chosen_)
      for (const double degrees : angle_[t])
        out.push_back(static_cast<std::uint32_t>(std::lround(degrees * kFull)));
    return out;
  }

  /// Name, material, largest angle, the least that it can be, smallest angle, rho, and the number
  /// of its worst triangle among those shown.
  [[nodiscard]] Json regions() const {
    Json rows = Json::array();
    std::size_t first = 0;
    for (std::size_t r = 0; r < counts_.size(); ++r) {
      const RegionReport& report = output_.report.regions[r];
      std::ptrdiff_t worst = counts_[r] == 0 ? -1 : static_cast<std::ptrdiff_t>(first);
      for (std::size_t k = first; k < first + counts_[r]; ++k)
        if (angle_[chosen_[k]] > angle_[chosen_[static_cast<std::size_t>(worst)]])
          worst = static_cast<std::ptrdiff_t>(k);
      first += counts_[r];
      const Region& region = output_.table.regions[r];
      const auto rounded = [](Angle angle) { return std::round(angle.in_degrees() * 1e4) / 1e4; };
      rows.push_back({region.name, region.material_name,
                      rounded(report.quality.largest_nu.supplement()),
                      rounded(report.lowest_nu().supplement()), rounded(report.quality.smallest),
                      std::round(report.rho() * 1e4) / 1e4, worst});
    }
    return rows;
  }

  static constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

  const Output& output_;
  MeshView view_;
  std::size_t most_;
  std::vector<std::array<double, 2>> angle_;  ///< by triangle
  std::size_t worst_ = 0;
  std::vector<std::size_t> chosen_;
  std::vector<std::size_t> counts_;  ///< of the chosen, by region
  std::vector<std::size_t> lines_;
  std::size_t plain_lines_ = 0;
  Json contacts_ = Json::array();
  std::vector<std::uint32_t> number_;  ///< by node, in the page
  std::vector<Point> point_;           ///< by number
};

}  // namespace

std::string view_data(const Output& output, std::size_t most) {
  return ViewData(output, most).text();
}

}  // namespace cover::app
