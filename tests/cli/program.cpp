#include "tests/cli/program.hpp"
#include "tests/cli/programs.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>

extern char** environ;

namespace lober::cli {
namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream content;
  content << file.rdbuf();
  return content.str();
}

}  // namespace

ProgramTest::ProgramTest() {
  std::string name = (std::filesystem::temp_directory_path() / "lober-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
  std::filesystem::create_directory(folder_ / ".streams");
}

ProgramTest::~ProgramTest() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

Outcome ProgramTest::run(const std::vector<std::string>& arguments) const {
  return run_other(LOBER_PROGRAM, arguments);
}

Outcome ProgramTest::run_in_bash(const std::string& line) const {
  const std::string begin = "PATH=" + std::filesystem::path(LOBER_PROGRAM).parent_path().string() + ":$PATH\n";
  return run_other("bash", {"--norc", "--noprofile", "-c", begin + line});
}

Outcome ProgramTest::run_other(const std::string& program, const std::vector<std::string>& arguments) const {
  std::string name = program;
  std::vector<char*> list{name.data()};
  std::vector<std::string> copies = arguments;
  for (std::string& argument : copies) list.push_back(argument.data());
  list.push_back(nullptr);

  const std::string out = folder_ / ".streams/out", err = folder_ / ".streams/err";
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder_.c_str());
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), flags, 0600);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, program.c_str(), &actions, nullptr, list.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error(program + " does not start");
  int status = 0;
  waitpid(process, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
}

Json ProgramTest::overlay(std::vector<std::string> arguments) const {
  return json_of("overlay", std::move(arguments));
}

Json ProgramTest::interior(std::vector<std::string> arguments) const {
  return json_of("interior", std::move(arguments));
}

Json ProgramTest::tangle(std::vector<std::string> arguments) const {
  return json_of("tangle", std::move(arguments));
}

Json ProgramTest::json_of(const std::string& command, std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), command);
  arguments.insert(arguments.end(), {"--json", "-"});
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return outcome.status == 0 ? Json::parse(outcome.out) : Json();
}

void ProgramTest::write(std::string_view name, std::string_view content) const {
  std::ofstream(folder_ / name, std::ios::binary) << content;
}

void ProgramTest::write_curve(std::string_view name, std::span<const Point> points) const {
  std::ofstream file(folder_ / name);
  file.precision(17);
  for (const Point& p : points) file << p.x << ' ' << p.y << '\n';
}

std::string ProgramTest::read(std::string_view name) const {
  return content_of(folder_ / name);
}

bool is_installed(const std::string& program) {
  std::istringstream folders(std::getenv("PATH"));  // NOLINT(concurrency-mt-unsafe): one thread
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (std::filesystem::exists(folder + "/" + program)) return true;
  }
  return false;
}

// NOLINTBEGIN(concurrency-mt-unsafe): one thread
Environment::Environment(const char* name, const char* value) : name_(name) {
  if (const char* const before = std::getenv(name)) before_ = before;
  value == nullptr ? unsetenv(name) : setenv(name, value, 1);
}
Environment::~Environment() {
  before_ ? setenv(name_.c_str(), before_->c_str(), 1) : unsetenv(name_.c_str());
}
// NOLINTEND(concurrency-mt-unsafe)

std::vector<Point> box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

std::set<std::string> members(const Json& object) {
  std::set<std::string> names;
  for (const auto& [name, value] : object.items()) names.insert(name);
  return names;
}

std::string without_timing(const std::string& json) {
  const std::size_t begin = json.rfind("\"timing\"");
  EXPECT_NE(begin, std::string::npos);
  return json.substr(0, begin);
}

std::vector<Point> flower(std::size_t points, int petals, double depth, Point centre) {
  std::vector<Point> curve(points);
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
    const double radius = 1 + depth * std::sin(petals * angle);
    curve[k] = {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
  }
  return curve;
}

}  // namespace lober::cli
