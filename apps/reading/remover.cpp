// Tested by tests/cli/layouts_test.py and tests/mpi/mpi_test.py.
#include "remover.hpp"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cover::reading {
namespace {

/// Twice, since a program that still writes into the folder may be in its way once: it is killed at
/// the same time, or finds no folder the next time.
constexpr const char* kScript = R"(read -r _; rm -rf -- "$1" || rm -rf -- "$1")";

/// The shell, with `input` as its standard input; -1 where it cannot be started.
pid_t start_shell(std::string folder, int input) {
  std::string name = "sh", option = "-c", script = kScript, path = "PATH=/usr/bin:/bin";
  const std::array<char*, 6> words{name.data(), option.data(), script.data(),
                                   name.data(), folder.data(), nullptr};
  const std::array<char*, 2> settings{path.data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  // Who reads what this process says until nobody can say more is not kept waiting.
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
  pid_t process = -1;
  const int failed =
      ::posix_spawn(&process, "/bin/sh", &files, &attributes, words.data(), settings.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return failed == 0 ? process : -1;
}

}  // namespace

Remover::Remover(const std::string& folder) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
  shell_ = start_shell(folder, ends[0]);
  ::close(ends[0]);
  end_ = ends[1];
}

Remover::~Remover() {
  // A process forked meanwhile, as by Python, may hold this end open, too.
  if (end_ >= 0) {
    (void)::send(end_, "\n", 1, MSG_NOSIGNAL);
    ::close(end_);
  }
  int status = 0;
  while (shell_ >= 0 && ::waitpid(shell_, &status, 0) < 0)
    if (errno != EINTR) break;
}

}  // namespace cover::reading
