// Jobs that run an operation of the engine's table (lober/operations.hpp) on a system.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "engine/batch/operations/operation.hpp"
#include "lober/operations.hpp"

namespace lober::detail {

/// What a batch needs to know beside the table.
struct TableJob {
  using Names = std::vector<std::pair<std::string, std::string>>;
  std::string view;          ///< as Operation::view
  Names columns;             ///< names, and the paths of the numbers in the result
  Names lists;               ///< likewise
  bool needs_tangle = true;  ///< whether the system has to name one
  double microseconds = 0;   ///< as Operation::cost
  std::size_t memory = 0;    ///< as Operation::memory
};

/// An operation on a system: the system, its parameters and the tolerance of its integration are options of the job.
[[nodiscard]] Operation operation_of(const operations::Operation& entry, const TableJob& job);

}  // namespace lober::detail
