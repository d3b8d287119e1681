// The page is read from the top: first whether the mesh can be trusted, then the figures and the
// mesh itself that say why, then every region. Without scripts there is a picture: of large meshes
// as PNG, since a browser is slow with a hundred thousand paths.
#include "page/html_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/curved_mesh.hpp>
#include <cover/files.hpp>
#include <cover/picture.hpp>
#include <cover/text.hpp>
#include <cover/version.hpp>

#include "files/temporary_folder.hpp"
#include "page/base64_text.hpp"
#include "page/view_data.hpp"
#include "page_files.hpp"
#include "png/draw_png.hpp"
#include "terminal/console.hpp"
#include "words/angle_text.hpp"
#include "words/limits_text.hpp"
#include "words/verdict.hpp"

namespace cover::app {
namespace {

std::string card(std::string_view value, std::string_view what) {
  return fmt::format("<div class=\"card\"><b>{}</b><span>{}</span></div>\n", value, what);
}

std::string percent(double part, double whole) {
  return fmt::format("{:.1f} %", whole > 0 ? 100 * part / whole : 0);
}

/// Where targets are missed: the messages name segments by numbers that only programs know.
std::string places(const Note& note) {
  constexpr std::size_t kPlaces = 3;
  if (note.kind != Note::Kind::target_missed || note.where.empty()) return {};
  std::string text;
  for (std::size_t k = 0; k < std::min(kPlaces, note.where.size()); ++k)
    text += fmt::format("{} ({}, {})", k == 0 ? "; near" : ",", note.where[k].x, note.where[k].y);
  return text + (note.where.size() > kPlaces ? ", ..." : "");
}

constexpr std::size_t kLargeMesh = 2000;  ///< triangles, beyond which pictures of all are no SVG

/// One page.
class Page {
 public:
  Page(const Output& output, int order) : output_(output), report_(output.report), order_(order) {}

  Result<std::string> html(const std::string& title) {
    out_ = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n"
        "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n"
        "<p class=\"origin\">{2}</p>\n",
        escaped_markup(title), kPageStyle, escaped_markup(origin()));
    verdict();
    key_figures();
    out_ += "<h2>The mesh</h2>\n<div class=\"panel view\" id=\"mesh-view\">\n<noscript>\n";
    if (Status drawn = picture(); !drawn) return std::move(drawn).error();
    out_ += "</noscript>\n</div>\n";
    if (Status drawn = close_ups(); !drawn) return std::move(drawn).error();
    regions();
    out_ += "<div class=\"two\">\n";
    histogram();
    box_method();
    out_ += "</div>\n";
    notes();
    times();
    out_ += fmt::format(
        "<footer>cover {}; angles in degrees, lengths in units of the input.</footer>\n"
        "</main>\n",
        COVER_VERSION);
    view();
    out_ += "</body>\n</html>\n";
    return std::move(out_);
  }

 private:
  void verdict() {
    using Grade = Finding::Grade;
    struct Look {
      const char* style;
      const char* mark;
    };
    const auto look = [](Grade grade) -> Look {
      switch (grade) {
        case Grade::good:
          return {"good", "\u2713"};
        case Grade::caution:
          return {"caution", "!"};
        case Grade::bad:
          return {"bad", "\u2717"};
        case Grade::fact:
          break;
      }
      return {"fact", "i"};
    };
    const std::vector<Finding> findings = findings_of(output_);
    const Grade grade = verdict_of(findings);
    out_ += fmt::format("<div class=\"verdict {}\"><h2>{}</h2>\n<table>\n", look(grade).style,
                        grade == Grade::good      ? "A good mesh: promises kept, targets reached"
                        : grade == Grade::caution ? "Promises kept; look at what is marked"
                                                  : "Do not use: a promise is broken");
    for (const Finding& finding : findings) {
      out_ += fmt::format(
          "<tr class=\"{}\"><td class=\"mark\">{}</td><td class=\"t\">{}</td><td "
          "class=\"t\">{}</td></tr>\n",
          look(finding.grade).style, look(finding.grade).mark, finding.what,
          escaped_markup(finding.text));
    }
    out_ += "</table>\n</div>\n";
  }

  /// Where the mesh comes from, in one line.
  [[nodiscard]] std::string origin() const {
    const Provenance& from = report_.provenance;
    std::string text = from.source.empty() ? "" : from.source + "; ";
    for (const Provenance::Setting& setting : from.settings)
      text += fmt::format("{} {}, ", setting.name, setting.value);
    if (!report_.unit.empty()) text += fmt::format("coordinates in {}, ", report_.unit);
    return fmt::format("{}cover {}", text, COVER_VERSION);
  }

