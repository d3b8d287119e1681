// A long run that is watched, and stopped half way.
#include <cover/cover_mesh.hpp>

#include <cstdio>
#include <stop_token>

int main() {
  // A board of 60 x 60 squares, each a region.
  cover::Input input;
  constexpr std::uint32_t kSquares = 60, kPoints = kSquares + 1;
  for (std::uint32_t y = 0; y < kPoints; ++y) {
    for (std::uint32_t x = 0; x < kPoints; ++x) {
      const std::uint32_t here = y * kPoints + x;
      input.points.push_back({double(x), double(y)});
      if (x + 1 < kPoints) input.segments.push_back({.a = here, .b = here + 1});
      if (y + 1 < kPoints) input.segments.push_back({.a = here, .b = here + kPoints});
    }
  }

  std::stop_source stop;
  std::size_t calls = 0;
  cover::Callbacks callbacks;
  callbacks.stop = stop.get_token();
  callbacks.progress = [&](const cover::Progress& step) {
    ++calls;  // called from one thread at a time
    if (step.stage == "mesh" && 2 * step.done >= step.total) stop.request_stop();
  };
  const auto output = cover::cover_mesh(input, {}, callbacks);
  if (output) {
    std::fprintf(stderr, "the run was not stopped\n");
    return 1;
  }
  std::printf("after %s calls: %s\n", calls > 0 ? "some" : "no", output.error().message.c_str());
  return output.error().code == cover::ErrorCode::cancelled ? 0 : 1;
}
