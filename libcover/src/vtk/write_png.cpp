// The painted image with its text, through VTK's PNG writer. VTK's FreeType tools bring their own
// font and need no display.
// Tested by tests/unit/picture/picture_test.cpp.
#define VTK_DEPRECATION_LEVEL 0  // for letters_of()

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersionMacros.h>
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#include <vtkUnicodeString.h>
#endif

#include <cover/picture.hpp>
#include <cover/text.hpp>

#include "base/faults/out_of_memory.hpp"
#include "io/files/atomic_file.hpp"
#include "picture/compose.hpp"
#include "picture/raster.hpp"

namespace cover {
namespace {

/// VTK 9.1 takes letters beyond ASCII in this type only, which later versions no longer have.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
vtkUnicodeString letters_of(const std::string& text) { return vtkUnicodeString::from_utf8(text); }
#else
const std::string& letters_of(const std::string& text) { return text; }
#endif

/// Letters as opacity; the extent of `letters` is in pixels about the anchor, y upwards.
bool render(const Label& label, vtkImageData* letters) {
  vtkNew<vtkTextProperty> style;
  style->SetFontFamilyToArial();
  style->SetFontSize(static_cast<int>(std::lround(label.size)));
  style->SetBold(label.bold ? 1 : 0);
  style->SetColor(1, 1, 1);
  switch (label.anchor) {
    case Label::Anchor::start:
      style->SetJustificationToLeft();
      break;
    case Label::Anchor::middle:
      style->SetJustificationToCentered();
      break;
    case Label::Anchor::end:
      style->SetJustificationToRight();
      break;
  }
  style->SetVerticalJustificationToBottom();
  vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
  tools->SetScaleToPowerTwo(false);
  constexpr int kDpi = 72;  // a font size is then in pixels
  return tools->RenderString(style, letters_of(printable(label.text)), kDpi, letters);
}

bool has_ink(const Label& label) {
  vtkNew<vtkImageData> letters;
  if (!render(label, letters)) return false;
  std::array<int, 6> extent{};
  letters->GetExtent(extent.data());
  for (int y = extent[2]; y <= extent[3]; ++y) {
    for (int x = extent[0]; x <= extent[1]; ++x)
      if (static_cast<unsigned char*>(letters->GetScalarPointer(x, y, 0))[3] != 0) return true;
  }
  return false;
}

/// "<U+03B1>", of one character beyond ASCII in UTF-8.
std::string code_point_of(std::string_view character) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(character[k]); };
  unsigned code = byte(0) & (0xffU >> (character.size() + 1));
  for (std::size_t k = 1; k < character.size(); ++k) code = code << 6U | (byte(k) & 0x3fU);
  return fmt::format("<U+{:04X}>", code);
}

/// A further byte of a character in UTF-8.
bool goes_on(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80; }

/// The text with its number for each character that the font does not have: it would be left out,
/// and two names could look alike.
std::string in_the_font(const Label& label) {
  std::string out;
  for (std::size_t at = 0; at < label.text.size();) {
    std::size_t end = at + 1;
    while (end < label.text.size() && goes_on(label.text[end])) ++end;
    Label one = label;
    one.text = label.text.substr(at, end - at);
    out += end == at + 1 || has_ink(one) ? one.text : code_point_of(one.text);
    at = end;
  }
  return out;
}

/// Cuts a text that would leave the image on the right: numbers of characters are wider than these
/// were thought to be.
///
/// Cost: O(log n) pictures of the text
bool render_within(Label& label, int width, vtkImageData* letters) {
  const std::string whole = label.text;
  const auto fits = [&](const std::string& text) {
    label.text = text;
    std::array<int, 6> extent{};
    if (!render(label, letters)) return true;  // nothing to cut
    letters->GetExtent(extent.data());
    return std::lround(label.at.x) + extent[1] < width;
  };
  if (whole.empty()) return false;
  if (label.anchor == Label::Anchor::start && !fits(whole)) {
    std::size_t kept = 0, cut = whole.size();
    while (cut - kept > 1) {
      const std::size_t middle = kept + (cut - kept) / 2;
      (fits(whole.substr(0, middle) + "...") ? kept : cut) = middle;
    }
    while (kept > 0 && goes_on(whole[kept])) --kept;
    label.text = whole.substr(0, kept) + "...";
  }
  return render(label, letters);
}

void draw(Label label, Image& image) {
  vtkNew<vtkImageData> letters;
  label.text = in_the_font(label);
  if (!render_within(label, image.width, letters)) return;
  std::array<int, 6> extent{};
  letters->GetExtent(extent.data());
  const int x0 = static_cast<int>(std::lround(label.at.x));
  const int y0 = static_cast<int>(std::lround(label.at.y));
  const auto each = [&](auto paint) {
    for (int y = extent[2]; y <= extent[3]; ++y) {
      for (int x = extent[0]; x <= extent[1]; ++x) {
        const auto* rgba = static_cast<unsigned char*>(letters->GetScalarPointer(x, y, 0));
        if (rgba[3] != 0) paint(x0 + x, y0 - y, rgba[3] / 255.0);
      }
    }
  };
  if (label.halo) {
    each([&](int x, int y, double share) {
      for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
          if (dx * dx + dy * dy <= 5) image.blend(x + dx, y + dy, {255, 255, 255}, share * 0.6);
        }
      }
    });
  }
  each([&](int x, int y, double share) { image.blend(x, y, label.colour, share); });
}

}  // namespace

Status write_png(const PictureMesh& mesh, const PictureOptions& options, const std::string& path) {
  return memory_as_value(path, [&]() -> Status {
    Result<Drawing> drawing = compose(mesh, options);
    if (!drawing) return std::move(drawing).error();
    Image image = paint(*drawing);
    for (const DrawingItem& item : drawing->items) {
      if (const Label* label = std::get_if<Label>(&item)) draw(*label, image);
    }

    vtkNew<vtkImageData> pixels;
    pixels->SetDimensions(image.width, image.height, 1);
    pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int y = 0; y < image.height; ++y) {  // VTK counts rows from below
      const auto row = 3 * static_cast<std::size_t>(image.width);
      std::copy_n(
          image.rgb.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row), row,
          static_cast<std::uint8_t*>(pixels->GetScalarPointer(0, image.height - 1 - y, 0)));
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetWriteToMemory(1);
    writer->SetInputData(pixels);
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    if (writer->GetErrorCode() != 0 || bytes == nullptr) {
      return Error{ErrorCode::cannot_write, "cannot write '" + path + "' as PNG", {}, {}};
    }
    Result<AtomicFile> file = AtomicFile::create(path, options.stop);
    if (!file) return std::move(file).error();
    file->write({reinterpret_cast<const char*>(bytes->GetPointer(0)),
                 static_cast<std::size_t>(bytes->GetNumberOfValues())});
    return file->commit();
  });
}

}  // namespace cover
