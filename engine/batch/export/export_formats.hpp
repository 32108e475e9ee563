// The common parts of the formats of an export (private to the exports).
#pragma once

#include "engine/base/output_file.hpp"
#include "engine/batch/export/export.hpp"
#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/result.hpp"

namespace lober::detail {

void write_csv(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results);
void write_hdf5(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results);
void write_json_lines(OutputFile& file, const Plan& plan, const EachResult& results);
void write_netcdf(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results);
void write_npy_table(OutputFile& file, const Plan& plan, const Operation& operation, const EachResult& results);

}  // namespace lober::detail
