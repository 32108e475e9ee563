// The whole job, by scene, phase and rival, with ratios measured in one run. See --help.
//
// Not a Google Benchmark suite, because what counts here are ratios: to a streaming pass over the same points
// in the same process, with and without parts of the work, and to other libraries, each in a process of its
// own.
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "bench/harness/child.hpp"
#include "bench/harness/options.hpp"
#include "bench/harness/program.hpp"
#include "bench/harness/sections.hpp"

namespace lober::bench {
namespace {

int run(int count, char** arguments) {
  Options options;
  if (!parse_options(count, arguments, options)) return 0;
  if (!options.child.empty()) return run_as_child(options);
  std::ostringstream tables;
  const auto section = [&](auto print) {
    std::ostringstream text;
    print(options, text);
    std::cout << text.str() << std::flush;
    tables << text.str();
  };
  section(own_section);
  if (options.growth) section(growth_section);
  if (options.rivals != RivalChoice::none) section(fast_rivals_section);
  if (options.rivals == RivalChoice::all) section(all_rivals_section);
  if (!options.markdown.empty()) {
    std::ofstream file(options.markdown);
    file << tables.str();
    if (!file.flush()) throw std::runtime_error("cannot write " + options.markdown);
  }
  return 0;
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  return lober::bench::exit_status("bench_overlay", [&] { return lober::bench::run(count, arguments); });
}
