#include "tests/cli/background.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <stdexcept>

extern char** environ;

namespace lober::cli {

pid_t start_in(const std::filesystem::path& folder, const std::vector<std::string>& command) {
  std::vector<std::string> copies = command;
  std::vector<char*> list;
  for (std::string& argument : copies) list.push_back(argument.data());
  list.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  for (const int stream : {1, 2}) posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  // Shells ignore interrupts in what they run in the background, and so would the program until it asks for them.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t answered;
  sigemptyset(&answered);
  sigaddset(&answered, SIGINT);
  posix_spawnattr_setsigdefault(&attributes, &answered);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, list[0], &actions, &attributes, list.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error(command[0] + " does not start");
  return process;
}

int wait_for(pid_t process) {
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace lober::cli
