#include "cli/program/output_names.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "engine/files/formats/format_table.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array table_formats{Format::npy, Format::csv, Format::text, Format::tecplot, Format::raw};

constexpr std::array<std::string_view, 2> json_options{"--json", "--graph"};
constexpr std::array<std::string_view, 3> picture_options{"--svg", "--picture", "--fluxes"};
constexpr std::array<std::string_view, 1> data_options{"--data"};
constexpr std::array<std::string_view, 1> page_options{"--html"};
constexpr std::array<std::string_view, 4> zone_options{"--lobes", "--boundary", "--pips", "--curves"};
constexpr std::array<std::string_view, 2> several_options{"--lobes", "--curves"};  // among these
constexpr std::array<std::string_view, 1> crossings_options{"--crossings"};
constexpr std::array<std::string_view, 1> table_options{"--csv"};
constexpr std::array<std::string_view, 6> published_options{"<rslt>",     "<lobefile>",  "<manifile>",
                                                            "<pipsfile>", "<lobebfile>", "<lobeseq>"};

constexpr std::string_view curves_kind = "curves";

constexpr std::array<std::string_view, 1> json_endings{".json"};
constexpr std::array<std::string_view, 3> picture_endings{".svg", ".pdf", ".png"};
constexpr std::array<std::string_view, 2> data_endings{".csv", ".json"};
constexpr std::array<std::string_view, 2> page_endings{".html", ".htm"};
constexpr std::array<std::string_view, 1> table_endings{".csv"};
constexpr std::array<std::string_view, 2> crossings_endings{".csv", ".npy"};

/// The outputs of the options of one kind. Without endings: text under any name that is not of another format.
struct OutputKind {
  Names options;
  std::string_view what;
  Names endings;
};
constexpr std::array<OutputKind, 8> output_kinds{{{json_options, "JSON", json_endings},
                                                  {picture_options, "a picture", picture_endings},
                                                  {data_options, "the data of a picture", data_endings},
                                                  {page_options, "a page", page_endings},
                                                  {zone_options, curves_kind, {}},
                                                  {crossings_options, "a table of crossings", crossings_endings},
                                                  {table_options, "comma-separated columns", table_endings},
                                                  {published_options, "text in the format of Lober 1.8", {}}}};

constexpr std::array<std::string_view, 26> of_other_formats{
    ".bin", ".csv", ".db",  ".geojson", ".gz",  ".h5",  ".hdf5", ".htm", ".html", ".json",  ".jsonl", ".mat",  ".nc",
    ".npy", ".npz", ".pdf", ".plt",     ".png", ".raw", ".shp",  ".so",  ".svg",  ".szplt", ".toml",  ".xlsx", ".zip"};

/// The last ending in lower case, with its dot: a letter and then letters and digits. Empty where the name has none, as
/// in out.0.6 and out.K=2.
std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_part = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  const bool is_ending =
      ending.size() > 1 && is_letter(ending[1]) && std::all_of(ending.begin() + 1, ending.end(), is_part);
  return is_ending ? ending : std::string{};
}

bool is_among(Names names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The format that the ending stands for, if curves are written in it; null otherwise.
const detail::FormatEntry* curve_entry(const std::string& path) {
  const std::optional<Format> format = format_of_name(path);
  const detail::FormatEntry* const entry = format ? &detail::entry_of(*format) : nullptr;
  return entry != nullptr && entry->write != nullptr ? entry : nullptr;
}

}  // namespace

Format curve_format(const std::string& path, const std::string& named, bool or_tecplot) {
  if (!named.empty()) {
    for (const detail::FormatEntry& entry : detail::format_table()) {
      if (entry.name == named && entry.write != nullptr) return entry.format;
    }
  }
  if (path == "-") return Format::text;
  if (const detail::FormatEntry* const entry = curve_entry(path)) return entry->format;
  if (or_tecplot && ending_of(path).empty()) return Format::tecplot;
  throw UsageError(path + ": the ending does not name a format of curves; use " + written_endings() +
                   ", or name one by --format");
}

std::vector<std::string> written_formats() {
  std::vector<std::string> names;
  for (const detail::FormatEntry& entry : detail::format_table()) {
    if (entry.write != nullptr) names.emplace_back(entry.name);
  }
  return names;
}

std::string written_endings() {
  return detail::written_endings();
}

PictureFormat picture_format(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".pdf" ? PictureFormat::pdf : ending == ".png" ? PictureFormat::png : PictureFormat::svg;
}

bool takes_several(const std::string& path, const std::string& named) {
  return detail::entry_of(curve_format(path, named, false)).holds_several;
}

Format table_format(const std::string& path) {
  if (path == "-") return Format::text;
  const std::optional<Format> format = format_of_name(path);
  if (format && std::find(table_formats.begin(), table_formats.end(), *format) != table_formats.end()) return *format;
  std::string message = path + ": the ending does not name a format of tables of numbers; use ";
  for (const Format known : table_formats) {
    const std::string_view suffixes = detail::entry_of(known).suffixes;
    if (known != table_formats.front()) message += known == table_formats.back() ? " or " : ", ";
    message += suffixes.substr(0, suffixes.find(' '));
    if (known == Format::tecplot) message += " (Tecplot)";
  }
  throw UsageError(message);
}

void require_fitting_name(std::string_view option, const std::string& path, const std::string& format) {
  const auto kind = std::find_if(output_kinds.begin(), output_kinds.end(),
                                 [&](const OutputKind& k) { return is_among(k.options, option); });
  if (kind == output_kinds.end()) return;
  const std::string ending = ending_of(path);
  if (kind->what == curves_kind) {
    if (format.empty() && !ending.empty() && curve_entry(path) == nullptr) {
      throw UsageError(std::string(option) + " writes curves, but " + path + " has the ending of another format; use " +
                       written_endings() + ", or no ending, or name a format by --format");
    }
    const Format written = curve_format(path, format, true);
    if (is_among(several_options, option) && !detail::entry_of(written).holds_several) {
      throw UsageError(std::string(option) + " writes several curves, and a file of the format " +
                       std::string(name(written)) + ", as " + path + " is, holds one; use " +
                       detail::written_endings(true));
    }
    return;
  }
  if (ending.empty() || is_among(kind->endings, ending)) return;
  if (kind->endings.empty() && !is_among(of_other_formats, ending)) return;
  std::string message = std::string(option) + " writes " + std::string(kind->what) + ", but " + path +
                        " has the ending of another format; use ";
  if (kind->endings.empty()) {
    message += "another ending, or none";
  } else {
    for (const std::string_view accepted : kind->endings) {
      if (accepted != kind->endings.front()) message += " or ";
      message += accepted;
    }
    message += ", or no ending";
  }
  throw UsageError(message);
}

}  // namespace lober::cli