  void key_figures() {
    const Quality& q = report_.quality;
    std::size_t forced = 0;
    double rho = std::numeric_limits<double>::infinity();
    LimitCounts limits;
    for (const RegionReport& region : report_.regions) {
      forced += region.forced_above_120;
      rho = std::min(rho, region.rho());
      limits.add(region.limits);
    }
    out_ += "<div class=\"cards\">\n" + card(angle_text(q.largest_nu) + "°", "largest angle") +
            card(small_angle_text(q.smallest) + "°", "smallest angle") +
            card(fmt::format("{:.2f}", rho), "lowest rho (1: optimum)") +
            card(grouped(q.above_120), fmt::format("above 120° ({} forced)", grouped(forced))) +
            card(percent(static_cast<double>(q.obtuse), static_cast<double>(q.triangles)),
                 "obtuse triangles") +
            card(grouped(q.triangles), "triangles") +
            card(grouped(output_.mesh.vertices()),
                 fmt::format("vertices ({} new)",
                             grouped(report_.steiner_vertices + output_.pslg.points.size() -
                                     report_.input_points))) +
            card(grouped(report_.regions.size()), "regions") + "</div>\n";
    if (const std::string text = limits_text(limits); !text.empty())
      out_ += fmt::format("<p>Regions beside their targets and proven limits: {}.</p>\n", text);
  }

  /// For who has no scripts.
  Status picture() {
    const PictureMesh mesh = picture_of(output_, order_);
    if (report_.quality.triangles <= kLargeMesh) {
      Result<std::string> svg = svg_text(mesh, {});
      if (!svg) return std::move(svg).error();
      out_ += *svg;
    } else {
      const auto folder = temporary_folder("cover-picture");
      if (!folder) return folder.error();
      const std::string file = folder->path() / "picture.png";
      if (Status drawn = draw_png(mesh, {}, file); !drawn) return drawn;
      const Result<std::string> bytes = read_file(file);
      if (!bytes) return bytes.error();
      out_ += fmt::format("<img alt=\"the mesh\" src=\"data:image/png;base64,{}\">\n",
                          base64_text(*bytes));
    }
    return ok();
  }

  /// What is too small to be seen in the whole mesh: layers, edges on arcs; and pairs of vertices.
  Status close_ups() {
    constexpr std::size_t kMost = 3;    // of lines with layers
    constexpr double kBeside = 2;       // lengths of the segment in the middle of a line
    constexpr double kAroundArc = 1.5;  // lengths of its edge
    std::vector<std::pair<std::string, std::optional<Window>>> shown;
    std::set<std::string> lines;
    for (const RegionReport& region : report_.regions) {
      for (const LayerReport& layers : region.layers) {
        if (layers.most == 0 || lines.size() == kMost || !lines.insert(layers.asked.line).second)
          continue;
        const std::array<Point, 2> at = middle_of(layers.asked.line);
        const double reach = std::max(kBeside * distance(at[0], at[1]), layers.thickness);
        shown.emplace_back(
            fmt::format("Layers along {}", layers.asked.line),
            window_around({(at[0].x + at[1].x) / 2, (at[0].y + at[1].y) / 2}, reach));
      }
    }
    const PictureMesh mesh = picture_of(output_, order_);
    if (order_ == 2) {
      const std::vector<CurvedEdge> edges = curved_mesh(output_).edges;
      const auto edge = std::find_if(edges.begin(), edges.end(),
                                     [](const CurvedEdge& e) { return !e.is_straight; });
      if (edge != edges.end()) {
        const auto& points = mesh.mesh.soup.points;
        shown.emplace_back(
            "Edges on an arc",
            window_around(edge->middle, kAroundArc * distance(points[edge->a], points[edge->b])));
      }
    }
    if (!output_.periodic.empty() && report_.quality.triangles <= kLargeMesh)
      shown.emplace_back("Vertices with partners on periodic sides", std::nullopt);
    if (shown.empty()) return ok();
    out_ += "<h2>Close-ups</h2>\n<div class=\"two\">\n";
    for (std::size_t k = 0; k < shown.size(); ++k) {
      PictureOptions options;
      options.width = 560;
      options.worst = 0;
      options.title = shown[k].first;
      options.window = shown[k].second;
      options.id = fmt::format("close-up-{}", k);
      Result<std::string> svg = svg_text(mesh, options);
      if (!svg) return std::move(svg).error();
      out_ += "<div class=\"panel\">\n" + *svg + "</div>\n";
    }
    out_ += "</div>\n";
    return ok();
  }

