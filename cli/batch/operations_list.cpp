#include "cli/batch/operations_list.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/program/command_line.hpp"
#include "cli/program/option_parser.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/report.hpp"
#include "engine/base/nearest_word.hpp"
#include "lober/base/error.hpp"
#include "lober/batch.hpp"

namespace lober::cli {
namespace {

constexpr const char* manifest_keys =
    R"(A manifest is a TOML file. All pairs of a family of files, whose names are relative to its folder:

  operation = "overlay"
  curves = "separ.*"
  pairs = "all"

Keys, at the top for all groups or in a [[group]] for that group:

  name       name of the group, in exports
  operation  one of those that `lober batch operations` lists
  curves     a pattern of file names with * ? [abc], or a list of patterns; FILE#K is a zone by its number or title,
             FILE#* stands for all zones, FILE:lon,lat and FILE:2,3 choose the columns of a table and FILE:lon,lat,by=id#*
             its groups; or curves to be computed (below)
  with       the same: the second set of pairs = "product"
  closed     false for open curves (default: as the operation has it)
  periodic   "x=2pi", or ["x=2pi", "y=1"]: the periods of curves of files, as --periodic has them
  pairs      "all"          each unordered pair of two of the curves
             "consecutive"  each curve with the next one
             { lag = k }    each curve with the k-th after it
             "product"      each of `curves` with each of `with`, but none with itself
             "single"       each curve alone
             [["a", "b"], ...]  these pairs, by name; `curves` is then not needed
             (default: "all"; "product" where there is `with`; "single" for operations on one curve)
  options    a table of options of the operation; those of a group count before those at the top
  grid       a table of lists of values of options, or ranges "FIRST:LAST:STEP" of numbers: the jobs are repeated for
             each combination; exports have a column for each option that varies

Curves are taken in the natural order of their names, separ.2 before separ.10. A curve of a system is a table:

  { system = "standard", parameters = { K = 1.2 }, manifold = "unstable", iterates = 5, tolerance = 1e-5 }
      a branch of a manifold, open: that of the tangle of the system, or the `branch` "+" or "-" of the saddle near
      `from = [x, y]`; `length` instead of or beside `iterates` bounds it
  { system = "standard", parameters = { K = 1.2 }, image_of = "separ.npy", iterates = "0:9", tolerance = 1e-5 }
      images of the curves of a pattern; `iterates` may be negative; "a:b" is a family, a curve for each of a, ..., b

Both take `integration_tolerance`, the error of a step of the integration of a flow. The operation transport has no
curves. Its options name a system, whose parameters a grid can vary:

  operation = "transport"
  options = { system = "duffing", iterates = 7 }
  grid = { parameters.eps = "0.1:0.3:0.05" }
)";

std::string curves_text(const OperationInfo& info) {
  if (info.max_curves == 0) return "no curves";
  if (info.min_curves == info.max_curves) return info.max_curves == 1 ? "one curve" : "two curves";
  return fmt::format("{} or {} curves", info.min_curves, info.max_curves);
}

std::string list_text(const std::vector<OperationInfo>& all) {
  std::string text;
  std::size_t width = 0;
  for (const OperationInfo& info : all) width = std::max(width, info.name.size());
  for (const OperationInfo& info : all) {
    text += fmt::format("{:<{}} {:<18} {}\n", info.name, width, curves_text(info), info.summary);
  }
  return text + "`lober batch operations NAME` lists the options and results of an operation.\n";
}

std::string values_text(const OperationOption& option) {
  if (!option.choices.empty()) return fmt::format("{}", fmt::join(option.choices, ", "));
  std::string text = option.type;
  if (option.min && option.max && !option.above_min)
    return text + fmt::format(", {:.15g} to {:.15g}", *option.min, *option.max);
  if (option.min) text += fmt::format(", {} {:.15g}", option.above_min ? "above" : "at least", *option.min);
  if (option.max) text += fmt::format(", at most {:.15g}", *option.max);
  return text;
}

std::string details_text(const OperationInfo& info) {
  std::string text = fmt::format("{}  {}\n", info.name, info.summary);
  text += fmt::format("curves   {}{}\n", curves_text(info), info.open ? ", open" : "");
  text += "options\n";
  for (const OperationOption& option : info.options) {
    text += fmt::format("  {:<21} {}\n", option.key, option.meaning);
    text += fmt::format("  {:<21} {}{}\n", "", values_text(option),
                        option.fallback.empty() ? "" : fmt::format(" (default: {})", option.fallback));
  }
  text += fmt::format("numbers  {}\n", fmt::join(info.columns, ", "));
  if (!info.lists.empty()) text += fmt::format("lists    {}\n", fmt::join(info.lists, ", "));
  return text + fmt::format("view     {}, in a store, for SQL\n", info.view);
}

Json option_json(const OperationOption& option) {
  const auto bound = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  return {{"key", option.key},
          {"type", option.type},
          {"default", option.fallback},
          {"choices", option.choices},
          {"min", bound(option.min)},
          {"max", bound(option.max)},
          {"above_min", option.above_min},
          {"meaning", option.meaning}};
}

Json info_json(const OperationInfo& info) {
  Json options = Json::array();
  for (const OperationOption& option : info.options) options.push_back(option_json(option));
  return {{"name", info.name},
          {"summary", info.summary},
          {"min_curves", info.min_curves},
          {"max_curves", info.max_curves},
          {"open", info.open},
          {"options", std::move(options)},
          {"columns", info.columns},
          {"lists", info.lists},
          {"view", info.view}};
}

}  // namespace

void show_operations(const std::vector<std::string>& arguments) {
  std::string name, json_path;
  OptionParser parser("Lists the operations of batches; with a name, the options and results of that operation.",
                      "lober batch operations");
  parser.add_example("lober batch operations", "all of them");
  parser.add_example("lober batch operations transport", "the options and results of one");
  parser.add("NAME", name, "The name of an operation.");
  add_json_option(parser, json_path, "the list");
  if (!parser.parse(arguments)) return;
  const Output json_output{"--json", json_path};
  if (!json_path.empty()) check_outputs({&json_output, 1}, std::vector<std::string>{});

  std::vector<OperationInfo> all = list_operations();
  if (!name.empty()) {
    std::vector<std::string> known;
    known.reserve(all.size());
    for (const OperationInfo& info : all) known.push_back(info.name);
    std::erase_if(all, [&](const OperationInfo& info) { return info.name != name; });
    if (all.empty())
      throw UsageError("\"" + name + "\" is not an operation; there are " + detail::joined(known) +
                       detail::did_you_mean(name, known));
  }
  if (!json_path.empty()) {
    Json list = Json::array();
    for (const OperationInfo& info : all) list.push_back(info_json(info));
    write_listing(json_path, "batch operations", "operations", std::move(list));
  }
  if (json_path != "-") print(name.empty() ? list_text(all) : details_text(all.front()));
}

void show_manifest_keys(const std::vector<std::string>& arguments) {
  OptionParser parser("Lists the keys of a manifest.", "lober batch manifest");
  parser.add_example("lober batch manifest", "all keys, with their values");
  parser.add_example("lober batch manifest > keys.txt", "the same in a file");
  if (parser.parse(arguments)) print(manifest_keys);
}

}  // namespace lober::cli
