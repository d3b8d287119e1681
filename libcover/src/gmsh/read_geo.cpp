// gmsh is asked for the mesh of the curves only. Of each surface the curves around it are taken, an
// even number of times not at all, and laid end to end; inside is even-odd, so it does not matter
// in which rings.
// Tested by tests/unit/gmsh/read_geo_test.cpp.
#include <cover/read_geo.hpp>

#include <fmt/core.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

#include <cover/text.hpp>

#include "base/words/and_more.hpp"

namespace cover {
namespace {

/// gmsh, for as long as one file is read.
class Session {
 public:
  Session() : lock_(mutex()) {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::logger::start();
  }
  ~Session() {
    try {
      gmsh::logger::stop();  // or the next session would see the errors of this one
      gmsh::finalize();
    } catch (...) {  // there is nothing left to do about it
    }
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// What gmsh complained of so far.
  [[nodiscard]] static std::vector<std::string> errors() {
    std::vector<std::string> log, out;
    gmsh::logger::get(log);
    for (const std::string& line : log) {
      if (line.starts_with("Error: ")) out.push_back(line.substr(7));
    }
    return out;
  }

 private:
  static std::mutex& mutex() {
    static std::mutex mutex;
    return mutex;
  }
  std::lock_guard<std::mutex> lock_;
};

/// A piece of a curve, by indices into Input::points.
using Piece = std::pair<std::uint32_t, std::uint32_t>;

/// The circle through three points; nothing if they lie nearly on a line.
std::optional<ArcCircle> circle_through(Point a, Point b, Point c) {
  constexpr double kFlat = 1e-6;
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double doubled = 2 * (bx * cy - by * cx), b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  if (!(std::abs(doubled) > kFlat * (b2 + c2))) return std::nullopt;
  const double x = (cy * b2 - by * c2) / doubled, y = (bx * c2 - cx * b2) / doubled;
  return ArcCircle{{a.x + x, a.y + y}, std::hypot(x, y)};
}

constexpr double kOnCircle = 0x1p-40;  ///< of its size and place

class Reader {
 public:
  explicit Reader(const std::string& path) { input_.source = path; }

  Result<Input> read() {
    warn_of_last_line();
    gmsh::open(input_.source);
    if (const auto errors = Session::errors(); !errors.empty()) return syntax(errors);
    gmsh::model::mesh::generate(1);
    if (const auto errors = Session::errors(); !errors.empty()) return syntax(errors);
    if (!read_points()) return not_plane();
    gmsh::vectorpair surfaces, curves;
    gmsh::model::getEntities(surfaces, 2);
    gmsh::model::getEntities(curves, 1);
    if (curves.empty()) return unsupported("the model has no curves");
    for (const auto& [dimension, tag] : curves) read_curve(tag);
    const bool some_only = is_any_physical(surfaces);
    for (const auto& [dimension, tag] : surfaces) read_surface(tag, some_only);
    for (const auto& [dimension, tag] : curves) read_contact(tag, surfaces.empty());
    keep_used_points();
    return std::move(input_);
  }

 private:
  Error syntax(const std::vector<std::string>& errors) {
    const std::size_t shown = std::min<std::size_t>(errors.size(), 3);
    std::string message =
        fmt::format("{}: gmsh: {}{}", input_.source, listed(std::span(errors).first(shown), "; "),
                    and_more(errors.size(), shown, ";"));
    return {ErrorCode::syntax, std::move(message), {}, {}};
  }
  Error unsupported(const char* what) {
    return {ErrorCode::unsupported_format, fmt::format("{}: {}", input_.source, what), {}, {}};
  }
  Error not_plane() {
    return unsupported("its points are not all at one height: only plane models are read");
  }

  /// gmsh 4.8 passes over statements at the end of a file that does not end with a new line.
  void warn_of_last_line() {
    std::ifstream file(input_.source, std::ios::binary | std::ios::ate);
    if (file.tellg() <= 0) return;
    file.seekg(-1, std::ios::end);
    if (file.get() == '\n') return;
    input_.warnings.emplace_back(
        "the last line does not end: gmsh passes over some of its statements");
  }

