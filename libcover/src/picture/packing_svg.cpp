// Layers from back to front: the gaps, coloured by kind over the whole polygon of their centres;
// the disks, which leave of that just the gap itself; triangles; the boundary; a legend with
// counts. Lines get thinner with what they bound, so that the smallest disks do not drown in ink.
// Tested by tests/unit/picture/packing_svg_test.cpp.
#include <fmt/core.h>

#include <algorithm>

#include <cover/packing.hpp>

#include "base/numbers.hpp"
#include "geom/box.hpp"
#include "io/files/atomic_file.hpp"

namespace cover {
namespace {

struct KindStyle {
  const char* colour;
  const char* name;
};
constexpr std::array<KindStyle, kGapKinds> kStyles{{
    {"#f4b942", "three disks"},
    {"#f9dd94", "two disks, a line"},
    {"#8fd0b9", "good"},
    {"#6fa8dc", "cut"},
    {"#b08fd8", "reflex"},
    {"#d9b3e6", "reflex, overlapping"},
    {"#f29a8e", "two lines"},
    {"#b0bec5", "touching"},
    {"#d50000", "cell"},
}};

const char* colour_of(PackingRecord::Purpose purpose) {
  switch (purpose) {
    case PackingRecord::Purpose::corner:
      return "#263a4a";
    case PackingRecord::Purpose::connection:
      return "#d1495b";
    case PackingRecord::Purpose::reduction:
      return "#7b8f9c";
  }
  return "";
}

class PackingSvg {
 public:
  PackingSvg(const std::vector<PackingRecord>& packings, PackingStage stage, int width)
      : packings_(packings), stage_(stage), width_(width) {
    find_frame();
  }

  std::string text() {
    const double legend = stage_ == PackingStage::triangles ? 0 : kLegend;
    put(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1:.0f}" )"
        R"(viewBox="0 0 {0} {1:.0f}" font-family="Helvetica, Arial, sans-serif">)"
        "\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        width_, height_ + legend);
    if (stage_ == PackingStage::gaps) draw_gaps();
    if (stage_ == PackingStage::triangles) {
      draw_triangles();
    } else {
      draw_disks();
    }
    draw_outline();
    if (stage_ == PackingStage::gaps) draw_gap_legend();
    if (stage_ == PackingStage::disks) draw_disk_legend();
    out_ += "</svg>\n";
    return std::move(out_);
  }

 private:
  static constexpr double kMargin = 24;
  static constexpr double kLegend = 64;

  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    out_ += fmt::format(format, std::forward<Args>(args)...);
  }

  void find_frame() {
    Box box;
    for (const PackingRecord& packing : packings_) {
      for (const auto& line : packing.outline) {
        for (const Point p : line) box.add(p);
      }
    }
    if (!(box.width() > 0 && box.height() > 0)) box = {{0, 0}, {1, 1}};
    low_ = box.low;
    scale_ = (width_ - 2 * kMargin) / box.width();
    height_ = box.height() * scale_ + 2 * kMargin;
  }

  [[nodiscard]] Point pixel(Point p) const {
    return {kMargin + (p.x - low_.x) * scale_, height_ - kMargin - (p.y - low_.y) * scale_};
  }

  template <class Points>
  void put_path(const Points& points, bool closed) {
    const char* command = "M";
    for (const Point p : points) {
      const Point q = pixel(p);
      put("{}{:.2f} {:.2f}", command, q.x, q.y);
      command = "L";
    }
    if (closed) out_ += "z";
  }

  void draw_gaps() {
    for (std::size_t kind = 0; kind < kGapKinds; ++kind) {
      // A hair of its own colour closes the seams between neighbours.
      put("<path fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.4\" d=\"", kStyles[kind].colour);
      for (const PackingRecord& packing : packings_) {
        for (const auto& gap : packing.gaps) {
          if (static_cast<std::size_t>(gap.kind) == kind) put_path(gap.polygon, true);
        }
      }
      out_ += "\"/>\n";
    }
  }

