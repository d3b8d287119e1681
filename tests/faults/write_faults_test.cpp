// Every call that writes files fails once, and every one is once the last: what was there stays
// whole, or the new is whole, and the next run leaves nothing else.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/picture.hpp>
#include <cover/write_mesh.hpp>

#include "failing_calls.hpp"
#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

/// All files below a folder, by their names in it.
using Files = std::map<std::string, std::string>;

Files files_in(const fs::path& folder) {
  Files files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    std::ostringstream text;
    if (entry.is_regular_file()) text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    files[fs::relative(entry.path(), folder).string()] = entry.is_directory() ? "/" : text.str();
  }
  return files;
}

void put(const Files& files, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const auto& [name, text] : files) {
    if (text == "/") fs::create_directories(folder / name);
  }
  for (const auto& [name, text] : files) {
    if (text != "/") std::ofstream(folder / name, std::ios::binary) << text;
  }
}

/// The pieces that a .vtm or a .pvtu names.
std::vector<std::string> named_in(const std::string& vtm) {
  std::vector<std::string> names;
  for (const std::string start : {"file=\"", "Piece Source=\""}) {
    for (std::size_t at = vtm.find(start); at != vtm.npos; at = vtm.find(start, at + 1)) {
      at += start.size();
      names.push_back(vtm.substr(at, vtm.find('"', at) - at));
    }
  }
  return names;
}

/// Whether a name is that of the pieces' folder or lies in it.
bool is_of_pieces(const std::string& name) {
  return name == "m" || name.starts_with("m/") || name == "m.parts" || name.starts_with("m.parts/");
}

/// Whether `name` and the pieces that it names are those of one of the meshes.
bool is_whole(const Files& now, const std::string& name, const std::vector<const Files*>& meshes) {
  for (const Files* mesh : meshes) {
    if (!mesh->contains(name) || mesh->at(name) != now.at(name)) continue;
    bool whole = true;
    for (const std::string& piece : named_in(now.at(name)))
      whole =
          whole && now.contains(piece) && mesh->contains(piece) && mesh->at(piece) == now.at(piece);
    if (whole) return true;
  }
  return false;
}

Output mesh_of(std::uint64_t seed) {
  Options options;
  options.threads = 1;
  Result<Output> output = cover_mesh(testing::checker(2, 2, seed), options);
  EXPECT_TRUE(output);
  // Times differ from run to run, and with them reports.
  output->report.times.clear();
  for (RegionReport& region : output->report.regions) region.seconds = 0;
  return std::move(output).value();
}

using Write = std::function<Status(const Output&, const std::string&)>;

struct Case {
  std::string extension;
  Write write;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::string& extension : write_formats()) {
    all.push_back({extension, [](const Output& output, const std::string& path) {
                     return write_mesh(output, path);
                   }});
  }
  all.push_back({".report.json", [](const Output& output, const std::string& path) {
                   return write_report_json(output, path);
                 }});
  all.push_back({".svg", [](const Output& output, const std::string& path) {
                   return write_svg(picture_of(output), {}, path);
                 }});
  all.push_back({".png", [](const Output& output, const std::string& path) {
                   PictureOptions small;
                   small.width = 500;
                   return write_png(picture_of(output), small, path);
                 }});
  return all;
}

class WriteFaults : public ::testing::TestWithParam<Case> {
 protected:
  /// The files that writing `output` into an empty folder makes.
  Files written(const Output& output) {
    put({}, place_);
    EXPECT_TRUE(GetParam().write(output, path_));
    return files_in(place_);
  }

  /// Every name that the meshes have is there and whole.
  void expect_whole(const Files& before, const Files& old_mesh, const Files& new_mesh) {
    const Files now = files_in(place_);
    for (const auto& [name, text] : before) {
      if (!is_of_pieces(name)) {
        ASSERT_TRUE(now.contains(name)) << name << " is lost";
      }
    }
    for (const auto& [name, text] : now) {
      const bool is_output = (old_mesh.contains(name) || new_mesh.contains(name)) && text != "/";
      if (is_output && !is_of_pieces(name)) {
        ASSERT_TRUE(is_whole(now, name, {&old_mesh, &new_mesh})) << name << " is neither";
      }
    }
  }

  /// The next run, which nothing hinders; it leaves what the mesh has and nothing else.
  void expect_next_run_makes(const Output& output, const Files& mesh) {
    testing::fail_call(0, 0);
    const Status status = GetParam().write(output, path_);
    testing::end_of_failures();
    ASSERT_TRUE(status) << status.error().message;
    ASSERT_EQ(files_in(place_), mesh);
  }

