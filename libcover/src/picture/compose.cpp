// Layout: a title line, the plot with a scale bar, a legend on the right. Edges are drawn thinner
// where they are short, so that finely meshed parts do not turn black; what is too small to be seen
// at the given size is left to the zoom window.
// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/compose.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/errors.hpp"
#include "base/numbers.hpp"
#include "geom/box.hpp"
#include "geom/topology/bent_edges.hpp"
#include "geom/vector.hpp"
#include "picture/parts/check_picture.hpp"
#include "picture/parts/labels.hpp"
#include "picture/parts/legend.hpp"
#include "picture/parts/mesh_lines.hpp"
#include "picture/parts/palette.hpp"
#include "picture/parts/shown_values.hpp"
#include "picture/parts/triangle_angles.hpp"

namespace cover {
namespace {

constexpr int kBendPieces = 8;  ///< straight ones, of a curved edge
constexpr double kTitle = 30;
constexpr double kFooter = 34;
constexpr Colour kMark{200, 0, 40};
constexpr double kRing = 8;  ///< radius of a mark with its line

Window window_around(std::span<const Point> points) {
  const Box box = box_of(points);
  return {box.low, box.high};
}

constexpr int kLeastWithKey = 400;  ///< pixels of width

std::string name_of(const std::map<std::int64_t, std::string>& names, std::int64_t id,
                    std::string_view kind) {
  const auto found = names.find(id);
  return found != names.end() ? found->second : fmt::format("{} {}", kind, id);
}

/// Builds the drawing item by item.
class Composer {
 public:
  Composer(const PictureMesh& mesh, const PictureOptions& options)
      : mesh_(mesh), soup_(mesh.mesh.soup), options_(options) {}

  Result<Drawing> run() {
    if (Status status = check_picture(mesh_); !status) return std::move(status).error();
    const Window window = options_.window ? *options_.window : window_of_all();
    if (!(window.low.x < window.high.x) || !(window.low.y < window.high.y)) {
      return bad_option("the window of the picture is empty");
    }
    if (!std::isfinite(window.high.x - window.low.x) ||
        !std::isfinite(window.high.y - window.low.y))
      return bad_option("the window of the picture is wider than the largest number");
    if (options_.width < 200 || options_.width > 20000) {
      return bad_option(
          fmt::format("the width of a picture is 200 to 20000 pixels, not {}", options_.width));
    }
    lay_out(window);
    bent_ = bent_edges(soup_, mesh_.mesh.middles);
    find_visible();
    if (options_.color.empty()) {
      fill_regions();
    } else if (Status filled = fill_values(); !filled) {
      return std::move(filled).error();
    }
    const MeshLines lines = lines_of(soup_);
    if (options_.edges) draw_edges(lines);
    draw_interfaces(lines);
    frame_and_scale();
    LabelPlacer placer(drawing_.plot);
    mark_worst(placer);
    label_contacts(placer);
    return std::move(drawing_);
  }

 private:
  [[nodiscard]] Point pixel(Point p) const {
    const double y = (p.y - window_.low.y) * scale_;
    return {drawing_.plot.x0 + (p.x - window_.low.x) * scale_,
            options_.y_down ? drawing_.plot.y0 + y : drawing_.plot.y1 - y};
  }
  [[nodiscard]] Point pixel(std::uint32_t v) const { return pixel(soup_.points[v]); }

  /// A narrow picture is all plot.
  [[nodiscard]] bool has_key() const { return options_.width >= kLeastWithKey; }

  void lay_out(Window window) {
    // A whole mesh gets a little air, a window is shown as asked for.
    if (!options_.window) {
      const double air =
          0.02 * std::max(window.high.x - window.low.x, window.high.y - window.low.y);
      window = {{window.low.x - air, window.low.y - air},
                {window.high.x + air, window.high.y + air}};
    }
    window_ = window;
    const double w = window.high.x - window.low.x, h = window.high.y - window.low.y;
    const double wide = options_.width - (has_key() ? 3 * kMargin + kKeyWidth : 2 * kMargin);
    const double top = options_.title.empty() ? kMargin : kMargin + kTitle;
    // Neither a tower nor a thread: the plot is at least 260 high and at most 1.3 times as high as
    // wide.
    const double high = std::clamp(wide * h / w, std::min(260.0, wide), 1.3 * wide);
    scale_ = std::min(wide / w, high / h);
    // What the shape leaves free of the box shows more of the plane.
    window_.low = {window.low.x - (wide / scale_ - w) / 2, window.low.y - (high / scale_ - h) / 2};
    window_.high = {window_.low.x + wide / scale_, window_.low.y + high / scale_};
    drawing_.width = options_.width;
    drawing_.height = static_cast<int>(std::lround(top + high + kFooter));
    drawing_.plot = {kMargin, top, kMargin + wide, top + high};
    if (!options_.title.empty()) {
      add(Label{
          options_.title, {kMargin, kMargin + 15}, 16, Label::Anchor::start, false, true, kInk});
    }
  }

