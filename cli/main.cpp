// The program: finds out which command is wanted, and turns each error into one line and an exit status.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/batch/batch_command.hpp"
#include "cli/densify/densify_command.hpp"
#include "cli/escape/escape_command.hpp"
#include "cli/fixed_points/fixed_points_command.hpp"
#include "cli/grow/grow_command.hpp"
#include "cli/image/image_command.hpp"
#include "cli/interior/interior_command.hpp"
#include "cli/levels/levels_command.hpp"
#include "cli/overlay/overlay_command.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/edit_distance.hpp"
#include "cli/program/interrupt.hpp"
#include "cli/program/log.hpp"
#include "cli/program/operation_command.hpp"
#include "cli/published/published_form.hpp"
#include "cli/published/published_tangle.hpp"
#include "cli/schema/schema_command.hpp"
#include "cli/section/section_command.hpp"
#include "cli/systems/systems_command.hpp"
#include "cli/tangle/tangle_command.hpp"
#include "cli/transport/transport_command.hpp"
#include "cli/winding/winding_command.hpp"
#include "engine/base/input_guard.hpp"
#include "engine/files/curve_spec.hpp"
#include "kernels/cpu.hpp"
#include "lober/base/agreement.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"
#include "lober/base/version.hpp"

namespace lober::cli {
namespace {

struct Command {
  std::string_view name;
  void (*run)(const std::vector<std::string>& arguments);
  std::string_view usage;
};

constexpr std::array commands{
    Command{"overlay", run_overlay,
            R"(  lober overlay C1 C2 [options]          computes crossings, lobes and areas of two closed curves
)"},
    Command{
        "interior", run_interior,
        R"(  lober interior C1 C2 [options]         computes their areas by the interior function (Q1, Q2, Q3), an independent
                                         method
)"},
    Command{
        "winding", run_winding,
        R"(  lober winding CURVE --at POINTS        computes winding numbers and J of a closed curve about points, or on a --grid
)"},
    Command{
        "densify", run_densify,
        R"(  lober densify CURVE [AGAINST] -o FILE  inserts points where the curve is coarse or meets another one, or removes them
)"},
    Command{
        "tangle", run_tangle,
        R"(  lober tangle U S [options]             finds pips, lobes, boundary and turnstile of two manifolds, or of those of
                                         --system NAME
)"},
    Command{
        "grow", run_grow,
        R"(  lober grow SYSTEM [options]            grows a stable or unstable manifold of a saddle from the system's equations
)"},
    Command{
        "image", run_image,
        R"(  lober image SYSTEM CURVE [options]     computes images and pre-images of a curve, a circle, a rectangle or a boundary
)"},
    Command{
        "transport", run_transport,
        R"(  lober transport SYSTEM [options]       computes lobes, turnstile and fluxes a(n) and T(n) from equations, or with
                                         --manifolds FILE as far as two given curves reach; sweeps over a parameter
)"},
    Command{
        "batch", run_batch_command,
        R"(  lober batch run MANIFEST               computes many curves and pairs; also batch check, status, export, merge
)"},
    Command{
        "escape", run_escape,
        R"(  lober escape SYSTEM --energy E         computes orbits and tubes of a potential well, and the fractions that leave it
                                         by crossing n
)"},
    Command{
        "fixed-points", run_fixed_points,
        R"(  lober fixed-points SYSTEM [options]    finds fixed and periodic points, with multipliers, residues and types
)"},
    Command{"section", run_section,
            R"(  lober section SYSTEM [options]         follows orbits and draws their points: a Poincare section
)"},
    Command{
        "levels", run_levels,
        R"(  lober levels SYSTEM [options]          computes level curves of the energy: streamlines, potential, Hill's region
)"},
    Command{
        "systems", run_systems,
        R"(  lober systems [SYSTEM]                 lists the built-in systems; shows the parameters and manifolds of one
)"},
    Command{
        "schema", run_schema,
        R"(  lober schema [OPERATION]               prints what is in the JSON of an operation, with units and meanings
)"},
};

constexpr std::string_view usage_before = R"(lober: exact crossings, lobes and areas of curves for phase-space transport

usage:
)";
constexpr std::string_view usage_after =
    R"(  lober overlay --help                   lists the options of a command, as lober help overlay
  lober --version                        prints the version

