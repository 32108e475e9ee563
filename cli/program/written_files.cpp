#include "cli/program/written_files.hpp"

#include <spdlog/fmt/fmt.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "cli/program/terminal.hpp"
#include "cli/report/report.hpp"

namespace lober::cli {
namespace {

/// By the ending of the name. "{}" stands for the name.
struct NextStep {
  std::string_view ending, hint;
};
constexpr std::array<NextStep, 5> next_steps{{{".svg", "open it in a web browser"},
                                              {".html", "open it in a web browser, or see lober view --help"},
                                              {".vtk", "open it in ParaView"},
                                              {".results", "lober batch export {} writes its table"},
                                              {".jsonl", "each line is an object of JSON"}}};

// A file that is replaced has another number, one that goes on has another time or size.
using State = std::tuple<::ino_t, long, long, ::off_t>;
State state_of(const std::string& path) {
  struct ::stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size};
}

struct Expected {
  std::string option, path;
  State before;
  std::string content;
};

std::vector<Expected>& expected_files() {
  static std::vector<Expected> files;
  return files;
}

std::string size_text(::off_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size < 1e3) return fmt::format("{} bytes", bytes);
  if (size < 1e6) return fmt::format("{:.3g} kB", size / 1e3);
  return size < 1e9 ? fmt::format("{:.3g} MB", size / 1e6) : fmt::format("{:.3g} GB", size / 1e9);
}

std::string hint_for(const std::string& path) {
  const auto step = std::find_if(next_steps.begin(), next_steps.end(),
                                 [&](const NextStep& one) { return path.ends_with(one.ending); });
  if (step == next_steps.end()) return {};
  std::string hint(step->hint);
  if (const std::size_t at = hint.find("{}"); at != std::string::npos) hint.replace(at, 2, path);
  return "; " + hint;
}

}  // namespace

void expect_written(const std::string& option, const std::string& path) {
  std::vector<Expected>& files = expected_files();
  const bool is_known =
      std::any_of(files.begin(), files.end(), [&](const Expected& file) { return file.path == path; });
  if (!is_known) files.push_back({option, path, state_of(path), {}});
}

void note_curves_written(const std::string& path, std::size_t curves, std::size_t points) {
  for (Expected& file : expected_files()) {
    if (file.path != path) continue;
    file.content = file.option == "--lobes" ? counted(curves, "lobe", "lobes") : counted(curves, "curve", "curves");
    file.content += ", " + counted(points, "point", "points");
  }
}

std::string written_files_text() {
  constexpr std::size_t max_lines = 12;
  std::vector<std::string> lines;
  for (const Expected& file : expected_files()) {
    const State now = state_of(file.path);
    if (now == State{} || now == file.before) continue;
    lines.push_back(fmt::format("wrote {} ({}){}\n", printable(file.path),
                                file.content.empty() ? size_text(std::get<3>(now)) : file.content,
                                printable(hint_for(file.path))));
  }
  std::string text;
  for (std::size_t k = 0; k < std::min(max_lines, lines.size()); ++k) text += lines[k];
  if (lines.size() > max_lines) text += fmt::format("and wrote {} more files\n", lines.size() - max_lines);
  return text;
}

}  // namespace lober::cli
