// The machine, and the limits that a container or a job sets.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lober::cli {

struct Machine {
  std::string system;                         ///< "Linux 6.1.0 x86_64"
  std::string processor;                      ///< name of the processor; empty where it is not known
  int processors = 1;                         ///< number in the machine
  int allowed = 1;                            ///< processors that this process may run on
  std::uint64_t memory = 0, available = 0;    ///< bytes; available: without swapping, 0 where it is not known
  std::optional<std::uint64_t> memory_limit;  ///< limit of the control groups, in bytes
  std::optional<double> processor_limit;      ///< limit of the control groups, in processors
};

[[nodiscard]] Machine this_machine();

/// The least limits of a control group and those above it. `root` is where control groups are mounted, `groups` the
/// text of /proc/self/cgroup; both versions of control groups are understood.
struct GroupLimits {
  std::optional<std::uint64_t> memory;
  std::optional<double> processors;
};
[[nodiscard]] GroupLimits group_limits(const std::string& root, const std::string& groups);

}  // namespace lober::cli