  lober <c1> <c2> <rslt> [-DENS p n]          runs overlay with the command line and files of Lober 1.8
  lober -light <c1> <c2> <rslt> [-DENS p n]   runs interior with those
  lober <u> <s> <lobefile> <manifile> <pipsfile> <uskip> <sskip> <nzones> [<lobebfile> [<lobeseq>]] [-BIP k]
                                              runs tangle with those, for nzones pairs: the zones of <u> from number
                                              <uskip> on with those of <s> from number <sskip> on

Lober 1.8 is the program published with Naik, Lekien & Ross (2017), doi:10.1134/S1560354717030078.

A curve is a file of points, or FILE#ZONE for one zone of it (by number from 0, or by title): Tecplot ASCII, columns
separated by commas or blanks, NPY, or raw float64. The format is recognised by the content. FILE:lon,lat or FILE:2,3
chooses columns of a table by name or number; with FILE:lon,lat,by=id rows with the same id are a zone.

exit status: 0 everything is done; 1 the data cannot be used, or a job of a batch failed; 2 the command cannot be
understood; 3 two independent routes to one quantity disagree beyond their error bars (everything is printed);
130 the command was interrupted
)";

const Command* find_command(std::string_view name) {
  const auto found =
      std::find_if(commands.begin(), commands.end(), [&](const Command& any) { return any.name == name; });
  return found == commands.end() ? nullptr : &*found;
}

// Whether an operation of the table has a command that shows more than its numbers.
bool has_command(const operations::Operation& operation) {
  return find_command(command_name(operation)) != nullptr;
}

std::string program_usage() {
  std::string text(usage_before);
  for (const Command& command : commands) text += command.usage;
  for (const operations::Operation& operation : operations::all()) {
    if (has_command(operation)) continue;
    text += fmt::format("  {:<38} {}\n", call_of(operation), operation.title);
  }
  return text += usage_after;
}

// A misspelt name would quietly run the best copies.
void check_instruction_set() {
  const char* const asked = std::getenv("LOBER_ISA");
  const auto names = detail::instruction_set_names();
  if (asked == nullptr || std::find(names.begin(), names.end(), asked) != names.end()) return;
  throw UsageError(std::string("LOBER_ISA is ") + asked +
                   ", which is not an instruction set; set it to baseline, avx2 or avx512");
}

// The command that a word is a slip of, or empty. The published forms take any word for a file, and the last one for a
// file to write.
std::string command_meant(const std::string& word) {
  std::error_code ignored;
  if (word.empty() || word.front() == '-' || std::filesystem::exists(detail::file_of_curve(word), ignored)) return {};
  std::vector<std::string> names;
  names.reserve(std::size(commands));
  for (const Command& command : commands) names.emplace_back(command.name);
  for (const operations::Operation& operation : operations::all()) names.push_back(command_name(operation));
  for (const std::string& name : names) {
    const std::size_t most = name.size() > 4 ? 2 : 1;
    const bool begun = word.size() > 2 && name.starts_with(word);
    if (begun || edit_distance(word, name) <= most) return name;
  }
  return {};
}

// "-:2,3", columns of standard input, would be taken for an option.
std::vector<std::string> with_standard_input(std::vector<std::string> arguments) {
  for (std::string& argument : arguments) {
    if (argument.starts_with("-:") || argument.starts_with("-#")) argument.replace(0, 1, "/dev/stdin");
  }
  return arguments;
}

void run_program(const std::vector<std::string>& arguments) {
  check_instruction_set();
  if (arguments.empty()) throw UsageError("no command is given (see lober --help)");
  const detail::InputGuard guard;
  const std::string& first = arguments[0];
  if (first == "--help" || first == "-h" || (first == "help" && arguments.size() == 1)) {
    print(program_usage());
  } else if (first == "help" && !std::filesystem::exists(first)) {  // a file could be meant, in a published form
    if (find_command(arguments[1]) == nullptr && operation_called(arguments[1]) == nullptr) {
      throw UsageError("there is no command \"" + arguments[1] + "\" (see lober --help)");
    }
    std::vector<std::string> command(arguments.begin() + 1, arguments.end());
    command.emplace_back("--help");
    run_program(command);
  } else if (first == "--version") {
    print(std::string("lober ") + version() + "\n");
  } else if (const Command* const command = find_command(first)) {
    command->run({arguments.begin() + 1, arguments.end()});
  } else if (const operations::Operation* const operation = operation_called(first)) {
    run_operation(*operation, {arguments.begin() + 1, arguments.end()});
  } else if (const std::string meant = command_meant(first); !meant.empty()) {
    throw UsageError("\"" + first + "\" is neither a command nor a file; did you mean " + meant +
                     "? (see lober --help)");
  } else if (is_published_tangle(arguments)) {
    run_published_tangle(arguments);
  } else {
    run_published_form(arguments);
  }
}

// Exactly one line, whatever the message holds, and nothing that a terminal obeys.
int fail(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  log_error(message);
  return status;
}

int guarded(const std::vector<std::string>& arguments) {
  watch_for_interrupt();
  const CancellationScope cancellation(interrupt_flag());
  try {
    run_program(arguments);
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
  lober::cli::begin_log("lober");
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of the write, with a message
  return lober::cli::guarded(lober::cli::with_standard_input({arguments + 1, arguments + count}));
}