  /// Nodes of curved edges may lie outside of all vertices.
  [[nodiscard]] Window window_of_all() const {
    std::vector<Point> points = soup_.points;
    for (const auto& nodes : mesh_.mesh.middles)
      points.insert(points.end(), nodes.begin(), nodes.end());
    return window_around(points);
  }

  /// The line of an edge, in pixels.
  void add_edge(std::uint32_t a, std::uint32_t b, std::vector<std::array<Point, 2>>& lines) const {
    const auto bent = bent_.find(std::minmax(a, b));
    const Point p = pixel(a), q = pixel(b);
    if (bent == bent_.end()) {
      if (shows(p, q)) lines.push_back({p, q});
      return;
    }
    const Point m = pixel(bent->second);
    Point before = p;
    for (int k = 1; k <= kBendPieces; ++k) {
      const double s = static_cast<double>(k) / kBendPieces;
      const Point at = bend(p, m, q, s);
      if (shows(before, at)) lines.push_back({before, at});
      before = at;
    }
  }

  /// The point at s, from 0 to 1, of the parabola from p to q over m at 1/2.
  static Point bend(Point p, Point m, Point q, double s) {
    const double of_p = (1 - s) * (1 - 2 * s), of_m = 4 * s * (1 - s), of_q = s * (2 * s - 1);
    return {of_p * p.x + of_m * m.x + of_q * q.x, of_p * p.y + of_m * m.y + of_q * q.y};
  }

  /// A triangle as what covers it; curved ones are many small ones.
  void add_triangle(std::size_t t, std::vector<std::array<Point, 3>>& triangles) const {
    const auto& v = soup_.triangles[t];
    const auto is_bent = [&](std::size_t i) {
      return bent_.count(std::minmax(v[i], v[(i + 1) % 3])) != 0;
    };
    if (bent_.empty() || !(is_bent(0) || is_bent(1) || is_bent(2))) {
      triangles.push_back(corners(t));
      return;
    }
    const auto [p, q, r] = corners(t);
    const auto& m = mesh_.mesh.middles[t];
    const std::array nodes{p, q, r, pixel(m[0]), pixel(m[1]), pixel(m[2])};
    const auto at = [&](int i, int j) {
      const double b = static_cast<double>(i) / kBendPieces,
                   c = static_cast<double>(j) / kBendPieces, a = 1 - b - c;
      const std::array shape{a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1),
                             4 * a * b,       4 * b * c,       4 * c * a};
      Point sum{0, 0};
      for (std::size_t k = 0; k < nodes.size(); ++k)
        sum = {sum.x + shape[k] * nodes[k].x, sum.y + shape[k] * nodes[k].y};
      return sum;
    };
    for (int i = 0; i < kBendPieces; ++i) {
      for (int j = 0; i + j < kBendPieces; ++j) {
        triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < kBendPieces)
          triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }

  void find_visible() {
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      Box box;
      for (const std::uint32_t v : soup_.triangles[t]) box.add(soup_.points[v]);
      if (!bent_.empty()) {
        for (const Point& m : mesh_.mesh.middles[t]) box.add(m);
      }
      if (box.low.x <= window_.high.x && box.high.x >= window_.low.x &&
          box.low.y <= window_.high.y && box.high.y >= window_.low.y) {
        visible_.push_back(t);
      }
    }
  }

  [[nodiscard]] std::array<Point, 3> corners(std::size_t t) const {
    const auto& [a, b, c] = soup_.triangles[t];
    return {pixel(a), pixel(b), pixel(c)};
  }

  [[nodiscard]] std::int64_t region(std::size_t t) const {
    return soup_.region.empty() ? 1 : soup_.region[t];
  }
  [[nodiscard]] std::int64_t material(std::size_t t) const {
    return soup_.material.empty() ? region(t) : soup_.material[t];
  }

  /// What a region is called in the legend. Regions of one text have one colour.
  [[nodiscard]] std::string legend_text(std::int64_t r, std::int64_t m) const {
    const std::string name = name_of(mesh_.region_names, r, "region");
    const std::string what = name_of(mesh_.material_names, m, "material");
    return name == what ? name : fmt::format("{} ({})", name, what);
  }

