#include "cli/program/commands.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "cli/batch/batch_command.hpp"
#include "cli/cite/cite_command.hpp"
#include "cli/densify/densify_command.hpp"
#include "cli/doctor/doctor_command.hpp"
#include "cli/escape/escape_command.hpp"
#include "cli/fixed_points/fixed_points_command.hpp"
#include "cli/formats/formats_command.hpp"
#include "cli/grow/grow_command.hpp"
#include "cli/image/image_command.hpp"
#include "cli/interior/interior_command.hpp"
#include "cli/levels/levels_command.hpp"
#include "cli/overlay/overlay_command.hpp"
#include "cli/program/operation_command.hpp"
#include "cli/program/option_parser.hpp"
#include "cli/schema/schema_command.hpp"
#include "cli/section/section_command.hpp"
#include "cli/systems/systems_command.hpp"
#include "cli/tangle/tangle_command.hpp"
#include "cli/transport/transport_command.hpp"
#include "cli/view/view_command.hpp"
#include "cli/winding/winding_command.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

struct OwnCommand {
  std::string_view name;
  void (*run)(const std::vector<std::string>& arguments);
  std::string_view call, title;
  CommandGroup group;
};

constexpr OwnCommand own_commands[]{
    {"overlay", run_overlay, "C1 C2 [options]", "computes crossings, lobes and areas of two closed curves",
     CommandGroup::curves},
    {"interior", run_interior, "C1 C2 [options]",
     "computes their areas by the interior function (Q1, Q2, Q3), an independent method", CommandGroup::curves},
    {"winding", run_winding, "CURVE --at POINTS",
     "computes winding numbers and J of a closed curve about points, or on a --grid", CommandGroup::curves},
    {"view", run_view, "RESULT|CURVE... -o FILE",
     "writes a page that shows curves, or a result with its lobes, as deep as doubles go", CommandGroup::curves},
    {"densify", run_densify, "CURVE [AGAINST] -o FILE",
     "inserts points where the curve is coarse or meets another one, or removes them", CommandGroup::curves},
    {"tangle", run_tangle, "U S [options]",
     "finds pips, lobes, boundary and turnstile of two manifolds, or of those of --system NAME", CommandGroup::curves},
    {"grow", run_grow, "SYSTEM [options]",
     "grows a stable or unstable manifold of a saddle from the system's equations", CommandGroup::systems},
    {"image", run_image, "SYSTEM CURVE [options]",
     "computes images and pre-images of a curve, a circle, a rectangle or a boundary", CommandGroup::systems},
    {"transport", run_transport, "SYSTEM [options]",
     "computes lobes, turnstile and fluxes a(n) and T(n) from equations, or with --manifolds FILE as far as two given "
     "curves reach; sweeps over a parameter",
     CommandGroup::systems},
    {"escape", run_escape, "SYSTEM --energy E",
     "computes orbits and tubes of a potential well, and the fractions that leave it by crossing n",
     CommandGroup::systems},
    {"fixed-points", run_fixed_points, "SYSTEM [options]",
     "finds fixed and periodic points, with multipliers, residues and types", CommandGroup::systems},
    {"section", run_section, "SYSTEM [options]", "follows orbits and draws their points: a Poincare section",
     CommandGroup::systems},
    {"levels", run_levels, "SYSTEM [options]",
     "computes level curves of the energy: streamlines, potential, Hill's region", CommandGroup::systems},
    {"systems", run_systems, "[SYSTEM]", "lists the built-in systems; shows the parameters and manifolds of one",
     CommandGroup::systems},
    {"batch", run_batch_command, "run MANIFEST",
     "computes many curves and pairs; also batch check, status, export, page, picture, merge, manifest and operations",
     CommandGroup::many},
    {"schema", run_schema, "[OPERATION]", "prints what is in the JSON of an operation, with units and meanings",
     CommandGroup::program},
    {"formats", run_formats, "[--json FILE]", "lists the formats of curve files that are read and written",
     CommandGroup::program},
    {"cite", run_cite, "[--bibtex]", "prints how to cite lober and the article whose methods it implements",
     CommandGroup::program},
    {"doctor", run_doctor, "[--json FILE]",
     "reports versions, processor, memory and a self-test: the text for a bug report", CommandGroup::program},
};

const OwnCommand* own_command(std::string_view name) {
  const auto found = std::find_if(std::begin(own_commands), std::end(own_commands),
                                  [&](const OwnCommand& any) { return any.name == name; });
  return found == std::end(own_commands) ? nullptr : &*found;
}

CommandGroup group_of(const operations::Operation& operation) {
  const bool has_system = std::any_of(operation.inputs.begin(), operation.inputs.end(),
                                      [](const auto& input) { return input.kind == operations::InputKind::system; });
  return has_system ? CommandGroup::systems : CommandGroup::curves;
}

// Arguments that choose a form of the command; the usual form needs none.
std::vector<std::vector<std::string>> forms_by_arguments(std::string_view name) {
  if (name == "tangle") return {{}, {"--system", "SYSTEM"}};
  if (name == "transport") return {{}, {"--manifolds", "FILE"}};
  if (name != "batch") return {{}};
  std::vector<std::vector<std::string>> forms;
  for (const std::string& verb : batch_verbs()) forms.push_back({verb});
  return forms;
}

}  // namespace

std::vector<Command> all_commands() {
  std::vector<Command> commands;
  for (const OwnCommand& own : own_commands) {
    commands.push_back({std::string(own.name), std::string(own.call), std::string(own.title), own.group});
  }
  for (const operations::Operation& operation : operations::all()) {
    if (own_command(command_name(operation)) != nullptr) continue;
    const std::string name = command_name(operation);
    commands.push_back({name, call_of(operation).substr(std::string("lober  ").size() + name.size()), operation.title,
                        group_of(operation)});
  }
  std::stable_sort(commands.begin(), commands.end(),
                   [](const Command& a, const Command& b) { return a.group < b.group; });
  return commands;
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Command& command : all_commands()) names.push_back(command.name);
  return names;
}

const char* title_of(CommandGroup group) {
  switch (group) {
    case CommandGroup::curves:
      return "Curves";
    case CommandGroup::systems:
      return "Systems";
    case CommandGroup::many:
      return "Many curves and pairs";
    case CommandGroup::program:
      break;
  }
  return "About the program";
}

bool is_command(std::string_view name) {
  return own_command(name) != nullptr || operation_called(name) != nullptr;
}

void run_command(std::string_view name, const std::vector<std::string>& arguments) {
  if (const OwnCommand* const own = own_command(name)) return own->run(arguments);
  const operations::Operation* const operation = operation_called(name);
  if (operation == nullptr) throw UsageError("there is no command \"" + std::string(name) + "\"");
  run_operation(*operation, arguments);
}

std::vector<CommandDescription> forms_of(const Command& command) {
  std::vector<CommandDescription> forms;
  for (const std::vector<std::string>& arguments : forms_by_arguments(command.name)) {
    for (CommandDescription& form : described([&] { run_command(command.name, arguments); })) {
      forms.push_back(std::move(form));
    }
  }
  return forms;
}

}  // namespace lober::cli
