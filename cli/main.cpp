// The program: finds out what is wanted, and turns what goes wrong into one line and an exit status.

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/batch_command.hpp"
#include "cli/command_line.hpp"
#include "cli/densify_command.hpp"
#include "cli/escape_command.hpp"
#include "cli/grow_command.hpp"
#include "cli/interior_command.hpp"
#include "cli/overlay_command.hpp"
#include "cli/published_form.hpp"
#include "cli/published_tangle.hpp"
#include "cli/tangle_command.hpp"
#include "cli/transport_command.hpp"
#include "engine/agreement.hpp"
#include "engine/error.hpp"
#include "kernels/cpu.hpp"

namespace lober::cli {
namespace {

constexpr const char* usage = R"(lober: exact crossings, lobes and areas of curves for phase-space transport

usage:
  lober overlay C1 C2 [options]          crossings, lobes and areas of two closed curves
  lober interior C1 C2 [options]         their areas by the interior function (Q1, Q2, Q3), an independent method
  lober densify CURVE [AGAINST] -o FILE  more points where the curve is coarse or meets another one, or fewer
  lober tangle U S [options]             pips, lobes, boundary and turnstile of two manifolds (or of --system NAME)
  lober grow SYSTEM [options]            a stable or unstable manifold of a saddle, from the system's equations
  lober transport SYSTEM [options]       from equations to lobes, turnstile, fluxes a(n) and T(n); sweeps
                                         (or of --manifolds FILE: as far as two given curves reach)
  lober batch run MANIFEST               many curves and pairs; also batch check, status, export, merge
  lober escape SYSTEM --energy E         orbits and tubes of a potential well, and who leaves it when
  lober overlay --help                   the options of a command

  lober <c1> <c2> <rslt> [-DENS p n]          overlay with the command line and files of the published program
  lober -light <c1> <c2> <rslt> [-DENS p n]   interior with the same
  lober <u> <s> <lobefile> <manifile> <pipsfile> <uskip> <sskip> <nzones> [<lobebfile> [<lobeseq>]] [-BIP k]
                                              tangle with the same: zones uskip, uskip + 1, ... of <u>, nzones
                                              of them, each with the zone of <s> that follows sskip likewise
  lober --version

A curve is a file of points, or FILE#ZONE for one zone of it (by number from 0, or by title): Tecplot ASCII, columns
separated by commas or blanks, NPY, or raw float64, known by its content.

exit status: 0 done, 1 the data cannot be used, or a job of a batch failed, 2 the command cannot be understood,
3 two independent routes to one quantity disagree beyond their error bars (everything is printed), 130 interrupted
)";

// A misspelt name would quietly run the best copies.
void check_instruction_set() {
  const char* const asked = std::getenv("LOBER_ISA");
  const auto names = instruction_set_names();
  if (asked == nullptr || std::find(names.begin(), names.end(), asked) != names.end()) return;
  throw UsageError(std::string("LOBER_ISA is ") + asked + ": baseline, avx2 or avx512");
}

void run(const std::vector<std::string>& arguments) {
  check_instruction_set();
  if (arguments.empty()) throw UsageError("nothing to do (see lober --help)");
  const std::string& first = arguments[0];
  if (first == "--help" || first == "-h") {
    print(usage);
  } else if (first == "--version") {
    print("lober " LOBER_VERSION "\n");
  } else if (first == "overlay") {
    run_overlay({arguments.begin() + 1, arguments.end()});
  } else if (first == "interior") {
    run_interior({arguments.begin() + 1, arguments.end()});
  } else if (first == "densify") {
    run_densify({arguments.begin() + 1, arguments.end()});
  } else if (first == "tangle") {
    run_tangle({arguments.begin() + 1, arguments.end()});
  } else if (first == "grow") {
    run_grow({arguments.begin() + 1, arguments.end()});
  } else if (first == "transport") {
    run_transport({arguments.begin() + 1, arguments.end()});
  } else if (first == "batch") {
    run_batch_command({arguments.begin() + 1, arguments.end()});
  } else if (first == "escape") {
    run_escape({arguments.begin() + 1, arguments.end()});
  } else if (is_published_tangle(arguments)) {
    run_published_tangle(arguments);
  } else {
    run_published_form(arguments);
  }
}

// Exactly one line, whatever the message holds.
int fail(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  spdlog::error("{}", message);
  return status;
}

int guarded(const std::vector<std::string>& arguments) {
  try {
    run(arguments);
    return 0;
  } catch (const UsageError& error) {
    return fail(error.what(), 2);
  } catch (const DisagreementError& error) {
    return fail(error.what(), 3);
  } catch (const Cancelled& error) {
    return fail(error.what(), 130);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}

}  // namespace
}  // namespace lober::cli

int main(int count, char** arguments) {
  // Standard output belongs to results. Warnings and errors go to standard error, more with --verbose.
  spdlog::set_default_logger(spdlog::stderr_color_mt("lober"));
  spdlog::set_pattern("lober: %v");
  spdlog::set_level(spdlog::level::warn);
  return lober::cli::guarded({arguments + 1, arguments + count});
}
