#include <cover/regions.hpp>
#include <cover/text.hpp>

#include <fmt/core.h>

namespace cover {

std::string describe(double x) { return fmt::format("{}", x); }

std::string describe_roughly(double x) { return fmt::format("{:.3g}", x); }

std::string describe(Point p) { return fmt::format("({}, {})", p.x, p.y); }

std::string describe(InterfaceKind kind) {
  switch (kind) {
    case InterfaceKind::interface:
      return "interface";
    case InterfaceKind::outline:
      return "outline";
    case InterfaceKind::slit:
      return "slit";
    case InterfaceKind::contact:
      return "contact";
  }
  return "";
}

std::string listed(std::span<const std::string> items, std::string_view separator) {
  std::string text;
  for (const std::string& item : items) {
    if (&item != items.data()) text += separator;
    text += item;
  }
  return text;
}

std::string counted(std::size_t n, std::string_view singular) {
  return fmt::format("{} {}{}", n, singular, n == 1 ? "" : "s");
}

}  // namespace cover
