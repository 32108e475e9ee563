// What the ranks say to each other: bytes with a tag.
#pragma once

#include <mpi.h>

#include <optional>
#include <string>
#include <vector>

#include "engine/jobs/plan_runner.hpp"

namespace lober::cli {

enum class Tag : int {
  ready,    ///< worker: has nothing to do
  jobs,     ///< coordinator: do these; none: finish
  results,  ///< worker: these are done
  report,   ///< worker: has finished
};

struct Message {
  int rank;
  Tag tag;
  std::string bytes;
};

void send(int rank, Tag tag, const std::string& bytes);
/// Waits for a message.
[[nodiscard]] Message receive();
/// None if there is none yet.
[[nodiscard]] std::optional<Message> receive_if_any();
/// From rank 0 to all.
void broadcast(std::string& bytes);

[[nodiscard]] std::string encoded(const std::vector<PlanResult>& results);
[[nodiscard]] std::vector<PlanResult> decoded_results(const std::string& bytes);
[[nodiscard]] std::string encoded(const std::vector<std::uint32_t>& jobs);
[[nodiscard]] std::vector<std::uint32_t> decoded_jobs(const std::string& bytes);

}  // namespace lober::cli
