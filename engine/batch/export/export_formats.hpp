// The common parts of the formats of an export (private to the exports).
#pragma once

#include <functional>

#include "engine/base/output_file.hpp"
#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/result.hpp"

namespace lober::detail {

/// Goes through the results of jobs of a plan, in its order.
using EachResult = std::function<void(const std::function<void(const Result&)>&)>;

void write_csv(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results);
void write_hdf5(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results);
void write_json_lines(OutputFile& file, const Plan& plan, const EachResult& results);
void write_netcdf(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results);
void write_npy_table(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results);

}  // namespace lober::detail
