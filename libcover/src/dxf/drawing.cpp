// Tested by tests/unit/dxf/read_dxf_test.cpp.
#include "dxf/drawing.hpp"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>
#include <sstream>
#include <vector>

#include <fmt/core.h>

#include "base/numbers.hpp"
#include "dxf/group_text.hpp"
#include "geom/turn.hpp"

namespace cover {
namespace {

/// The text of an MTEXT without its formatting: \P is a new line, \fArial; and the like are gone.
std::string plain_text(const std::string& text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '{' || text[k] == '}') continue;
    if (text[k] != '\\' || k + 1 == text.size()) {
      out += text[k];
      continue;
    }
    const char code = text[++k];
    if (code == 'P' || code == '~') {
      out += ' ';
    } else if (code == '\\' || code == '{' || code == '}') {
      out += code;
    } else if (std::string_view("ACFHQTWfcp").find(code) != std::string_view::npos) {
      k = std::min(text.find(';', k), text.size());
    }
  }
  return out;
}

/// Turns what dxflib calls out into a drawing. An entity with several parts is kept open until the
/// next one begins.
class Builder : public DL_CreationAdapter {
 public:
  explicit Builder(const std::vector<bool>& wide) : wide_(wide) {}

  DxfDrawing drawing;

  void finish() {
    close_polyline();
    close_spline();
    block_ = nullptr;
  }

  void addBlock(const DL_BlockData& data) override {
    finish();
    block_ = &drawing.blocks[data.name];
    block_->base = {data.bpx, data.bpy};
  }
  void endBlock() override { finish(); }

  void addPoint(const DL_PointData& d) override {
    block().points.push_back({attributes.getLayer(), {d.x, d.y}});
  }
  void addLine(const DL_LineData& d) override {
    if (d.z1 != d.z2) ++drawing.in_space;
    add(BulgePolyline{{{{d.x1, d.y1}, 0}, {{d.x2, d.y2}, 0}}});
  }
  void addArc(const DL_ArcData& d) override {
    if (!is_plane()) return;
    DxfArc arc{{d.cx, d.cy}, d.radius, std::fmod(d.angle1, 360), std::fmod(d.angle2, 360)};
    if (is_mirrored()) {
      arc.centre.x = -arc.centre.x;
      const double from = 180 - arc.to;
      arc.to = 180 - arc.from;
      arc.from = from;
    }
    while (arc.to <= arc.from) arc.to += 360;
    while (arc.to - arc.from > 360) arc.to -= 360;
    if (is_full_turn(d.angle1, d.angle2)) arc.to = arc.from + 360;
    add_round(arc);
  }
  void addCircle(const DL_CircleData& d) override {
    if (is_plane()) add_round(DxfArc{{side() * d.cx, d.cy}, d.radius, 0, 360});
  }
  void addEllipse(const DL_EllipseData& d) override {
    // Given in the plane of the drawing; seen from behind it runs the other way round.
    if (!is_plane()) return;
    const double ratio = side() * d.ratio;
    DxfEllipse e{{d.cx, d.cy}, {d.mx, d.my}, {-ratio * d.my, ratio * d.mx}, 0, 360};
    const double sweep = d.angle2 - d.angle1;
    constexpr double kWhole = 2 * std::numbers::pi;
    if (std::abs(std::remainder(sweep, kWhole)) > 1e-9) {
      e.from = d.angle1 * kRadian;
      e.to = e.from + (sweep - kWhole * std::floor(sweep / kWhole)) * kRadian;
    }
    add(e);
  }

  void addPolyline(const DL_PolylineData& d) override {
    close_polyline();
    constexpr int kClosed = 1, kSpace = 8, kMesh = 16, kPolyface = 64;
    polyline_layer_ = attributes.getLayer();
    // As those of a line, points of a polyline in space are not turned with its extrusion.
    const bool in_space = (d.flags & kSpace) != 0;
    polyline_side_ = in_space ? 1 : side();
    const std::size_t number = polylines_++;
    polyline_ = {{}, (d.flags & kClosed) != 0, number < wide_.size() && wide_[number]};
    keep_polyline_ = (d.flags & (kMesh | kPolyface)) == 0;
    if (!keep_polyline_) ++drawing.meshes;
    keep_polyline_ = keep_polyline_ && (in_space || is_plane());
    polyline_open_ = true;
    heights_ = {};
  }
  void addVertex(const DL_VertexData& d) override {
    if (!polyline_open_) return;
    polyline_.corners.push_back({{polyline_side_ * d.x, d.y}, polyline_side_ * d.bulge});
    heights_.add(d.z);
  }

