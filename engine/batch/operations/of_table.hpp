// Jobs that run an operation of the engine's table (lober/operations.hpp) on a system or on curves.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/batch/operations/operation.hpp"
#include "lober/operations.hpp"

namespace lober::detail {

/// Facts about an operation that a batch needs beside the table.
struct TableJob {
  using Names = std::vector<std::pair<std::string, std::string>>;
  std::string view;          ///< as Operation::view
  Names columns;             ///< names, and the paths of the numbers in the result
  Names lists;               ///< likewise
  bool needs_tangle = true;  ///< whether the system has to name one
  double microseconds = 0;   ///< time of a usual job, as Operation::cost
  double microseconds_a_point = 0;
  std::size_t memory = 0;  ///< as Operation::memory
  /// An option of jobs alone, a flag: whether to keep the lists.
  std::optional<OptionSpec> lists_if{};
  /// Flags whose results no column or list has: jobs that set them are refused.
  std::vector<std::string> not_kept{};
  /// The curve that comes out, for a file that the option "output" of the job names; empty: there are no files.
  std::function<std::span<const Point>(const operations::Outcome&)> points{};
};

/// An operation on a system: the system, its parameters and the tolerance of its integration are options of the job. Or
/// on curves: they are simple where the option check_simple asks for it.
[[nodiscard]] Operation operation_of(const operations::Operation& entry, const TableJob& job);

/// For an operation of which a batch knows no more than its description: the numbers of the result are columns, those
/// of lists are lists, named as their paths with underscores; the view is its name with an s.
[[nodiscard]] TableJob job_as_described(const operations::Operation& entry);

/// The names of the seven areas, `prefix` before each, with the paths of the members of the object at `path`.
void add_areas(TableJob::Names& columns, const std::string& prefix, const std::string& path);
/// Other names with their paths.
void add_all(TableJob::Names& columns, const TableJob::Names& more);

}  // namespace lober::detail
