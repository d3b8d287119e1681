// Tested by tests/unit/dxf/read_dxf_test.cpp.
#include "dxf/place_blocks.hpp"

#include <map>
#include <optional>
#include <set>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "geom/turn.hpp"
#include "io/text/limits.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// Where the point (column, row) of an insert takes its block; quarters of a turn are exact.
Affine place_of(const DxfInsert& insert, Point base, int column, int row) {
  const auto [cosine, sine] = Turn::by_degrees(insert.angle);
  const double right = column * insert.column_step, up = row * insert.row_step;
  const Affine turned{cosine, -sine,  insert.at.x + cosine * right - sine * up,
                      sine,   cosine, insert.at.y + sine * right + cosine * up};
  const Affine scaled{insert.scale_x,          0, -insert.scale_x * base.x, 0, insert.scale_y,
                      -insert.scale_y * base.y};
  const Affine placed = turned.after(scaled);
  return insert.mirrored ? Affine{-1, 0, 0, 0, 1, 0}.after(placed) : placed;
}

class Placer {
 public:
  Placer(const DxfDrawing& drawing, const std::string& source,
         const std::map<std::string, HiddenLayer>& hidden)
      : drawing_(drawing), source_(source), hidden_(hidden) {
    own_ = things_in(drawing.model) + drawing.model.inserts.size();
    for (const auto& [name, block] : drawing.blocks)
      own_ += things_in(block) + block.inserts.size();
  }

  Result<PlacedDrawing> run() {
    const double amount = amount_of(drawing_.model, 0);
    if (!error_ && amount > static_cast<double>(kLayoutShapes + own_))
      fail(fmt::format("blocks make {:.6g} things of {}, at most {} are drawn", amount, own_,
                       kLayoutShapes + own_));
    if (!error_) place(drawing_.model, Affine(), {});
    if (error_) return *std::move(error_);
    out_.missing.assign(missing_.begin(), missing_.end());
    return std::move(out_);
  }

 private:
  void fail(const std::string& what) {
    if (!error_)
      error_ = Error{ErrorCode::unsupported_format, fmt::format("{}: {}", source_, what), {}, {}};
  }

  static std::size_t things_in(const DxfBlock& block) {
    return block.curves.size() + block.points.size() + block.texts.size();
  }

  const DxfBlock* find(const std::string& name) {
    const auto found = drawing_.blocks.find(name);
    if (found != drawing_.blocks.end()) return &found->second;
    missing_.insert(legible(name));
    return nullptr;
  }

  /// How much a block draws with everything in it; infinite after an error.
  double amount_of(const DxfBlock& block, std::size_t depth) {
    const auto known = amounts_.find(&block);
    if (known != amounts_.end()) {
      if (known->second < 0) fail("a block contains itself");
      return known->second;
    }
    if (depth > kCellDepth) fail(fmt::format("more than {} blocks, one in the other", kCellDepth));
    if (error_) return 0;
    amounts_[&block] = -1;  // being counted
    double amount = static_cast<double>(things_in(block));
    for (const DxfInsert& insert : block.inserts) {
      const DxfBlock* inner = find(insert.block);
      const double times = static_cast<double>(insert.columns) * insert.rows;
      if (inner != nullptr) amount += times * std::max(1.0, amount_of(*inner, depth + 1));
      if (error_) break;
    }
    amounts_[&block] = amount;
    return amount;
  }

  /// The layer of the insert that a block is seen through, and what is frozen of all such.
  struct Seen {
    const std::string* layer = nullptr;
    const std::string* frozen = nullptr;
  };

  [[nodiscard]] bool is_frozen(const std::string& layer) const {
    const auto found = hidden_.find(lower(layer));
    return found != hidden_.end() && found->second.frozen;
  }

  void place(const DxfBlock& block, const Affine& at, Seen seen) {
    const auto layer_of = [&](const std::string& own) {
      return seen.layer != nullptr && own == "0" ? seen.layer : &own;
    };
    for (const DxfCurve& curve : block.curves)
      out_.curves.push_back({&curve, at, layer_of(curve.layer), seen.frozen});
    for (const DxfPoint& point : block.points)
      out_.points.push_back({&point, at, layer_of(point.layer), seen.frozen});
    for (const DxfText& text : block.texts)
      out_.texts.push_back({&text, at, layer_of(text.layer), seen.frozen});
    for (const DxfInsert& insert : block.inserts) {
      const DxfBlock* inner = find(insert.block);
      if (inner == nullptr) continue;
      Seen within{layer_of(insert.layer), seen.frozen};
      if (within.frozen == nullptr && is_frozen(*within.layer)) within.frozen = within.layer;
      for (int row = 0; row < insert.rows; ++row)
        for (int column = 0; column < insert.columns; ++column)
          place(*inner, at.after(place_of(insert, inner->base, column, row)), within);
    }
  }

  const DxfDrawing& drawing_;
  const std::string& source_;
  const std::map<std::string, HiddenLayer>& hidden_;
  std::size_t own_ = 0;
  std::map<const DxfBlock*, double> amounts_;
  std::set<std::string> missing_;
  PlacedDrawing out_;
  std::optional<Error> error_;
};

}  // namespace

Result<PlacedDrawing> place_blocks(const DxfDrawing& drawing, const std::string& source,
                                   const std::map<std::string, HiddenLayer>& hidden) {
  return Placer(drawing, source, hidden).run();
}

}  // namespace cover
