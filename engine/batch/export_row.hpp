// What the formats of an export have in common (private to jobs/).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/batch/export.hpp"
#include "engine/files/output_file.hpp"

namespace lober {

/// A job of a plan and what became of it.
struct ExportRow {
  std::size_t job;
  const PlannedGroup* group;
  std::string first, second;  ///< names; empty if there is none
  bool failed;
  std::string message;
  Record record;
};
using EachRow = std::function<void(const std::function<void(const ExportRow&)>&)>;

void write_csv(OutputFile& file, const Operation& operation, const EachRow& rows);
void write_json_lines(OutputFile& file, const EachRow& rows);
void write_npy_table(OutputFile& file, const Operation& operation, const EachRow& rows);

}  // namespace lober
