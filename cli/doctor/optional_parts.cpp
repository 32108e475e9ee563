#include "cli/doctor/optional_parts.hpp"

#include <filesystem>

#include "cli/picture/conversion.hpp"
#include "lober/curve/formats.hpp"

namespace lober::cli {
namespace {

// The program for several machines lies beside this one, if there was MPI when both were built.
OptionalPart mpi_program() {
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  if (failed) return {"lober_mpi"};
  return {"lober_mpi", std::filesystem::exists(program.parent_path() / "lober_mpi", failed)};
}

}  // namespace

std::vector<OptionalPart> optional_parts() {
  std::vector<OptionalPart> parts;
  parts.push_back(mpi_program());
  for (const FormatInfo& format : formats()) {
    if (!format.library.empty())
      parts.push_back({std::string(format.name), format.missing.empty(), std::string(format.library)});
  }
  parts.push_back({"PDF and PNG pictures", reason_no_conversion().empty(), "librsvg2-2"});
  return parts;
}

}  // namespace lober::cli