  void fill_regions() {
    std::map<std::int64_t, std::int64_t> material_of;
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) material_of[region(t)] = material(t);
    // Colours are given over the whole mesh, so that a zoom has those of the full picture.
    std::map<std::int64_t, std::size_t> rank;
    for (const auto& entry : material_of) rank.emplace(entry.second, 0);
    std::size_t next = 0;
    for (auto& entry : rank) entry.second = next++;
    std::map<std::int64_t, std::map<std::string, std::size_t>> variants;
    std::map<std::int64_t, PaintedPatch> patches;
    for (const std::size_t t : visible_) add_triangle(t, patches[region(t)].triangles);
    for (const auto& [r, m] : material_of) {
      auto& known = variants[m];
      const std::size_t variant = known.emplace(legend_text(r, m), known.size()).first->second;
      if (!patches.contains(r)) continue;
      PaintedPatch& patch = patches[r];
      patch.colour = shade(material_colour(rank[m]), variant);
      legend_.add(patch.colour, legend_text(r, m), name_of(mesh_.material_names, m, "material"));
      add(std::move(patch));
    }
    if (has_key()) draw_legend(legend_, drawing_);
  }

  Status fill_values() {
    const Result<std::vector<double>> values = shown_values(mesh_, options_.color);
    if (!values) return values.error();
    double low = kInfinity, high = -low;
    for (const std::size_t t : visible_) {
      if (!std::isfinite((*values)[t])) continue;
      low = std::min(low, (*values)[t]);
      high = std::max(high, (*values)[t]);
    }
    if (options_.range) std::tie(low, high) = std::tie((*options_.range)[0], (*options_.range)[1]);
    if (!(low <= high)) return bad_option("the range of values is empty");
    if (!std::isfinite(low) || !std::isfinite(high))
      return bad_option("the range of values has no end");
    constexpr int kSteps = 64;
    std::vector<PaintedPatch> patches(kSteps);
    for (int i = 0; i < kSteps; ++i) {
      patches[static_cast<std::size_t>(i)].colour = value_colour(i / (kSteps - 1.0));
    }
    PaintedPatch without{kNoValueColour, true, {}};
    for (const std::size_t t : visible_) {
      const double value = (*values)[t];
      if (std::isnan(value)) {
        add_triangle(t, without.triangles);
        continue;
      }
      const double part = part_of(value, low, high);
      add_triangle(t,
                   patches[static_cast<std::size_t>(std::lround(part * (kSteps - 1)))].triangles);
    }
    for (PaintedPatch& patch : patches) {
      if (!patch.triangles.empty()) add(std::move(patch));
    }
    const bool has_gaps = !without.triangles.empty();
    if (has_gaps) add(std::move(without));
    if (has_key()) draw_colour_bar(options_.color, low, high, has_gaps, drawing_);
    return ok();
  }

  void draw_edges(const MeshLines& lines) {
    // Widths in a few classes, so that each class is one item.
    constexpr std::array kWidths{0.05, 0.1, 0.2, 0.35, 0.5, 0.7};
    std::array<Stroke, kWidths.size()> strokes;
    for (std::size_t i = 0; i < kWidths.size(); ++i) {
      strokes[i] = {{60, 60, 60}, kWidths[i], 0.75, true, {}};
    }
    for (const auto& [a, b] : lines.inner) {
      const double width = 0.04 * length(pixel(b) - pixel(a));
      std::size_t i = 0;
      while (i + 1 < kWidths.size() && kWidths[i + 1] <= width) ++i;
      add_edge(a, b, strokes[i].lines);
    }
    for (Stroke& stroke : strokes) {
      if (!stroke.lines.empty()) add(std::move(stroke));
    }
  }

  [[nodiscard]] bool shows(Point p, Point q) const {
    const PixelBox& box = drawing_.plot;
    return std::max(p.x, q.x) >= box.x0 && std::min(p.x, q.x) <= box.x1 &&
           std::max(p.y, q.y) >= box.y0 && std::min(p.y, q.y) <= box.y1;
  }

  void draw_interfaces(const MeshLines& lines) {
    Stroke strong{kInk, 1.6, 1, true, {}};
    const auto draw = [&](const std::vector<std::array<std::uint32_t, 2>>& edges, Stroke& stroke) {
      for (const auto& [a, b] : edges) add_edge(a, b, stroke.lines);
    };
    draw(lines.borders, strong);
    for (const PictureLine& line : mesh_.lines) {
      if (!line.contact) draw(line.edges, strong);
    }
    add(std::move(strong));
    std::map<std::string, Stroke> contacts;
    for (const PictureLine& line : mesh_.lines) {
      if (!line.contact) continue;
      const auto [at, is_new] = contacts.try_emplace(line.name);
      if (is_new) at->second = {contact_colour(contacts.size() - 1), 4.5, 1, true, {}};
      draw(line.edges, at->second);
    }
    for (auto& [name, stroke] : contacts) {
      if (stroke.lines.empty()) continue;
      contact_marks_.push_back({name, stroke.colour, middle(stroke.lines)});
      add(std::move(stroke));
    }
    mark_partners();
  }

