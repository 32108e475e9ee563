#include "cli/schema/schema_command.hpp"

#include <spdlog/fmt/fmt.h>

#include "cli/program/command_line.hpp"
#include "cli/program/option_parser.hpp"
#include "cli/report/json.hpp"
#include "cli/schema/reference.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

void run_schema(const std::vector<std::string>& arguments) {
  std::string name;
  bool markdown = false;
  OptionParser parser(
      "Prints the JSON Schema of the members that an operation writes beside program, command, agreement, inputs, "
      "options and timing; without a name, lists the operations.",
      "lober schema");
  parser.add_example("lober schema", "the operations");
  parser.add_example("lober schema overlay", "the members of the JSON of lober overlay");
  parser.add("OPERATION", name, "The name of an operation.");
  parser.add_flag("--markdown", markdown,
                  "Print inputs, options and results as a document in Markdown instead; of all operations, without a "
                  "name.");
  if (!parser.parse(arguments)) return;
  if (markdown) {
    if (!name.empty()) return print(reference_text(operations::named(name)));
    std::string all;
    for (const operations::Operation& operation : operations::all())
      all += (all.empty() ? "" : "\n") + reference_text(operation);
    return print(all);
  }
  if (name.empty()) {
    std::string list;
    for (const operations::Operation& operation : operations::all())
      list += fmt::format("{:<12} {}\n", operation.name, operation.title);
    return print(list);
  }
  print(Json::parse(json_schema(operations::named(name).result)).dump(1) + "\n");
}

}  // namespace lober::cli
