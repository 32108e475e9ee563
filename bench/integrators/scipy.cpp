#include "bench/integrators/scipy.hpp"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace lober::bench {

std::vector<ScipyRun> run_scipy(const std::string& system, double span, std::span<const double> coordinates,
                                std::size_t dimension, std::span<const double> tolerances) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("bench_integrators_" + std::to_string(getpid()) + ".txt");
  {
    std::ofstream points(file);
    points << std::setprecision(17);
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
      points << coordinates[k] << ((k + 1) % dimension == 0 ? '\n' : ' ');
    }
  }
  std::ostringstream command;
  // The one of the system's packages first: SciPy is one of them.
  command << std::setprecision(17) << "PATH=/usr/bin:\"$PATH\" python3 '" LOBER_BENCH_SCIPY "' " << system << ' '
          << span << ' ' << file;
  for (const double tolerance : tolerances) command << ' ' << tolerance;
  command << " 2>/dev/null";

  std::string output;
  if (FILE* pipe = popen(command.str().c_str(), "r")) {
    char part[4096];
    for (std::size_t got; (got = std::fread(part, 1, sizeof part, pipe)) > 0;) output.append(part, got);
    if (pclose(pipe) != 0) output.clear();
  }
  std::filesystem::remove(file);

  std::vector<ScipyRun> runs;
  std::istringstream lines(output);
  for (const double tolerance : tolerances) {
    ScipyRun run{tolerance, 0, {}};
    std::string line;
    if (!std::getline(lines, line)) return {};
    std::istringstream numbers(line);
    numbers >> run.nanoseconds;
    for (double number = 0; numbers >> number;) run.coordinates.push_back(number);
    if (run.coordinates.size() != coordinates.size()) return {};
    runs.push_back(run);
  }
  return runs;
}

}  // namespace lober::bench
