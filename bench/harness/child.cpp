#include "bench/harness/child.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "bench/harness/measure.hpp"
#include "bench/harness/memory.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

struct ChildOutcome {
  std::string output;
  std::string failure;  ///< empty when it ended by itself with status 0
};

// Reads until the other end is closed; false when `limit` seconds have passed.
bool read_all(int pipe, double limit, std::string& output) {
  const Stopwatch watch;
  for (;;) {
    const double left = limit - watch.seconds();
    if (left <= 0) return false;
    pollfd ready{pipe, POLLIN, 0};
    const int events = poll(&ready, 1, static_cast<int>(left * 1000) + 1);
    if (events == 0 || (events < 0 && errno == EINTR)) continue;
    char buffer[4096];
    const ssize_t count = read(pipe, buffer, sizeof buffer);
    if (count <= 0) return true;
    output.append(buffer, static_cast<std::size_t>(count));
  }
}

std::string describe(int status) {
  if (WIFSIGNALED(status)) return std::string("crashed: ") + strsignal(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0) return "failed with status " + std::to_string(WEXITSTATUS(status));
  return {};
}

ChildOutcome start_self(const std::vector<std::string>& arguments, double limit) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
  std::vector<std::string> copies{"bench_overlay"};
  copies.insert(copies.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& copy : copies) pointers.push_back(copy.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    execv("/proc/self/exe", pointers.data());
    _exit(127);
  }
  close(ends[1]);
  ChildOutcome outcome;
  const bool ended = read_all(ends[0], limit, outcome.output);
  close(ends[0]);
  if (!ended) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  outcome.failure = describe(status);
  if (!ended) {
    std::ostringstream text;
    text << "not done after " << limit << " s";
    outcome.failure = text.str();
  }
  return outcome;
}

std::vector<std::string> child_arguments(std::string_view what, const SceneKind& scene, std::size_t points) {
  return {"--child", std::string(what), "--scenes", std::string(scene.name), "--n", std::to_string(points)};
}

void print(const RivalResult& result) {
  std::cout << std::setprecision(17) << result.ran << ' ' << result.seconds << ' ' << result.intersection_seconds;
  for (const double area : result.areas) std::cout << ' ' << area;
  for (const std::size_t pieces : result.pieces) std::cout << ' ' << pieces;
  std::cout << ' ' << result.note << std::endl;
}

bool parse(const std::string& line, RivalResult& result) {
  std::istringstream stream(line);
  stream >> result.ran >> result.seconds >> result.intersection_seconds;
  for (double& area : result.areas) stream >> area;
  for (std::size_t& pieces : result.pieces) stream >> pieces;
  stream.get();
  const bool complete = !stream.fail();
  std::getline(stream, result.note);
  return complete;
}

// A library that asks for more than this is stopped rather than the machine.
void limit_memory() {
  constexpr rlim_t most = rlim_t{12} << 30;
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
}

}  // namespace

RivalResult run_rival_apart(const Rival& rival, const SceneKind& scene, std::size_t points, double limit) {
  RivalResult result;
  if (points > rival.largest) {
    result.note = "not tried beyond " + std::to_string(rival.largest) + " points";
    return result;
  }
  const ChildOutcome outcome = start_self(child_arguments(rival.name, scene, points), limit);
  if (!outcome.failure.empty()) {
    result.note = outcome.failure;
  } else if (!parse(outcome.output, result)) {
    result = {};
    result.note = "no result";
  }
  return result;
}

double memory_per_point(const SceneKind& scene, std::size_t points) {
  const ChildOutcome outcome = start_self(child_arguments("memory", scene, points), 600);
  if (!outcome.failure.empty()) throw std::runtime_error("measuring memory: " + outcome.failure);
  return std::stod(outcome.output);
}

int run_as_child(const Options& options) {
  const SceneKind& kind = *options.scenes.front();
  if (options.child == "memory") {
    std::cout << measure_memory(kind, options.points) << std::endl;
    return 0;
  }
  for (const Rival& rival : rivals()) {
    if (rival.name != options.child) continue;
    limit_memory();
    const Scene scene = kind.make(options.points);
    print(rival.run(scene.first, scene.second));
    return 0;
  }
  return 2;
}

}  // namespace lober::bench