  static double distance(Point p, Point q) { return std::hypot(q.x - p.x, q.y - p.y); }

  static Window window_around(Point p, double reach) {
    return {{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}};
  }

  /// The segment in the middle of those of a line.
  [[nodiscard]] std::array<Point, 2> middle_of(const std::string& line) const {
    std::vector<SegmentId> all;
    for (const Interface& part : output_.table.interfaces) {
      if (part.name == line) all.insert(all.end(), part.segments.begin(), part.segments.end());
    }
    const Segment& segment = output_.pslg.segments[all[all.size() / 2].index()];
    return {output_.pslg.points[segment.a.index()], output_.pslg.points[segment.b.index()]};
  }

  /// The mesh to play with, at the end of the page: all else is there before it.
  void view() {
    constexpr std::size_t kMost = 500'000;  // 14 MB of text
    out_ += "<script type=\"application/json\" id=\"mesh-data\">";
    out_ += view_data(output_, kMost);
    out_ += "</script>\n<script>";
    out_ += kMeshViewScript;
    out_ += "</script>\n";
  }

  void regions() {
    constexpr std::size_t kMostRows = 500;
    std::vector<std::size_t> order(report_.regions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return report_.regions[a].rho() < report_.regions[b].rho();
    });
    const bool cut = order.size() > kMostRows;
    if (cut) order.resize(kMostRows);
    std::vector<double> curved;  // areas, by RegionId - 1; empty: no arcs
    if (!output_.pslg.circles.empty()) curved = curved_mesh(output_).areas;
    out_ += fmt::format(
        "<h2>Regions, lowest rho first{}</h2>\n"
        "<div class=\"panel scroll\">\n<table class=\"regions\">\n<thead>\n<tr><th "
        "colspan=\"6\"></th>"
        "<th class=\"group\" colspan=\"3\">largest angle</th><th colspan=\"2\"></th>"
        "<th class=\"group\" colspan=\"2\">triangles (forced)</th><th></th></tr>\n"
        "<tr><th>id</th><th class=\"t\">name</th>"
        "<th class=\"t\">material</th><th>area{}</th><th>triangles</th><th>new vertices</th>"
        "<th>no mesh below</th><th>proven</th><th>reached</th><th>rho</th><th>smallest</th>"
        "<th>&gt; 120°</th><th>&gt; 150°</th><th class=\"t\">method</th></tr>\n</thead>\n",
        cut ? fmt::format(" (the first {})", kMostRows) : "",
        curved.empty() ? "" : " (with --order 2)");
    for (const std::size_t i : order) {
      const RegionReport& r = report_.regions[i];
      const Region& region = output_.table.region(r.id);
      out_ += fmt::format(
          "<tr{} data-region=\"{}\"><td>{}</td><td class=\"t\">{}</td><td "
          "class=\"t\">{}</td><td>{}</td><td>{}</td>"
          "<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.2f}</td><td>{}</td><td>{} "
          "({})</td>"
          "<td>{} ({})</td><td class=\"t\">{}</td></tr>\n",
          r.bound_held ? "" : " class=\"missed\"", region.id.value(), region.id.value(),
          escaped_markup(region.name), escaped_markup(region.material_name),
          area_text(region.area, curved, region.id), grouped(r.quality.triangles),
          grouped(r.steiner_vertices), angle_text(r.lowest_nu()), angle_text(r.nu_bound),
          angle_text(r.quality.largest_nu), r.rho(), small_angle_text(r.quality.smallest),
          grouped(r.quality.above_120), grouped(r.forced_above_120), grouped(r.quality.above_150),
          grouped(r.forced_above_150), escaped_markup(r.method));
    }
    out_ += "</table>\n</div>\n";
  }

  /// The area inside straight edges, and inside those through the nodes on arcs.
  static std::string area_text(double area, const std::vector<double>& curved, RegionId region) {
    return curved.empty() ? fmt::format("{:.5g}", area)
                          : fmt::format("{:.5g} ({:.5g})", area, curved[place_of(region)]);
  }

