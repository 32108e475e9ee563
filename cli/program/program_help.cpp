#include "cli/program/program_help.hpp"

#include <optional>

#include "cli/program/commands.hpp"
#include "cli/program/help_text.hpp"
#include "cli/program/wrapped_text.hpp"

namespace lober::cli {

std::vector<CommandExample> program_examples() {
  return {{"lober overlay examples/resonance.dat examples/resonance_image.dat", "a resonance region and its image"},
          {"lober transport henon", "from the equations of the Henon map to fluxes"}};
}

std::vector<CommandExample> program_calls() {
  return {{"help COMMAND", "lists the options of a command, as lober COMMAND --help"},
          {"--version [--verbose]", "prints the version; with --verbose the build and the libraries, too"},
          {"--generate man [COMMAND]", "prints the manual page of lober, or of a command"},
          {"--generate complete-bash|complete-zsh|complete-fish", "prints the completions for a shell"}};
}

std::vector<CommandExample> published_calls() {
  return {{"<c1> <c2> <rslt> [-DENS p n]", "runs overlay with the command line and files of Lober 1.8"},
          {"-light <c1> <c2> <rslt> [-DENS p n]", "runs interior with those"},
          {"<u> <s> <lobefile> <manifile> <pipsfile> <uskip> <sskip> <nzones> [<lobebfile> [<lobeseq>]] [-BIP k]",
           "runs tangle with those, for nzones pairs: the zones of <u> from number <uskip> on with those of <s> from "
           "number <sskip> on"}};
}

std::string curve_paragraph() {
  return "A curve is a file of points, or FILE#ZONE for one zone of it (by number from 0, or by title): Tecplot ASCII, "
         "columns separated by commas or blanks, NPY, or raw float64. The format is recognised by the content. "
         "FILE:lon,lat or FILE:2,3 chooses columns of a table by name or number; with FILE:lon,lat,by=id rows with the "
         "same id are a zone.";
}

std::vector<CommandExample> exit_statuses() {
  return {{"0", "everything is done"},
          {"1", "the data cannot be used, or a job of a batch failed"},
          {"2", "the command cannot be understood"},
          {"3", "two independent routes to one quantity disagree beyond their error bars (everything is printed)"},
          {"130", "the command was interrupted"}};
}

std::string program_help(std::size_t width) {
  constexpr std::size_t column = 40;
  std::string text = wrapped(program_summary, width) + "\n\n" + examples_text(program_examples()) +
                     "\nUsage: lober COMMAND ... (lober COMMAND --help lists its options)\n";
  std::optional<CommandGroup> group;
  for (const Command& command : all_commands()) {
    if (group != command.group) {
      group = command.group;
      text += std::string("\n") + title_of(*group) + ":\n";
    }
    text += list_entry("lober " + command.name + " " + command.call, command.title, column, width);
  }
  for (const CommandExample& call : program_calls()) {
    text += list_entry("lober " + call.line, call.meaning, column, width);
  }
  text += "\n" +
          wrapped(
              "Command lines of Lober 1.8, the program published with Naik, Lekien & Ross (2017), "
              "doi:10.1134/S1560354717030078:",
              width) +
          "\n";
  for (const CommandExample& call : published_calls()) {
    text += "  " + wrapped("lober " + call.line, width, 8, 2) + "\n      " + wrapped(call.meaning, width, 6, 6) + "\n";
  }
  text += "\n" + wrapped(curve_paragraph(), width) + "\n\nExit status:\n";
  for (const CommandExample& status : exit_statuses()) text += list_entry(status.line, status.meaning, 7, width);
  return text + "\n" + reference_line("", width);
}

}  // namespace lober::cli