  testing::TemporaryFolder folder_;
  fs::path place_ = folder_.path() / "place";
  std::string path_ = place_ / ("m" + GetParam().extension);
};

TEST_P(WriteFaults, LoseNothing) {
  const Output old_output = mesh_of(1), new_output = mesh_of(2);
  const Files old_mesh = written(old_output), new_mesh = written(new_output);
  ASSERT_NE(old_mesh, new_mesh);
  const Files nothing;
  int most = 0;
  for (const Files* before : {&old_mesh, &nothing}) {
    put(*before, place_);
    testing::fail_call(0, 0);
    ASSERT_TRUE(GetParam().write(new_output, path_));
    const int calls = testing::end_of_failures();
    most = std::max(most, calls);
    for (int n = 1; n <= calls; ++n) {
      for (const int error : {ENOSPC, EIO, EACCES}) {
        SCOPED_TRACE(::testing::Message() << "call " << n << " of " << calls << ", errno " << error
                                          << (before->empty() ? ", nothing before" : ""));
        put(*before, place_);
        testing::fail_call(n, error);
        const Status status = GetParam().write(new_output, path_);
        testing::end_of_failures();
        expect_whole(*before, old_mesh, new_mesh);
        const Files now = files_in(place_);
        if (!status) {
          EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
          EXPECT_NE(status.error().message.find((place_ / "m").string()), std::string::npos)
              << status.error().message;
        } else {
          for (const auto& [name, text] : new_mesh) EXPECT_EQ(now.at(name), text) << name;
        }
        expect_next_run_makes(new_output, new_mesh);
      }
    }
    for (int n = 1; n <= calls; ++n) {
      SCOPED_TRACE(::testing::Message() << "killed at call " << n << " of " << calls);
      put(*before, place_);
      const pid_t child = fork();
      if (child == 0) {
        testing::fail_call(n, 0);
        _exit(GetParam().write(new_output, path_) ? 0 : 1);
      }
      int ended = 0;
      waitpid(child, &ended, 0);
      ASSERT_TRUE(WIFEXITED(ended));
      EXPECT_EQ(WEXITSTATUS(ended), testing::kKilled);
      expect_whole(*before, old_mesh, new_mesh);
      expect_next_run_makes(new_output, new_mesh);
    }
  }
  EXPECT_GE(most, 5) << "opened, locked, written, synced, renamed";
}

/// Triangle's files name no others, so nothing could tell a mixture of two meshes.
TEST(WriteTriangleFaults, MixNoMeshesUnlessARenameFails) {
  const testing::TemporaryFolder folder;
  const fs::path place = folder.path() / "place";
  const std::string path = place / "m.ele";
  const Output old_output = mesh_of(1), new_output = mesh_of(2);
  put({}, place);
  ASSERT_TRUE(write_mesh(old_output, path));
  const Files old_mesh = files_in(place);
  testing::fail_call(0, 0);
  ASSERT_TRUE(write_mesh(new_output, path));
  const int calls = testing::end_of_failures();
  const Files new_mesh = files_in(place);
  ASSERT_EQ(new_mesh.size(), 3U);
  int mixtures = 0, killed = 0;
  for (int n = 1; n <= calls; ++n) {
    put(old_mesh, place);
    testing::fail_call(n, ENOSPC);
    (void)write_mesh(new_output, path);
    testing::end_of_failures();
    const Files now = files_in(place);
    mixtures += now != old_mesh && now != new_mesh ? 1 : 0;
    put(old_mesh, place);
    const pid_t child = fork();
    if (child == 0) {
      testing::fail_call(n, 0);
      _exit(write_mesh(new_output, path) ? 0 : 1);
    }
    int ended = 0;
    waitpid(child, &ended, 0);
    const Files left = files_in(place);
    const auto stays = [&left](const auto& file) {
      return left.contains(file.first) && left.at(file.first) == file.second;
    };
    killed += !std::all_of(old_mesh.begin(), old_mesh.end(), stays) &&
                      !std::all_of(new_mesh.begin(), new_mesh.end(), stays)
                  ? 1
                  : 0;
  }
  EXPECT_GT(calls, 12);
  EXPECT_LE(mixtures, 2) << "one for each rename after the first";
  EXPECT_LE(killed, 2) << "one for each rename after the first";
}

std::string name_of(const ::testing::TestParamInfo<Case>& test) {
  std::string name = test.param.extension.substr(1);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, WriteFaults, ::testing::ValuesIn(cases()), name_of);

}  // namespace
}  // namespace cover
