#include "cli/program/output_names.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <utility>

#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::pair<std::string_view, PointFormat>, 6> point_endings{{{".npy", PointFormat::npy},
                                                                                 {".csv", PointFormat::csv},
                                                                                 {".txt", PointFormat::text},
                                                                                 {".dat", PointFormat::tecplot},
                                                                                 {".raw", PointFormat::raw},
                                                                                 {".f64", PointFormat::raw}}};

constexpr std::array<std::string_view, 2> json_options{"--json", "--graph"};
constexpr std::array<std::string_view, 2> picture_options{"--svg", "--picture"};
constexpr std::array<std::string_view, 4> zone_options{"--lobes", "--boundary", "--pips", "--curves"};
constexpr std::array<std::string_view, 2> table_options{"--crossings", "--csv"};
constexpr std::array<std::string_view, 6> published_options{"<rslt>",     "<lobefile>",  "<manifile>",
                                                            "<pipsfile>", "<lobebfile>", "<lobeseq>"};

constexpr std::array<std::string_view, 1> json_endings{".json"};
constexpr std::array<std::string_view, 1> picture_endings{".svg"};
constexpr std::array<std::string_view, 2> zone_endings{".dat", ".tec"};
constexpr std::array<std::string_view, 1> table_endings{".csv"};

/// The outputs of the options of one kind. Without endings: text under any name that is not of another format.
struct OutputKind {
  Names options;
  std::string_view what;
  Names endings;
};
constexpr std::array<OutputKind, 5> output_kinds{{{json_options, "JSON", json_endings},
                                                  {picture_options, "an SVG picture", picture_endings},
                                                  {zone_options, "Tecplot zones", zone_endings},
                                                  {table_options, "comma-separated columns", table_endings},
                                                  {published_options, "text in the format of Lober 1.8", {}}}};

constexpr std::array<std::string_view, 24> of_other_formats{
    ".bin", ".csv", ".db",  ".geojson", ".gz",  ".h5",  ".hdf5", ".json", ".jsonl", ".mat",  ".nc",   ".npy",
    ".npz", ".pdf", ".plt", ".png",     ".raw", ".shp", ".so",   ".svg",  ".szplt", ".toml", ".xlsx", ".zip"};

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

}  // namespace

PointFormat format_of(const std::string& path) {
  if (path == "-") return PointFormat::text;
  const std::string ending = ending_of(path);
  for (const auto& [known, format] : point_endings) {
    if (ending == known) return format;
  }
  throw UsageError(path +
                   ": the ending does not name a format of points; use .npy, .csv, .txt, .dat (Tecplot) or .raw");
}

void require_fitting_name(std::string_view option, const std::string& path) {
  const auto kind = std::find_if(output_kinds.begin(), output_kinds.end(),
                                 [&](const OutputKind& k) { return is_among(k.options, option); });
  if (kind == output_kinds.end()) return;
  const std::string ending = ending_of(path);
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
