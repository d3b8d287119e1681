#include "support/inputs/soups.hpp"

#include <algorithm>

#include "clean/pslg.hpp"

namespace cover::testing {

InputPolygon& add_polygon(Input& input, const Loop& ring, const std::string& material,
                          const std::string& region) {
  InputPolygon polygon;
  polygon.rings = {ring};
  polygon.material = material;
  polygon.region = region;
  polygon.id = static_cast<long>(input.polygons.size() + 1);
  input.polygons.push_back(std::move(polygon));
  return input.polygons.back();
}

Loop rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

double Cleaned::area(const std::string& material) const {
  double sum = 0;
  for (const Region& r : table.regions) sum += r.material_name == material ? r.area : 0;
  return sum;
}

bool Cleaned::tells(const std::string& words) const {
  const auto has = [&](const auto& x) { return x.message.find(words) != std::string::npos; };
  return std::any_of(report.changes.begin(), report.changes.end(), has) ||
         std::any_of(report.notes.begin(), report.notes.end(), has);
}

Result<Cleaned> clean(const Input& input, const Options& options) {
  Cleaned out;
  auto pslg = make_pslg(input, options, out.report);
  if (!pslg) return pslg.error();
  out.pslg = std::move(*pslg);
  auto table = build_region_table(out.pslg, options, out.report.notes);
  if (!table) return table.error();
  out.table = std::move(*table);
  return out;
}

}  // namespace cover::testing
