// Any bytes as a geometry file: an Input or an error, never a crash, a hang or a huge allocation.
// COVER_FUZZ_FORMAT is the extension that names the format.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <cover/read_input.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  cover::ReadOptions options;
  options.keep_fields = {"fid"};  // of maps
  const auto input = cover::parse_input(text, COVER_FUZZ_FORMAT, "/nonexistent/fuzz", options);
  if (!input) {
    if (input.error().message.empty()) std::abort();
    return 0;
  }
  // Indices are in range whatever the file says.
  const auto points = input->points.size();
  for (const auto& s : input->segments)
    if (s.a >= points || s.b >= points) std::abort();
  for (const auto& polygon : input->polygons)
    for (const auto& attribute : input->attributes)
      if (polygon.feature < 1 || polygon.feature > attribute.values.size()) std::abort();
  if (!input->point_ids.empty() && input->point_ids.size() != points) std::abort();
  return 0;
}
