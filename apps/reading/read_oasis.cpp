// KLayout runs as a process of its own, without a shell. Tested by tests/cli/layouts_test.py.
#include "read_oasis.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <stop_token>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cover/files.hpp>
#include <cover/read_input.hpp>
#include <cover/text.hpp>

#include "remover.hpp"

extern char** environ;

namespace cover::reading {
namespace {

namespace fs = std::filesystem;

/// A folder below that for temporary files.
Result<ScratchFolder> scratch_folder() {
  std::error_code ignored;
  return ScratchFolder::beside((fs::temp_directory_path(ignored) / "cover-oasis").string());
}

enum class Ended { well, badly, not_there, interrupted };

/// Where Debian's package has the tools, with the libraries that they need and do not find.
constexpr const char* kDebiansTool = "/usr/lib/klayout/strm2gds";
constexpr const char* kDebiansLibraries = "LD_LIBRARY_PATH=/usr/lib/klayout";

/// Runs a program of the PATH to its end, or until `stop` asks for that, with `setting` before all
/// else in its environment; what it says goes to the file `log`.
Ended run(std::vector<std::string> words, const std::string& log, const std::stop_token& stop,
          const char* setting = nullptr) {
  std::string first = setting != nullptr ? setting : "";
  std::vector<char*> settings;
  if (setting != nullptr) settings.push_back(first.data());
  for (char** one = environ; *one != nullptr; ++one) settings.push_back(*one);
  settings.push_back(nullptr);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   S_IRUSR | S_IWUSR);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  // The program that reads may wait for its signals in a thread; this one heeds its own.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t process = 0;
  const int failed = ::posix_spawnp(&process, arguments[0], &files, &attributes, arguments.data(),
                                    settings.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) return failed == ENOENT || failed == EACCES ? Ended::not_there : Ended::badly;
  {
    const std::stop_callback end(stop, [process] { ::kill(process, SIGKILL); });
    // Until it is waited for below, its number is that of no other process.
    siginfo_t ended{};
    while (::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT) < 0)
      if (errno != EINTR) return Ended::badly;
  }
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return Ended::badly;
  // A terminal's Ctrl-C goes to all of its programs, and this one may be the first that it ends.
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (stop.stop_requested() || signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
    return Ended::interrupted;
  // What posix_spawn() of some systems says where there is no such program.
  constexpr int kNotThere = 127;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotThere) return Ended::not_there;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ended::well : Ended::badly;
}

/// The first line that says something.
std::string first_line(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \r\n");
  if (begin == std::string::npos) return "it says nothing";
  constexpr std::size_t kMost = 200;
  return printable(text.substr(begin, std::min(kMost, text.find('\n', begin) - begin)));
}

}  // namespace

bool is_oasis(std::string_view extension) { return extension == ".oas" || extension == ".oasis"; }

Result<Input> read_oasis(const std::string& path, const ReadOptions& options,
                         const std::stop_token& stop) {
  const auto error = [&](ErrorCode code, const std::string& what) {
    return Error{code, path + ": " + what, {}, {}};
  };
  // Its own message would speak of a file that cannot be opened, too, but after a second.
  if (const Result<std::string> there = read_file(path); !there) return there.error();
  const Result<ScratchFolder> folder = scratch_folder();
  if (!folder)
    return error(ErrorCode::cannot_write,
                 "no folder for the layout as GDSII: " + folder.error().message);
  // mpirun kills its ranks: none of them has the time to remove it itself.
  const Remover remover(folder->path());
  const std::string from = fs::absolute(path), to = folder->path() / "layout.gds",
                    log = folder->path() / "log", script = folder->path() / "convert.rb";
  Ended ended = run({"strm2gds", from, to}, log, stop);
  if (ended == Ended::not_there)
    ended = run({kDebiansTool, from, to}, log, stop, kDebiansLibraries);
  if (ended == Ended::not_there) {
    const Status written =
        replace_file(script, "l = RBA::Layout::new\nl.read($from)\nl.write($to)\n");
    if (!written) return written.error();
    ended =
        run({"klayout", "-b", "-r", script, "-rd", "from=" + from, "-rd", "to=" + to}, log, stop);
  }
  if (ended == Ended::interrupted) return Error{ErrorCode::cancelled, "interrupted", {}, {}};
  if (ended == Ended::not_there)
    return error(ErrorCode::unsupported_format,
                 "OASIS is read by way of KLayout, which is not installed (Debian's package "
                 "klayout); its strm2gds, or klayout itself, is looked for on the PATH");
  std::error_code ignored;
  if (ended == Ended::badly || !fs::is_regular_file(to, ignored)) {
    const Result<std::string> said = read_file(log);
    return error(ErrorCode::syntax,
                 "KLayout makes no GDSII of it: " + first_line(said ? *said : std::string()));
  }
  const Result<std::string> bytes = read_file(to);
  if (!bytes) return bytes.error();
  ReadOptions of_layout = options;
  of_layout.format = ".gds";
  return parse_input(*bytes, ".gds", path, of_layout);
}

}  // namespace cover::reading