  bool read_points() {
    std::vector<std::size_t> tags;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters, -1, -1, false, false);
    std::map<Point, std::uint32_t> place;  // gmsh may have several nodes at one
    for (std::size_t k = 0; k < tags.size(); ++k) {
      if (coordinates[3 * k + 2] != coordinates[2]) return false;
      const Point at{coordinates[3 * k], coordinates[3 * k + 1]};
      const auto next = static_cast<std::uint32_t>(input_.points.size());
      const auto [entry, is_new] = place.emplace(at, next);
      index_.emplace(tags[k], entry->second);
      if (!is_new) continue;
      input_.points.push_back(at);
      input_.point_ids.push_back(static_cast<long>(tags[k]));
    }
    used_.assign(input_.points.size(), false);
    gmsh::vectorpair points;
    gmsh::model::getEntities(points, 0);
    for (const auto& [dimension, tag] : points) {
      if (groups_of(0, tag).empty()) continue;
      gmsh::model::mesh::getNodes(tags, coordinates, parameters, 0, tag, false, false);
      for (const std::size_t node : tags) used_[index_.at(node)] = true;
    }
    return true;
  }

  void read_curve(int tag) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, 1, tag);
    std::vector<Piece>& pieces = pieces_[tag];
    const std::uint32_t circle = circle_of(tag);
    for (std::size_t t = 0; t < types.size(); ++t) {
      if (elements[t].empty()) continue;
      const std::size_t step = nodes[t].size() / elements[t].size();  // the first two are the ends
      for (std::size_t k = 0; k < nodes[t].size(); k += step) {
        pieces.emplace_back(index_.at(nodes[t][k]), index_.at(nodes[t][k + 1]));
        if (circle != 0) {
          circle_of_piece_[pieces.back()] = circle;
          circle_of_piece_[{pieces.back().second, pieces.back().first}] = circle;
        }
      }
    }
  }

  /// The number of the circle that a curve is an arc of, as in InputSegment; 0 if it is none.
  std::uint32_t circle_of(int tag) {
    std::string type;
    gmsh::model::getType(1, tag, type);
    if (type == "Line") return 0;
    std::vector<double> low, high, at;
    gmsh::model::getParametrizationBounds(1, tag, low, high);
    // After Boolean operations an arc is of another type, so places tell: three that are apart on
    // a whole circle too, and whether others lie on the circle through these.
    constexpr std::size_t kParts = 12;
    std::vector<double> parameters;
    for (std::size_t k = 0; k <= kParts; ++k)
      parameters.push_back(low[0] + (high[0] - low[0]) * static_cast<double>(k) / kParts);
    gmsh::model::getValue(1, tag, parameters, at);
    const auto place = [&](std::size_t k) { return Point{at[3 * k], at[3 * k + 1]}; };
    const auto circle = circle_through(place(0), place(kParts / 3), place(2 * kParts / 3));
    if (!circle) return 0;
    for (std::size_t k = 0; k <= kParts; ++k) {
      const Point p = place(k), c = circle->centre;
      const double size = std::max({circle->radius, std::abs(p.x), std::abs(p.y)});
      const double off = std::hypot(p.x - c.x, p.y - c.y) - circle->radius;
      if (std::abs(off) > kOnCircle * size) return 0;
    }
    input_.circles.push_back(*circle);
    return static_cast<std::uint32_t>(input_.circles.size());
  }

  static std::vector<int> groups_of(int dimension, int tag) {
    std::vector<int> groups;
    gmsh::model::getPhysicalGroupsForEntity(dimension, tag, groups);
    return groups;
  }

