// Drawings made in tests.
#pragma once

#include <initializer_list>
#include <sstream>
#include <string>
#include <utility>

namespace cover::testing {

/// A drawing in DXF, entity by entity.
class DxfWriter {
 public:
  using Groups = std::initializer_list<std::pair<int, double>>;

  /// An entity on a layer with numbers.
  DxfWriter& entity(const std::string& kind, const std::string& layer, Groups groups) {
    group(0, kind).group(8, layer);
    for (const auto& [code, value] : groups) number(code, value);
    return *this;
  }
  DxfWriter& line(const std::string& layer, double x0, double y0, double x1, double y1) {
    return entity("LINE", layer, {{10, x0}, {20, y0}, {11, x1}, {21, y1}});
  }
  DxfWriter& circle(const std::string& layer, double x, double y, double radius) {
    return entity("CIRCLE", layer, {{10, x}, {20, y}, {40, radius}});
  }
  DxfWriter& text(const std::string& layer, double x, double y, const std::string& words) {
    return entity("TEXT", layer, {{10, x}, {20, y}, {40, 1}}).group(1, words);
  }
  DxfWriter& insert(const std::string& block, const std::string& layer, Groups groups) {
    group(0, "INSERT").group(8, layer).group(2, block);
    for (const auto& [code, value] : groups) number(code, value);
    return *this;
  }
  DxfWriter& begin_blocks() { return group(0, "SECTION").group(2, "BLOCKS"); }
  DxfWriter& begin_block(const std::string& name, double x = 0, double y = 0) {
    return group(0, "BLOCK").group(8, "0").group(2, name).group(70, 0).number(10, x).number(20, y);
  }
  DxfWriter& end_block() { return group(0, "ENDBLK").group(8, "0"); }
  DxfWriter& begin_entities() { return group(0, "SECTION").group(2, "ENTITIES"); }
  DxfWriter& end_section() { return group(0, "ENDSEC"); }
  std::string finish() { return group(0, "ENDSEC").group(0, "EOF").text_.str(); }

  template <class Value>
  DxfWriter& group(int code, const Value& value) {
    text_ << code << '\n' << value << '\n';
    return *this;
  }
  DxfWriter& number(int code, double value) {
    text_.precision(17);
    // Flags and counts are whole numbers.
    if ((code >= 60 && code <= 79) || (code >= 90 && code <= 99))
      return group(code, static_cast<long>(value));
    return group(code, value);
  }

 private:
  std::ostringstream text_;
};

}  // namespace cover::testing