  void addSpline(const DL_SplineData& d) override {
    close_spline();
    spline_layer_ = attributes.getLayer();
    spline_ = {};
    spline_.degree = d.degree > 0 ? static_cast<std::size_t>(d.degree) : 0;
    spline_.closed = (d.flags & 1) != 0;
    spline_open_ = true;
    heights_ = {};
  }
  void addControlPoint(const DL_ControlPointData& d) override {
    heights_.add(d.z);
    spline_.controls.push_back({d.x, d.y});
    spline_.weights.push_back(d.w > 0 ? d.w : 1);
  }
  void addKnot(const DL_KnotData& d) override { spline_.knots.push_back(d.k); }
  void addFitPoint(const DL_FitPointData& d) override {
    heights_.add(d.z);
    spline_.fits.push_back({d.x, d.y});
  }

  void addInsert(const DL_InsertData& d) override {
    if (!is_plane()) return;
    // What lies on itself is drawn once.
    const int columns = d.colSp == 0 ? 1 : std::max(1, d.cols);
    const int rows = d.rowSp == 0 ? 1 : std::max(1, d.rows);
    DxfInsert insert{attributes.getLayer(),
                     d.name,
                     {d.ipx, d.ipy},
                     d.sx,
                     d.sy,
                     d.angle,
                     columns,
                     rows,
                     d.colSp,
                     d.rowSp,
                     is_mirrored()};
    block().inserts.push_back(std::move(insert));
  }

  void addText(const DL_TextData& d) override {
    // A text that is not set from its left end on has its place in the second point.
    const bool aligned = d.hJustification != 0 || d.vJustification != 0;
    const Point at = aligned ? Point{d.apx, d.apy} : Point{d.ipx, d.ipy};
    if (is_plane())
      block().texts.push_back({attributes.getLayer(), {side() * at.x, at.y}, with_symbols(d.text)});
  }
  void addMTextChunk(const std::string& text) override { chunks_ += text; }
  void addMText(const DL_MTextData& d) override {
    block().texts.push_back(
        {attributes.getLayer(), {d.ipx, d.ipy}, with_symbols(plain_text(chunks_ + d.text))});
    chunks_.clear();
  }

 private:
  DxfBlock& block() { return block_ != nullptr ? *block_ : drawing.model; }

  template <class Shape>
  void add(Shape shape) {
    block().curves.push_back({attributes.getLayer(), std::move(shape)});
  }

  void add_round(const DxfArc& arc) {
    if (arc.radius > 0)
      add(arc);
    else
      ++drawing.without_radius;
  }

  /// Whether the entity lies in the plane, from whichever side it is seen.
  bool is_plane() {
    const double* d = direction();
    if (std::abs(d[0]) <= 1e-9 && std::abs(d[1]) <= 1e-9 && d[2] != 0) return true;
    ++drawing.tilted;
    return false;
  }
  bool is_mirrored() { return direction()[2] < 0; }
  double side() { return is_mirrored() ? -1 : 1; }
  const double* direction() {
    getExtrusion()->getDirection(direction_);
    return direction_;
  }

  void close_polyline() {
    if (polyline_open_ && keep_polyline_ && polyline_.corners.size() > 1) {
      if (heights_.differ()) ++drawing.in_space;
      block().curves.push_back({polyline_layer_, std::move(polyline_)});
    }
    polyline_open_ = false;
  }
  void close_spline() {
    if (spline_open_ && heights_.differ()) ++drawing.in_space;
    if (spline_open_) block().curves.push_back({spline_layer_, std::move(spline_)});
    spline_open_ = false;
  }

  /// Between which z a curve runs.
  struct Heights {
    double low = kInfinity, high = -kInfinity;
    void add(double z) {
      low = std::min(low, z);
      high = std::max(high, z);
    }
    [[nodiscard]] bool differ() const { return low < high; }
  };

  const std::vector<bool>& wide_;  ///< by polyline
  std::size_t polylines_ = 0;
  DxfBlock* block_ = nullptr;  ///< nullptr: the model
  BulgePolyline polyline_;
  std::string polyline_layer_;
  double polyline_side_ = 1;
  bool polyline_open_ = false, keep_polyline_ = false;
  DxfSpline spline_;
  std::string spline_layer_;
  bool spline_open_ = false;
  Heights heights_;  ///< of the polyline or spline that is open
  std::string chunks_;
  double direction_[3]{};
};

}  // namespace

Result<DxfDrawing> build_drawing(const CheckedDxf& checked, const std::string& source) {
  std::istringstream stream(checked.text);
  Builder builder(checked.wide);
  try {
    DL_Dxf reader;
    if (!reader.in(stream, &builder))
      return Error{ErrorCode::syntax, fmt::format("{}: dxflib cannot read it", source), {}, {}};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return Error{ErrorCode::syntax, fmt::format("{}: dxflib: {}", source, e.what()), {}, {}};
  }
  builder.finish();
  return std::move(builder.drawing);
}

}  // namespace cover
