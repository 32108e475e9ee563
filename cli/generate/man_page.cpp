#include "cli/generate/man_page.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "cli/generate/completions.hpp"
#include "cli/generate/roff.hpp"
#include "cli/program/commands.hpp"
#include "cli/program/help_text.hpp"
#include "cli/program/program_help.hpp"
#include "engine/base/nearest_word.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/operations.hpp"

namespace lober::cli {
namespace {

std::vector<std::string> system_names() {
  std::vector<std::string> names;
  for (const SystemInfo& info : list_systems()) names.push_back(info.name);
  return names;
}

// With the values that can be given, where the text does not name them all.
std::string man_meaning(const OptionDescription& option) {
  std::string text = option.full_meaning();
  const bool names_all = std::all_of(option.choices.begin(), option.choices.end(), [&](const std::string& choice) {
    return option.meaning.find(choice) != std::string::npos;
  });
  if (!names_all) text += " Values: " + detail::joined(option.choices) + ".";
  if (option.kind == ValueKind::system) text += " Built-in systems: " + detail::joined(system_names()) + ".";
  if (option.kind == ValueKind::operation) {
    std::vector<std::string> known;
    for (const operations::Operation& operation : operations::all()) known.push_back(operation.name);
    text += " Operations: " + detail::joined(known) + ".";
  }
  return text;
}

void add_options(ManPage& page, const CommandDescription& form) {
  std::optional<OptionGroup> group;
  for (const OptionDescription& option : form.options) {
    if (group != option.group) {
      group = option.group;
      page.subsection(title_of(*group));
    }
    page.entry(option.label(), man_meaning(option));
  }
}

void add_exit_status(ManPage& page) {
  page.section("EXIT STATUS");
  for (const CommandExample& status : exit_statuses()) page.entry(status.line, status.meaning + ".");
}

void add_environment(ManPage& page) {
  page.section("ENVIRONMENT");
  page.entry(
      "LOBER_ISA",
      "The best instruction set that may be used: baseline, avx2 or avx512 (default: the best that the processor "
      "has). Results are the same bits for any of them.");
  page.entry("COLUMNS", "The width of help texts, of which 80 to 120 characters are used.");
  page.entry("TMPDIR", "The folder for temporary files that lober doctor tries.");
  page.entry("SOURCE_DATE_EPOCH", "The date of manual pages that --generate prints, in seconds since 1970.");
}

void add_reference(ManPage& page, const std::string& anchor) {
  page.section("FILES");
  page.entry("MANIFEST.results",
             "The store of lober batch, a SQLite file, beside its manifest unless --store is given.");
  page.entry(std::string(reference_page) + (anchor.empty() ? "" : "#" + anchor),
             "The reference, below the prefix of the installation.");
}

void add_see_also(ManPage& page, const std::vector<std::string>& names) {
  page.section("SEE ALSO");
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name + "(1)";
  page.paragraph(list);
}

// "--json, --lobes" of all forms.
std::string option_names_of(const std::vector<CommandDescription>& forms) {
  std::vector<std::string> names;
  for (const CommandDescription& form : forms) {
    for (const OptionDescription& option : form.options) {
      if (option.names.empty()) continue;
      const std::string& name = option.names.back();
      if (name != "--help" && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return detail::joined(names);
}

// The usage of a form behind the name of its command.
std::string arguments_of(const CommandDescription& form) {
  return form.usage().substr(std::min(form.name.size() + 1, form.usage().size()));
}

}  // namespace

std::string program_man_page() {
  ManPage page("lober");
  page.section("NAME");
  page.paragraph("lober - exact crossings, lobes and areas of curves for phase-space transport");
  page.section("SYNOPSIS");
  page.call("lober", "COMMAND [arguments] [options]");
  for (const CommandExample& call : program_calls()) page.call("lober", call.line);
  for (const CommandExample& call : published_calls()) page.call("lober", call.line);
  page.section("DESCRIPTION");
  page.paragraph(
      "Computes where curves with millions of points cross, which lobes they enclose, and how much area each lobe "
      "holds, exactly; grows the curves from equations of maps and flows; and computes the transport between regions "
      "that they bound.");
  page.paragraph(curve_paragraph());
  page.section("COMMANDS");
  std::vector<std::string> see_also;
  std::optional<CommandGroup> group;
  for (const Command& command : all_commands()) {
    if (group != command.group) {
      group = command.group;
      page.subsection(title_of(*group));
    }
    const std::string options = option_names_of(forms_of(command));
    page.entry("lober " + command.name + " " + command.call,
               command.title + "." + (options.empty() ? "" : " Options: " + options + "."));
    see_also.push_back("lober-" + command.name);
  }
  page.subsection("The program itself");
  for (const CommandExample& call : program_calls()) page.entry("lober " + call.line, call.meaning + ".");
  page.entry("lober COMMAND --version", "prints the version, as lober --version.");
  page.subsection("Command lines of Lober 1.8");
  page.paragraph("Lober 1.8 is the program published with Naik, Lekien & Ross (2017), doi:10.1134/S1560354717030078.");
  for (const CommandExample& call : published_calls()) {
    page.call("lober", call.line);
    page.paragraph(call.meaning + ".");
  }
  add_exit_status(page);
  add_environment(page);
  add_reference(page, "");
  page.section("EXAMPLES");
  for (const CommandExample& example : program_examples()) page.example(example.line, example.meaning + ".");
  add_see_also(page, see_also);
  return page.text();
}

std::string command_man_page(std::string_view name) {
  const std::vector<Command> commands = all_commands();
  const auto command =
      std::find_if(commands.begin(), commands.end(), [&](const Command& one) { return one.name == name; });
  if (command == commands.end()) {
    throw UsageError("there is no command \"" + std::string(name) + "\"" + detail::did_you_mean(name, command_names()) +
                     " (see lober --help)");
  }
  const std::vector<CommandDescription> forms = forms_of(*command);
  const std::string page_name = "lober-" + command->name;
  ManPage page(page_name);
  page.section("NAME");
  page.paragraph(page_name + " - " + command->title);
  page.section("SYNOPSIS");
  for (const CommandDescription& form : forms) page.call(form.name, arguments_of(form));
  page.section("DESCRIPTION");
  std::string before;
  for (const CommandDescription& form : forms) {
    if (forms.size() > 1) page.call(form.name, arguments_of(form));
    page.paragraph(form.summary);
  }
  for (const CommandDescription& form : forms) {
    page.section(forms.size() == 1 ? "OPTIONS"
                                   : "OPTIONS OF " + form.usage().substr(0, form.usage().find(" [options]")));
    add_options(page, form);
  }
  add_exit_status(page);
  add_environment(page);
  add_reference(page, anchor_of(forms.front().name));
  page.section("EXAMPLES");
  for (const CommandDescription& form : forms) {
    for (const CommandExample& example : form.examples) page.example(example.line, example.meaning + ".");
  }
  add_see_also(page, {"lober"});
  return page.text();
}

}  // namespace lober::cli
