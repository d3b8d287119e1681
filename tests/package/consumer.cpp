// What a user of the installed library writes: two materials in, a mesh and a file out.
#include <cstdio>

#include <cover/cover_mesh.hpp>
#include <cover/version.hpp>
#include <cover/write_mesh.hpp>

int main() {
  cover::Input input;
  input.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  for (const auto [a, b] :
       {std::pair{0U, 1U}, {1U, 2U}, {2U, 3U}, {3U, 4U}, {4U, 5U}, {5U, 0U}, {1U, 4U}}) {
    input.segments.push_back({a, b, 0, 0, 0, ""});
  }
  const auto output = cover::cover_mesh(input);
  if (!output) {
    std::fprintf(stderr, "%s\n", output.error().message.c_str());
    return 1;
  }
  const bool written = cover::write_vtu(*output, "consumer.vtu").has_value();
  std::printf("cover %s: %zu regions\n", COVER_VERSION, output->table.regions.size());
  return written && output->table.regions.size() == 2 ? 0 : 1;
}
