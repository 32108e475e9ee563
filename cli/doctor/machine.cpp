#include "cli/doctor/machine.hpp"

#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>

#include "engine/base/machine_memory.hpp"

namespace lober::cli {
namespace {

// Empty where the file cannot be read.
std::string content_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// The number that the text begins with; none for "max" and for a file that is not there.
std::optional<std::int64_t> number_in(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end != text.data() ? std::optional(number) : std::nullopt;
}

template <typename Number>
void lower(std::optional<Number>& limit, Number to) {
  limit = limit ? std::min(*limit, to) : to;
}

void add_memory_limit(GroupLimits& limits, const std::string& file) {
  constexpr std::int64_t unlimited = std::int64_t{1} << 60;  // version 1 writes a number of this kind for no limit
  const std::optional<std::int64_t> bytes = number_in(content_of(file));
  if (bytes && *bytes > 0 && *bytes < unlimited) lower(limits.memory, static_cast<std::uint64_t>(*bytes));
}

void add_processor_limit(GroupLimits& limits, std::optional<std::int64_t> quota, std::optional<std::int64_t> period) {
  if (!quota || !period || *quota <= 0 || *period <= 0) return;
  lower(limits.processors, static_cast<double>(*quota) / static_cast<double>(*period));
}

// Limits of one group, of either version of control groups.
void add_limits(GroupLimits& limits, const std::string& folder) {
  add_memory_limit(limits, folder + "/memory.max");
  add_memory_limit(limits, folder + "/memory.limit_in_bytes");
  const std::string both = content_of(folder + "/cpu.max");  // "200000 100000"
  const std::size_t blank = std::min(both.find(' '), both.size());
  add_processor_limit(limits, number_in(both),
                      number_in(std::string_view(both).substr(std::min(blank + 1, both.size()))));
  add_processor_limit(limits, number_in(content_of(folder + "/cpu.cfs_quota_us")),
                      number_in(content_of(folder + "/cpu.cfs_period_us")));
}

std::string line_behind(const std::string& text, const std::string& key) {
  const std::size_t at = text.find(key);
  if (at == std::string::npos) return {};
  const std::size_t begin = text.find_first_not_of(": \t", at + key.size());
  return begin == std::string::npos ? std::string() : text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

GroupLimits group_limits(const std::string& root, const std::string& groups) {
  GroupLimits limits;
  std::istringstream lines(groups);
  for (std::string line; std::getline(lines, line);) {  // "4:memory:/a/b" of version 1, "0::/a/b" of version 2
    const std::size_t first = line.find(':'), second = line.find(':', std::min(first, line.size()) + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    std::string mount = root;
    if (!controllers.empty()) mount.append("/").append(controllers);
    std::string path = line.substr(second + 1);
    while (!path.empty() && path != "/") {
      add_limits(limits, mount + path);
      const std::size_t slash = path.rfind('/');
      path.erase(slash == std::string::npos ? 0 : slash);
    }
    add_limits(limits, mount);
  }
  return limits;
}

Machine this_machine() {
  Machine machine;
  utsname name{};
  if (uname(&name) == 0) machine.system = std::string(name.sysname) + " " + name.release + " " + name.machine;
  machine.processor = line_behind(content_of("/proc/cpuinfo"), "model name");
  machine.processors = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  cpu_set_t set;
  CPU_ZERO(&set);
  machine.allowed = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : machine.processors;
  machine.memory = detail::machine_memory();
  if (const auto kilobytes = number_in(line_behind(content_of("/proc/meminfo"), "MemAvailable"))) {
    machine.available = static_cast<std::uint64_t>(*kilobytes) * 1024;
  }
  const GroupLimits limits = group_limits("/sys/fs/cgroup", content_of("/proc/self/cgroup"));
  machine.memory_limit = limits.memory;
  machine.processor_limit = limits.processors;
  return machine;
}

}  // namespace lober::cli
