// Runs the program in a folder of its own and returns what came out.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/point.hpp"

namespace lober::cli {
using namespace lober::detail;

using Json = nlohmann::json;

struct Outcome {
  int status;  ///< exit status; -1 if a signal ended the program
  std::string out, err;
};

/// A test with an empty current folder, removed at its end.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  /// Runs `lober` with these arguments in `folder()`.
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const;
  /// Runs another program, which is searched for in PATH.
  [[nodiscard]] Outcome run_other(const std::string& program, const std::vector<std::string>& arguments) const;
  /// Runs a command line in bash, where `lober` is the program under test.
  [[nodiscard]] Outcome run_in_bash(const std::string& line) const;

  /// Runs `lober overlay` with --json - and parses what it prints. Fails the test when the program does.
  [[nodiscard]] Json overlay(std::vector<std::string> arguments) const;
  /// The same for `lober interior` and `lober tangle`.
  [[nodiscard]] Json interior(std::vector<std::string> arguments) const;
  [[nodiscard]] Json tangle(std::vector<std::string> arguments) const;

  void write(std::string_view name, std::string_view content) const;
  void write_curve(std::string_view name, std::span<const Point> points) const;
  [[nodiscard]] std::string read(std::string_view name) const;
  [[nodiscard]] bool exists(std::string_view name) const { return std::filesystem::exists(folder_ / name); }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  [[nodiscard]] Json json_of(const std::string& command, std::vector<std::string> arguments) const;

  std::filesystem::path folder_;
};

/// Whether a program is installed.
[[nodiscard]] bool is_installed(const std::string& program);

/// Sets a variable of the environment of the program under test, as long as it lives; null: takes it away.
class Environment {
 public:
  Environment(const char* name, const char* value);
  ~Environment();
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::string name_;
  std::optional<std::string> before_;
};

[[nodiscard]] std::vector<Point> box(double left, double low, double right, double high);

/// The names of the members of an object.
[[nodiscard]] std::set<std::string> members(const Json& object);

/// The JSON up to its last member, `timing`.
[[nodiscard]] std::string without_timing(const std::string& json);

/// A wavy circle about `centre`.
[[nodiscard]] std::vector<Point> flower(std::size_t points, int petals, double depth, Point centre);

}  // namespace lober::cli
