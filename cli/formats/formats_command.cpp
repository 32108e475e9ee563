#include "cli/formats/formats_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/program/command_line.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/table.hpp"
#include "lober/curve/formats.hpp"

namespace lober::cli {
namespace {

std::string written(const FormatInfo& format) {
  return !format.writes ? "" : format.takes_several ? "curves" : "one curve";
}

std::string formats_table(const std::vector<FormatInfo>& all) {
  const Table table({{"format", 10, Align::left, 0},
                     {"endings", 22, Align::left},
                     {"read", 5, Align::left},
                     {"written", 10, Align::left},
                     {"files", 0, Align::left}});
  std::string text = table.head();
  for (const FormatInfo& format : all) {
    text +=
        table.row({std::string(format.name), std::string(format.suffixes), format.reads ? "yes" : "", written(format),
                   std::string(format.meaning) + (format.missing.empty() ? "" : "; " + format.missing)});
  }
  return text +
         "Files are recognised by their content, compressed by gzip or not; endings choose the format of output.\n";
}

Json json_of(const std::vector<FormatInfo>& all) {
  Json list = Json::array();
  for (const FormatInfo& format : all) {
    list.push_back({{"name", format.name},
                    {"meaning", format.meaning},
                    {"endings", format.suffixes},
                    {"reads", format.reads},
                    {"writes", format.writes},
                    {"takes_several", format.takes_several},
                    {"library", format.library},
                    {"missing", format.missing}});
  }
  return list;
}

}  // namespace

std::string markdown_formats() {
  std::string text = "| format | endings | files | read | written | library |\n|---|---|---|---|---|---|\n";
  for (const FormatInfo& format : formats()) {
    std::string endings(format.suffixes);
    for (std::size_t at = endings.find(' '); at != std::string::npos; at = endings.find(' ', at + 5)) {
      endings.replace(at, 1, "`, `");
    }
    text += fmt::format("| {} | `{}` | {} | {} | {} | {} |\n", format.name, endings, format.meaning,
                        format.reads ? "yes" : "", written(format), format.library);
  }
  return text;
}

void run_formats(const std::vector<std::string>& arguments) {
  std::string json;
  OptionParser parser("Lists the formats of curve files that are read and written, and libraries that are missing.",
                      "lober formats");
  parser.add_example("lober formats", "all formats, with the endings of their names");
  parser.add_example("lober formats --json formats.json", "the same for programs");
  add_json_option(parser, json);
  add_table_option(parser);
  if (!parser.parse(arguments)) return;
  const std::vector<Output> outputs = checked_outputs({{"--json", json}}, {});
  const std::vector<FormatInfo> all = formats();
  if (!json.empty()) write_listing(json, "formats", "formats", json_of(all));
  if (!takes_standard_output(outputs)) print_report(formats_table(all));
}

}  // namespace lober::cli
