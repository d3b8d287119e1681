// Any bytes as a drawing: an Input or an error, never a crash, a hang or a huge allocation.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <cover/read_dxf.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const char* label_layer : {"", "labels"}) {
    cover::ReadOptions options;
    options.label_layer = label_layer;
    const auto input = cover::parse_dxf(text, "fuzz.dxf", options);
    if (!input) {
      if (input.error().message.empty()) std::abort();
      continue;
    }
    const auto points = input->points.size();
    for (const auto& s : input->segments)
      if (s.a >= points || s.b >= points) std::abort();
  }
  return 0;
}
