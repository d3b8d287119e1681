// A drawing as SVG: one path per colour, so that no seams show between triangles of one region.
// Tested by tests/unit/picture/picture_test.cpp.
#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <cover/picture.hpp>
#include <cover/text.hpp>

#include "base/faults/errors.hpp"
#include "base/faults/out_of_memory.hpp"
#include "base/words/characters.hpp"
#include "io/files/atomic_file.hpp"
#include "picture/compose.hpp"

namespace cover {
namespace {

std::string hex(Colour c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

/// Appends items to a document.
class SvgWriter {
 public:
  SvgWriter(std::string& out, const std::string& clip_id)
      : out_(out), clip_(fmt::format(" clip-path=\"url(#{})\"", clip_id)) {}

  void operator()(const PaintedPatch& patch) {
    const std::string colour = hex(patch.colour);
    // A hair of its own colour closes the seam to the neighbouring colour.
    put("<path{} fill=\"{}\" stroke=\"{}\" stroke-width=\"0.3\" d=\"", clip(patch.clipped), colour,
        colour);
    for (const auto& [a, b, c] : patch.triangles) {
      put("M{:.2f} {:.2f}L{:.2f} {:.2f} {:.2f} {:.2f}z", a.x, a.y, b.x, b.y, c.x, c.y);
    }
    out_ += "\"/>\n";
  }

  void operator()(const Stroke& stroke) {
    put("<path{} fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{}\" "
        "stroke-linecap=\"round\" d=\"",
        clip(stroke.clipped), hex(stroke.colour), stroke.width, stroke.opacity);
    for (const auto& [a, b] : stroke.lines) {
      put("M{:.2f} {:.2f}L{:.2f} {:.2f}", a.x, a.y, b.x, b.y);
    }
    out_ += "\"/>\n";
  }

  void operator()(const Ring& ring) {
    put("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"none\" stroke=\"{}\" "
        "stroke-width=\"{}\"/>\n",
        ring.centre.x, ring.centre.y, ring.radius, hex(ring.colour), ring.width);
  }

  void operator()(const Label& label) {
    const char* anchor = label.anchor == Label::Anchor::start    ? "start"
                         : label.anchor == Label::Anchor::middle ? "middle"
                                                                 : "end";
    put("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}{}>{}"
        "</text>\n",
        label.at.x, label.at.y, label.size, anchor, hex(label.colour),
        label.bold ? " font-weight=\"bold\"" : "",
        label.halo ? " stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"" : "",
        escaped_markup(label.text));
  }

 private:
  [[nodiscard]] std::string clip(bool clipped) const { return clipped ? clip_ : std::string(); }

  template <class... T>
  void put(fmt::format_string<T...> form, T&&... values) {
    out_ += fmt::format(form, std::forward<T>(values)...);
  }

  std::string& out_;
  std::string clip_;
};

/// Whether the text can be the id of an element, and stand in a url(#...). Bytes of letters that
/// are not in ASCII are taken as they are.
bool is_xml_name(std::string_view text) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  };
  return !text.empty() && is_letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) {
           return is_letter(c) || is_digit(c) || c == '-' || c == '.' || c == ':';
         });
}

}  // namespace

Result<std::string> svg_text(const PictureMesh& mesh, const PictureOptions& options) {
  return memory_as_value("picture", [&]() -> Result<std::string> {
    if (!is_xml_name(options.id))
      return bad_option(
          fmt::format("the id of a picture must be a name in XML: a letter or _, then "
                      "letters, digits, and _ - . :, not '{}'",
                      options.id));
    Result<Drawing> composed = compose(mesh, options);
    if (!composed) return std::move(composed).error();
    const Drawing& drawing = *composed;
    const PixelBox& box = drawing.plot;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, sans-serif\">\n"
        "<clipPath id=\"{6}\"><rect x=\"{2:.1f}\" y=\"{3:.1f}\" width=\"{4:.1f}\" "
        "height=\"{5:.1f}\"/></clipPath>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        drawing.width, drawing.height, box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0,
        options.id);
    SvgWriter writer(out, options.id);
    for (const DrawingItem& item : drawing.items) std::visit(writer, item);
    out += "</svg>\n";
    return out;
  });
}

Status write_svg(const PictureMesh& mesh, const PictureOptions& options, const std::string& path) {
  return memory_as_value(path, [&]() -> Status {
    const Result<std::string> text = svg_text(mesh, options);
    if (!text) return text.error();
    Result<AtomicFile> file = AtomicFile::create(path, options.stop);
    if (!file) return std::move(file).error();
    file->write(*text);
    return file->commit();
  });
}

}  // namespace cover
