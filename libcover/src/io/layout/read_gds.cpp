// Tested by tests/unit/io/layout/read_gds_test.cpp.
#include "io/layout/read_gds.hpp"

#include "io/layout/flatten.hpp"
#include "io/layout/gds_library.hpp"
#include "io/layout/layer_map.hpp"

namespace cover {

Result<Input> parse_gds(std::string_view bytes, const std::string& source,
                        const ReadOptions& options) {
  Result<LayerMap> layers = LayerMap::make(options);
  if (!layers) return std::move(layers).error();
  const Result<GdsLibrary> library = parse_gds_library(bytes, source);
  if (!library) return library.error();
  return flatten(*library, source, options, *layers);
}

}  // namespace cover