  void draw_disks() {
    for (const PackingRecord& packing : packings_) {
      for (const auto& disk : packing.disks) {
        if (stage_ == PackingStage::disks && disk.purpose == PackingRecord::Purpose::reduction) {
          continue;
        }
        const Point c = pixel(disk.centre);
        const double r = disk.radius * scale_;
        if (r < 0.02) continue;
        put("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.3f}\" fill=\"#ffffff\" stroke=\"{}\" "
            "stroke-width=\"{:.3f}\"/>\n",
            c.x, c.y, r, colour_of(disk.purpose), std::clamp(0.08 * r, 0.02, 1.3));
      }
    }
  }

  void draw_triangles() {
    // Three classes of line width by the size of the triangle.
    constexpr std::array<double, 3> kLongest{6, 24, kInfinity};
    constexpr std::array<double, 3> kWidth{0.12, 0.35, 0.7};
    double above = 0;
    for (std::size_t k = 0; k < kLongest.size(); ++k) {
      put("<path fill=\"#eaf3f1\" stroke=\"#2f5d62\" stroke-width=\"{}\" "
          "stroke-linejoin=\"round\" d=\"",
          kWidth[k]);
      for (const PackingRecord& packing : packings_) {
        for (const auto& t : packing.triangles) {
          const double size =
              scale_ * std::max(std::abs(t[0].x - t[1].x) + std::abs(t[0].y - t[1].y),
                                std::abs(t[0].x - t[2].x) + std::abs(t[0].y - t[2].y));
          if (size >= above && size < kLongest[k]) put_path(t, true);
        }
      }
      out_ += "\"/>\n";
      above = kLongest[k];
    }
  }

  void draw_outline() {
    out_ +=
        "<path fill=\"none\" stroke=\"#101820\" stroke-width=\"2\" stroke-linecap=\"round\" d=\"";
    for (const PackingRecord& packing : packings_) {
      for (const auto& line : packing.outline) put_path(line, false);
    }
    out_ += "\"/>\n";
  }

  void draw_gap_legend() {
    std::array<std::size_t, kGapKinds> counts{};
    std::size_t shown = 0;
    for (const PackingRecord& packing : packings_) {
      for (std::size_t k = 0; k < kGapKinds; ++k) counts[k] += packing.kinds[k];
    }
    for (const std::size_t n : counts) shown += n > 0 ? 1 : 0;
    const double step =
        (width_ - 2 * kMargin) / static_cast<double>(std::max<std::size_t>(shown, 1));
    double x = kMargin;
    for (std::size_t k = 0; k < kGapKinds; ++k) {
      if (counts[k] == 0) continue;
      put("<rect x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"18\" height=\"18\" rx=\"3\" fill=\"{2}\"/>"
          "<text x=\"{3:.1f}\" y=\"{4:.1f}\" font-size=\"14\" fill=\"#101820\">{5}</text>"
          "<text x=\"{3:.1f}\" y=\"{6:.1f}\" font-size=\"12\" fill=\"#5b6b75\">{7}</text>\n",
          x, height_ + 8, kStyles[k].colour, x + 25, height_ + 20, kStyles[k].name, height_ + 38,
          counts[k]);
      x += step;
    }
  }

  void draw_disk_legend() {
    constexpr std::array<PackingRecord::Purpose, 2> kPurposes{PackingRecord::Purpose::corner,
                                                              PackingRecord::Purpose::connection};
    constexpr std::array<const char*, 2> kNames{"in corners or on the boundary", "between holes"};
    for (std::size_t k = 0; k < 2; ++k) {
      put("<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"9\" fill=\"#ffffff\" stroke=\"{2}\" "
          "stroke-width=\"1.5\"/><text x=\"{3:.1f}\" y=\"{4:.1f}\" font-size=\"14\" "
          "fill=\"#101820\">{5}</text>\n",
          kMargin + 10 + 300.0 * static_cast<double>(k), height_ + 17, colour_of(kPurposes[k]),
          kMargin + 28 + 300.0 * static_cast<double>(k), height_ + 22, kNames[k]);
    }
  }

  const std::vector<PackingRecord>& packings_;
  PackingStage stage_;
  int width_;
  std::string out_;
  Point low_;
  double scale_ = 1;
  double height_ = 0;
};

}  // namespace

Status write_packing_svg(const std::vector<PackingRecord>& packings, PackingStage stage, int width,
                         const std::string& path) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return std::move(file).error();
  file->write(PackingSvg(packings, stage, width).text());
  return file->commit();
}

}  // namespace cover