  /// A small ring around each vertex that has a partner on a periodic side; further rules have
  /// larger ones.
  void mark_partners() {
    constexpr double kSmallest = 4, kStep = 3, kLine = 1.5;
    double radius = kSmallest;
    for (const std::vector<std::uint32_t>& vertices : mesh_.periodic) {
      for (const std::uint32_t v : vertices) {
        if (shows(pixel(v), pixel(v))) add(Ring{kInk, pixel(v), radius, kLine});
      }
      radius += kStep;
    }
  }

  /// The middle of the line in the middle of those that are in sight.
  static Point middle(const std::vector<std::array<Point, 2>>& lines) {
    const auto& [p, q] = lines[lines.size() / 2];
    return midpoint(p, q);
  }

  /// A coordinate to a thousandth of the window.
  [[nodiscard]] std::string place(double x) const {
    const double extent = std::max(window_.high.x - window_.low.x, window_.high.y - window_.low.y);
    const double largest = std::max(std::abs(x), extent);
    const int digits = static_cast<int>(std::ceil(std::log10(largest / extent)));
    return fmt::format("{:.{}g}", x, std::clamp(digits + 4, 4, 17));
  }

  void frame_and_scale() {
    const PixelBox& box = drawing_.plot;
    Stroke frame{{170, 170, 170}, 1, 1, false, {}};
    add_outline(box, frame);
    add(std::move(frame));
    const double length = round_number((box.x1 - box.x0) / scale_ / 4);
    const double x = box.x0, y = box.y1 + 20, end = x + length * scale_;
    add(Stroke{kInk,
               2,
               1,
               false,
               {{Point{x, y}, Point{end, y}},
                {Point{x, y - 5}, Point{x, y + 5}},
                {Point{end, y - 5}, Point{end, y + 5}}}});
    add(Label{fmt::format("{:g}{}{}", length, mesh_.unit.empty() ? "" : " ", mesh_.unit),
              {end + 8, y + 5},
              kText});
    add(Label{fmt::format("x {} to {}, y {} to {}", place(window_.low.x), place(window_.high.x),
                          place(window_.low.y), place(window_.high.y)),
              {box.x1, y + 5},
              12,
              Label::Anchor::end,
              false,
              false,
              {110, 110, 110}});
  }

  void mark_worst(LabelPlacer& placer) {
    std::vector<std::pair<double, std::size_t>> angles;
    for (const std::size_t t : visible_) angles.emplace_back(largest_angle(soup_, t), t);
    const auto count =
        std::min(angles.size(), static_cast<std::size_t>(std::max(0, options_.worst)));
    std::partial_sort(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(count),
                      angles.end(), [](const auto& a, const auto& b) {
                        return a.first != b.first ? a.first > b.first : a.second < b.second;
                      });
    std::vector<Point> centres;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [p, q, r] = corners(angles[i].second);
      // A triangle that is seen in part may have its middle outside.
      const PixelBox& box = drawing_.plot;
      const Point centre{std::clamp((p.x + q.x + r.x) / 3, box.x0 + kRing, box.x1 - kRing),
                         std::clamp((p.y + q.y + r.y) / 3, box.y0 + kRing, box.y1 - kRing)};
      centres.push_back(centre);
      add(Ring{kMark, centre, kRing - 1, 2});
      placer.block({centre.x - 8, centre.y - 8, centre.x + 8, centre.y + 8});
    }
    for (std::size_t i = 0; i < count; ++i) {
      Label label{fmt::format("{:.1f}°", angles[i].first),
                  {},
                  13,
                  Label::Anchor::middle,
                  true,
                  true,
                  kMark};
      if (placer.place(label, centres[i])) add(std::move(label));
    }
  }

  void label_contacts(LabelPlacer& placer) {
    for (const ContactMark& mark : contact_marks_) {
      Label label{mark.name, {}, kText, Label::Anchor::middle, true, true, mark.colour};
      if (placer.place(label, mark.at)) add(std::move(label));
    }
  }

  void add(DrawingItem item) { drawing_.items.push_back(std::move(item)); }

  struct ContactMark {
    std::string name;
    Colour colour;
    Point at;
  };

  const PictureMesh& mesh_;
  const TriangleSoup& soup_;
  const PictureOptions& options_;
  Drawing drawing_;
  Window window_;
  double scale_ = 1;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Point>
      bent_;  ///< nodes, by lower and upper end
  std::vector<std::size_t> visible_;
  Legend legend_;
  std::vector<ContactMark> contact_marks_;
};

}  // namespace

Result<Drawing> compose(const PictureMesh& mesh, const PictureOptions& options) {
  return Composer(mesh, options).run();
}

}  // namespace cover