  static std::string name_of_group(int dimension, int group) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, group, name);
    return name.empty() ? std::to_string(group) : name;
  }

  static bool is_any_physical(const gmsh::vectorpair& entities) {
    return std::any_of(entities.begin(), entities.end(),
                       [](const auto& e) { return !groups_of(e.first, e.second).empty(); });
  }

  void read_surface(int tag, bool physical_only) {
    const std::vector<int> groups = groups_of(2, tag);
    if (groups.empty() && physical_only) return;
    if (groups.size() > 1) {
      input_.warnings.push_back(
          fmt::format("surface {} is in {} physical groups: the first counts", tag, groups.size()));
    }
    gmsh::vectorpair boundary;
    gmsh::model::getBoundary({{2, tag}}, boundary, false, false);
    std::multiset<Piece> sides;
    for (const auto& [dimension, curve] : boundary) {
      for (const Piece& p : pieces_[std::abs(curve)]) {
        if (p.first == p.second) continue;
        const Piece side(std::min(p.first, p.second), std::max(p.first, p.second));
        if (const auto same = sides.find(side); same != sides.end()) {
          sides.erase(same);
        } else {
          sides.insert(side);
        }
      }
    }
    InputPolygon polygon;
    polygon.material =
        groups.empty() ? fmt::format("surface_{}", tag) : name_of_group(2, groups.front());
    polygon.id = tag;
    polygon.rings = rings_of({sides.begin(), sides.end()}, polygon.circles);
    input_.polygons.push_back(std::move(polygon));
  }

  /// Lays pieces end to end. Each point is the end of an even number of them.
  std::vector<std::vector<Point>> rings_of(const std::vector<Piece>& pieces,
                                           std::vector<std::vector<std::uint32_t>>& circles) {
    std::multimap<std::uint32_t, std::size_t> at;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      at.emplace(pieces[k].first, k);
      at.emplace(pieces[k].second, k);
    }
    std::vector<bool> done(pieces.size(), false);
    std::vector<std::vector<Point>> rings;
    for (std::size_t start = 0; start < pieces.size(); ++start) {
      if (done[start]) continue;
      std::vector<Point> ring;
      std::vector<std::uint32_t> circle;
      std::uint32_t here = pieces[start].first;
      for (std::size_t k = start; k != pieces.size();) {
        done[k] = true;
        ring.push_back(input_.points[here]);
        const auto arc = circle_of_piece_.find(pieces[k]);
        circle.push_back(arc == circle_of_piece_.end() ? 0 : arc->second);
        here = pieces[k].first == here ? pieces[k].second : pieces[k].first;
        k = pieces.size();
        for (auto [entry, end] = at.equal_range(here); entry != end; ++entry) {
          if (!done[entry->second]) k = entry->second;
        }
      }
      rings.push_back(std::move(ring));
      circles.push_back(std::move(circle));
    }
    return rings;
  }

  /// Curves in a physical group are contacts; in a model without surfaces all curves count.
  void read_contact(int tag, bool all) {
    const std::vector<int> groups = groups_of(1, tag);
    if (groups.empty() && !all) return;
    InputSegment segment;
    segment.id = tag;
    if (!groups.empty()) {
      segment.name = name_of_group(1, groups.front());
      segment.marker = groups.front();
    }
    for (const auto& [a, b] : pieces_[tag]) {
      segment.a = a;
      segment.b = b;
      const auto arc = circle_of_piece_.find({a, b});
      segment.circle = arc == circle_of_piece_.end() ? 0 : arc->second;
      input_.segments.push_back(segment);
    }
  }

  /// Leaves out the points that neither segments nor physical groups need.
  void keep_used_points() {
    for (const InputSegment& s : input_.segments) used_[s.a] = used_[s.b] = true;
    std::vector<std::uint32_t> number(used_.size());
    std::uint32_t count = 0;
    for (std::uint32_t p = 0; p < used_.size(); ++p) {
      if (!used_[p]) continue;
      number[p] = count;
      input_.points[count] = input_.points[p];
      input_.point_ids[count++] = input_.point_ids[p];
    }
    input_.points.resize(count);
    input_.point_ids.resize(count);
    for (InputSegment& s : input_.segments) {
      s.a = number[s.a];
      s.b = number[s.b];
    }
  }

  Input input_;
  std::map<std::size_t, std::uint32_t> index_;      ///< of input_.points, by gmsh's node
  std::map<int, std::vector<Piece>> pieces_;        ///< by curve
  std::map<Piece, std::uint32_t> circle_of_piece_;  ///< either way round: its number
  std::vector<bool> used_;                          ///< by point
};

Error failed(const std::string& path, const std::string& what) {
  return {ErrorCode::syntax, fmt::format("{}: gmsh: {}", path, what), {}, {}};
}

}  // namespace

Result<Input> read_geo(const std::string& path) {
  if (!std::filesystem::is_regular_file(path))
    return Error{ErrorCode::cannot_open, fmt::format("cannot open {}", path), {}, {}};
  const Session session;
  try {
    return Reader(path).read();
  } catch (const std::exception& e) {
    return failed(path, e.what());
  } catch (const std::string& e) {
    return failed(path, e);
  } catch (int code) {  // what gmsh 4.8 throws
    const auto errors = Session::errors();
    return failed(path, errors.empty() ? fmt::format("error {}", code) : errors.front());
  }
}

}  // namespace cover
