#include "cli/program/command_description.hpp"

#include <algorithm>
#include <span>
#include <string_view>

namespace lober::cli {
namespace {

// The groups of options, which are the same for all commands. Those in none of the lists choose what is computed.
constexpr std::string_view inputs_group[]{
    "--at",        "--bip",     "--bip-near",     "--bound",     "--boundary",    "--box",     "--branch",
    "--circle",    "--closure", "--direction",    "--energy",    "--from",        "--library", "--manifolds",
    "--no-closed", "--open",    "--open-against", "--operation", "--param",       "--range",   "--rectangle",
    "--reverse",   "--rule",    "--s-direction",  "--saddle",    "--section",     "--stable",  "--start",
    "--sweep",     "--system",  "--time",         "--to",        "--u-direction", "--unstable"};
constexpr std::string_view accuracy_group[]{"--angle",
                                            "--distance-angle",
                                            "--grid",
                                            "--hobson",
                                            "--index",
                                            "--integration-tolerance",
                                            "--interpolation",
                                            "--max-grid",
                                            "--max-iterates",
                                            "--max-length",
                                            "--max-points",
                                            "--max-work",
                                            "--min-length",
                                            "--monte-carlo",
                                            "--no-check-simple",
                                            "--no-discretisation",
                                            "--no-smooth",
                                            "--particles",
                                            "--passes",
                                            "--points",
                                            "--seed",
                                            "--simplify",
                                            "--smooth",
                                            "--tolerance",
                                            "--verify",
                                            "--method"};
constexpr std::string_view files_to_read[]{"--library", "--manifolds"};
constexpr std::string_view results_group[]{"--bibtex", "--format", "--markdown", "--table"};
constexpr std::string_view pictures_group[]{
    "--svg",      "--picture",   "--fluxes",          "--data",      "--window", "--inset",     "--size", "--title",
    "--no-title", "--normalise", "--periodic-orbits", "--no-legend", "--labels", "--no-labels", "--html"};
constexpr std::string_view running_group[]{"--budget",  "--memory",  "--progress", "--quiet", "--shard",
                                           "--threads", "--verbose", "--version",  "--help"};

bool has_name(const OptionDescription& option, std::span<const std::string_view> among) {
  return std::any_of(option.names.begin(), option.names.end(), [&](const std::string& name) {
    return std::find(among.begin(), among.end(), name) != among.end();
  });
}

ValueKind kind_of(const OptionDescription& option) {
  const auto is = [&](std::string_view position, std::string_view name) {
    return option.position == position ||
           std::find(option.names.begin(), option.names.end(), name) != option.names.end();
  };
  if (!option.choices.empty()) return ValueKind::choice;
  if (is("SYSTEM", "--system")) return ValueKind::system;
  if (is("OPERATION", "--operation") || option.position == "NAME") return ValueKind::operation;
  if (!option.position.empty() || option.value.find("FILE") != std::string::npos) return ValueKind::file;
  if (option.value.empty()) return ValueKind::none;
  if (option.value == "DIR") return ValueKind::folder;
  return option.value.starts_with("NAME=") ? ValueKind::parameter : ValueKind::other;
}

OptionGroup group_of(const OptionDescription& option) {
  if (!option.position.empty()) return OptionGroup::inputs;
  if (has_name(option, pictures_group)) return OptionGroup::pictures;
  if (has_name(option, running_group)) return OptionGroup::running;
  // --boundary FILE is an output, --boundary alone a curve to begin with.
  const bool is_output = option.value == "FILE" || option.value == "DIR";
  if (has_name(option, results_group) || (is_output && !has_name(option, files_to_read))) return OptionGroup::results;
  if (has_name(option, inputs_group)) return OptionGroup::inputs;
  return has_name(option, accuracy_group) ? OptionGroup::accuracy : OptionGroup::computation;
}

std::string listed(const std::vector<std::string>& words, const std::string& last) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    text += (k == 0 ? "" : k + 1 == words.size() ? " " + last + " " : ", ") + words[k];
  }
  return text;
}

}  // namespace

std::string OptionDescription::argument() const {
  return names.empty() && !value.empty() ? value : position;
}

std::string OptionDescription::label() const {
  std::string text = argument();
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  if (!names.empty() && !value.empty()) text += " " + value;
  return text + (repeats ? " ..." : "");
}

std::string OptionDescription::full_meaning() const {
  std::string text = meaning;
  if (required && position.empty()) text += " It has to be given.";
  if (!needs.empty()) text += " Needs " + listed(needs, "and") + ".";
  if (!not_with.empty()) text += " Not with " + listed(not_with, "or") + ".";
  return text;
}

std::string CommandDescription::usage() const {
  std::string text = name;
  bool has_options = false;
  for (const OptionDescription& option : options) {
    if (!option.position.empty()) {
      const std::string word = option.argument() + (option.repeats ? "..." : "");
      text += option.required ? " " + word : " [" + word + "]";
    } else if (option.required) {
      text += " " + option.names.front() + " " + option.value;
    } else {
      has_options = true;
    }
  }
  return text + (has_options ? " [options]" : "");
}

const char* title_of(OptionGroup group) {
  switch (group) {
    case OptionGroup::inputs:
      return "Curves and inputs";
    case OptionGroup::computation:
      return "Computation";
    case OptionGroup::accuracy:
      return "Accuracy";
    case OptionGroup::results:
      return "Results and files";
    case OptionGroup::pictures:
      return "Pictures";
    case OptionGroup::running:
      break;
  }
  return "Running";
}

void classify(CommandDescription& command) {
  for (OptionDescription& option : command.options) {
    option.kind = kind_of(option);
    option.group = group_of(option);
  }
  std::stable_sort(command.options.begin(), command.options.end(),
                   [](const OptionDescription& a, const OptionDescription& b) {
                     if (a.position.empty() != b.position.empty()) return b.position.empty();
                     return a.group < b.group;
                   });
}

}  // namespace lober::cli