  void histogram() {
    const auto& bins = report_.quality.histogram;
    const auto most = static_cast<double>(*std::max_element(bins.begin(), bins.end()));
    out_ +=
        "<div>\n<h2>All angles</h2>\n<div class=\"panel\">\n"
        "<svg class=\"histogram\" viewBox=\"0 0 560 210\" width=\"560\" font-size=\"11\">\n";
    for (std::size_t i = 0; i < bins.size(); ++i) {
      const auto k = static_cast<double>(i);
      const double height = most > 0 ? 160 * static_cast<double>(bins[i]) / most : 0;
      const double shown = bins[i] > 0 ? std::max(height, 1.5) : 0;
      out_ += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"26\" height=\"{:.1f}\" fill=\"{}\"><title>{} to "
          "{}: "
          "{}</title></rect>\n<text x=\"{:.1f}\" y=\"195\" text-anchor=\"middle\">{}</text>\n",
          12 + 29.5 * k, 178 - shown, shown,
          i >= 15   ? "var(--bar-150)"
          : i >= 12 ? "var(--bar-120)"
                    : "var(--bar)",
          10 * i, 10 * (i + 1), grouped(bins[i]), 12 + 29.5 * k, 10 * i);
    }
    out_ += "<text x=\"543\" y=\"195\" text-anchor=\"middle\">180</text>\n</svg>\n</div>\n</div>\n";
  }

  void box_method() {
    BoxMethod sum;
    double area = 0;
    for (const RegionReport& region : report_.regions) {
      sum += region.box;
      area += region.quality.area;
    }
    const auto row = [&](std::string_view what, const std::string& value) {
      out_ += fmt::format("<tr><td class=\"t\">{}</td><td>{}</td></tr>\n", what, value);
    };
    out_ += "<div>\n<h2>For the box method (finite volumes)</h2>\n<div class=\"panel\">\n<table>\n";
    row("obtuse triangles", grouped(report_.quality.obtuse));
    row("above 90 degrees by rounding of coordinates", grouped(report_.quality.obtuse_by_rounding));
    row("sides with an obtuse opposite angle", grouped(sum.obtuse_sides));
    row("inner edges that are not Delaunay", grouped(sum.non_delaunay_edges));
    row("negative couplings", grouped(sum.negative_couplings));
    row("of these, on inner edges", grouped(sum.negative_inside));
    row("on sides that points of the input or layers encroach", grouped(sum.negative_encroached));
    row("on sides where the bound forces them", grouped(sum.negative_forced));
    row("on sides given up for angles", grouped(sum.negative_given_up));
    row("area of all boxes against the true area",
        percent_text(area > 0 ? 100 * (sum.box_area - area) / area : 0, 3));
    out_ +=
        "</table>\n<p>With zeros above, unsigned boxes are exact; else solvers that use them "
        "are off by about the last figure, without a warning.</p>\n</div>\n</div>\n";
  }

  void notes() {
    std::vector<std::string> lines;
    for (const Note& note : report_.notes) lines.push_back(note.message);
    for (const RegionReport& region : report_.regions) {
      for (const Note& note : region.notes) lines.push_back(note.message + places(note));
    }
    out_ += "<h2>Changes of the input, warnings, remarks</h2>\n<div class=\"panel\">\n";
    if (lines.empty()) out_ += "<p>None: the input was meshed as it is.</p>\n";
    constexpr std::size_t kLines = 200;
    out_ += "<ul>\n";
    for (std::size_t i = 0; i < std::min(lines.size(), kLines); ++i) {
      out_ += fmt::format("<li>{}</li>\n", escaped_markup(lines[i]));
    }
    if (lines.size() > kLines)
      out_ += fmt::format("<li>and {} more, which a report in JSON lists</li>\n",
                          grouped(lines.size() - kLines));
    out_ += "</ul>\n</div>\n";
  }

  void times() {
    out_ += fmt::format("<h2>Time, on {} thread{}</h2>\n<div class=\"panel\">\n<table>\n",
                        report_.threads, report_.threads == 1 ? "" : "s");
    for (const StageTime& stage : report_.times) {
      out_ += fmt::format("<tr><td class=\"t\">{}</td><td>{:.3f} s</td></tr>\n",
                          escaped_markup(stage.stage), stage.seconds);
    }
    out_ += "</table>\n</div>\n";
  }

  const Output& output_;
  const Report& report_;
  int order_;  ///< of the triangles in files
  std::string out_;
};

}  // namespace

Status write_report_html(const Output& output, const std::string& path, int order) {
  const std::string title = "Mesh report: " + std::filesystem::path(path).stem().string();
  const Result<std::string> html = Page(output, order).html(title);
  if (!html) return html.error();
  return replace_file(path, *html);
}

}  // namespace cover::app
