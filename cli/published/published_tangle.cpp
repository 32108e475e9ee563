#include "cli/published/published_tangle.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>

#include "cli/program/command_line.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/text.hpp"
#include "cli/tangle/tangle_report.hpp"
#include "engine/files/tecplot.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {
namespace {

// As a Tecplot zone of 100 x 100 points in I, J order: x, y and the number.
void append_raster_zone(std::string& text, const LobeRaster& raster, const std::string& title) {
  append_all(text, "ZONE T=", detail::tecplot_title(title), " I=", LobeRaster::side, " J=", LobeRaster::side,
             " F=POINT\n");
  for (std::size_t row = 0; row < LobeRaster::side; ++row) {
    for (std::size_t column = 0; column < LobeRaster::side; ++column) {
      const Point at = raster.centre(column, row);
      append_all(text, at.x, "\t", at.y, "\t", raster.lobes[row * LobeRaster::side + column], "\n");
    }
  }
}

constexpr std::size_t min_words = 8;  // arguments that are not options
constexpr const char* published_tangle_form =
    "lober <u> <s> <lobefile> <manifile> <pipsfile> <uskip> <sskip> <nzones> [<lobebfile> [<lobeseq>]] [-BIP k]";
constexpr const char* boundary_file = "separ.dat";
constexpr std::string_view raster_header = "VARIABLES=\"x\"\"y\"\"lobe\"";
constexpr std::string_view zones_header = "VARIABLES=\"x\"\"y\"";

struct PublishedTangleRequest {
  std::array<std::string, 2> manifolds;
  std::string raster, both, pips, lobes, sequence;  // the last two may be empty
  std::array<std::size_t, 2> skip{};
  std::size_t pairs = 0;
  std::optional<std::size_t> bip;
};

std::size_t whole_number(const std::string& text, const char* what) {
  constexpr std::size_t most = 1'000'000'000;
  std::size_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || value > most) {
    throw UsageError(std::string(what) + " has to be a whole number from 0, not \"" + text + "\" (" +
                     published_tangle_form + ")");
  }
  return value;
}

bool is_option(const std::string& argument) {
  return argument.starts_with("-") && argument != "-";
}

PublishedTangleRequest parse_published_tangle(const std::vector<std::string>& arguments) {
  PublishedTangleRequest request;
  std::vector<std::string> words;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (arguments[k] == "-BIP") {
      if (++k == arguments.size())
        throw UsageError("-BIP k is given without k, the number of a pip (" + std::string(published_tangle_form) + ")");
      request.bip = whole_number(arguments[k], "-BIP k");
    } else if (is_option(arguments[k])) {
      throw UsageError("unknown option " + arguments[k] + " (" + published_tangle_form + ")");
    } else {
      words.push_back(arguments[k]);
    }
  }
  if (words.size() < min_words) throw UsageError("arguments are missing: " + std::string(published_tangle_form));
  if (words.size() > min_words + 2)
    throw UsageError("too many arguments: " + words[min_words + 2] + " (" + published_tangle_form + ")");
  request.manifolds = {words[0], words[1]};
  request.raster = words[2];
  request.both = words[3];
  request.pips = words[4];
  request.skip = {whole_number(words[5], "<uskip>"), whole_number(words[6], "<sskip>")};
  request.pairs = whole_number(words[7], "<nzones>");
  if (request.pairs == 0)
    throw UsageError("<nzones> has to be at least 1, not 0 (" + std::string(published_tangle_form) + ")");
  if (words.size() > min_words) request.lobes = words[min_words];
  if (words.size() > min_words + 1) request.sequence = words[min_words + 1];
  return request;
}

std::string sequence_file(const PublishedTangleRequest& request, std::size_t number) {
  return request.sequence + std::to_string(number) + ".dat";
}

std::vector<Output> outputs_of(const PublishedTangleRequest& request, std::size_t lobes) {
  std::vector<Output> outputs{{"<lobefile>", request.raster},
                              {"<manifile>", request.both},
                              {"<pipsfile>", request.pips},
                              {"this command", boundary_file}};
  if (!request.lobes.empty()) outputs.push_back({"<lobebfile>", request.lobes});
  if (!request.sequence.empty()) {
    for (std::size_t k = 0; k < lobes; ++k) outputs.push_back({"<lobeseq>", sequence_file(request, k)});
  }
  return outputs;
}

// The zones from `skip` on, as manifolds.
std::vector<NamedCurve> read_zones(const PublishedTangleRequest& request, std::size_t which) {
  const std::string& path = request.manifolds[which];
  const std::size_t skip = request.skip[which];
  CurveFile file = read_curve_file(path, {.hash = false});
  if (file.zones.size() < skip + request.pairs) {
    throw DataError(path + ": has " + counted(file.zones.size(), "zone", "zones") + ", but " +
                    std::to_string(request.pairs) + " from number " + std::to_string(skip) + " on are asked for");
  }
  std::vector<NamedCurve> curves;
  for (std::size_t k = skip; k < skip + request.pairs; ++k) {
    NamedCurve input;
    input.curve = {std::move(file.zones[k].points), false, file.zones[k].title};
    input.file = path;
    input.zone = k;
    input.zones = file.zones.size();
    validate(input.curve, spec_of(input));
    curves.push_back(std::move(input));
  }
  return curves;
}

std::string table_of(std::size_t pair, const Tangle& found) {
  std::string text = fmt::format("zone {}: {}, {}", pair, counted(found.pips.size(), "pip", "pips"),
                                 counted(found.lobes.size(), "lobe", "lobes"));
  text += found.boundary ? fmt::format(", bip {}\n", found.boundary->bip) : "\n";
  const Table pips({{"pip", 6, Align::right, 0}, {"x", 24}, {"y", 24}});
  if (!found.pips.empty()) text += pips.head();
  for (std::size_t k = 0; k < found.pips.size(); ++k) {
    text += pips.row({std::to_string(k), fmt::format("{}", found.pips[k].at.x), fmt::format("{}", found.pips[k].at.y)});
  }
  const Table lobes({{"lobe", 6, Align::right, 0}, {"signed area", 24}, {"+-", 10}});
  if (!found.lobes.empty()) text += lobes.head();
  for (std::size_t k = 0; k < found.lobes.size(); ++k) {
    const double area = found.lobes[k].area;
    text += lobes.row({std::to_string(k), fmt::format("{}", area), fmt::format("{:.1e}", found.rounding(area))});
  }
  return text;
}

// The contents of the files, for all pairs.
struct PublishedZones {
  std::string raster = std::string(raster_header) + "\n";
  std::vector<Zone> both, pips, lobes, boundaries;
  std::string table;  // on standard output

  void add(std::size_t pair, const Tangle& found) {
    std::string prefix;
    append_all(prefix, "zone=", pair);
    table += table_of(pair, found);
    append_raster_zone(raster, rasterise(found), prefix);
    for (const CurveView& manifold : {found.u(), found.s()}) {
      both.push_back({"", {manifold.points.begin(), manifold.points.end()}});
    }
    for (std::size_t k = 0; k < found.lobes.size(); ++k) {
      std::vector<Point> outline = lobe_outline(found, k);
      outline.push_back(outline[0]);
      lobes.push_back({prefix + " lobe=" + std::to_string(k), std::move(outline)});
    }
    if (!found.boundary) return;
    pips.push_back({"", pips_of(found)});
    boundaries.push_back({"", boundary_outline(found)});
  }
};

// As for <rslt> of the other forms: what is named by its place replaces only what this form writes there, Tecplot text
// with these variables.
void require_earlier_results(const PublishedTangleRequest& request) {
  const auto require = [](const std::string& option, const std::string& path, std::string_view header) {
    std::error_code ignored;
    if (path.empty() || !std::filesystem::is_regular_file(path, ignored)) return;
    std::ifstream file(path, std::ios::binary);
    std::string begin(header.size(), '\0');
    file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (file.gcount() == 0 || begin == header) return;
    throw UsageError(option + " would overwrite " + path + ", which is not an earlier result (" + std::string(header) +
                     "); remove it first, or name another file");
  };
  require("<lobefile>", request.raster, raster_header);
  require("<manifile>", request.both, zones_header);
  require("<pipsfile>", request.pips, zones_header);
  require("<lobebfile>", request.lobes, zones_header);
}

void write(const PublishedTangleRequest& request, const PublishedZones& zones) {
  write_file(request.raster, zones.raster);
  write_tecplot(request.both, zones.both);
  write_tecplot(request.pips, zones.pips, ZoneLines::always);
  write_tecplot(boundary_file, zones.boundaries);
  if (!request.lobes.empty()) write_tecplot(request.lobes, zones.lobes);
  if (request.sequence.empty()) return;
  for (std::size_t k = 0; k < zones.lobes.size(); ++k) {
    write_tecplot(sequence_file(request, k), {&zones.lobes[k], 1});
  }
}

}  // namespace

bool is_published_tangle(const std::vector<std::string>& arguments) {
  const auto words = std::count_if(arguments.begin(), arguments.end(), [](const auto& a) { return !is_option(a); });
  return static_cast<std::size_t>(words) >= min_words ||
         std::find(arguments.begin(), arguments.end(), "-BIP") != arguments.end();
}

void run_published_tangle(const std::vector<std::string>& arguments) {
  const PublishedTangleRequest request = parse_published_tangle(arguments);
  check_outputs(outputs_of(request, 1), request.manifolds);
  require_earlier_results(request);
  Progress progress;
  progress.phase("reading", 0, 0.3);
  std::array<std::vector<NamedCurve>, 2> manifolds;
  for (std::size_t k = 0; k < 2; ++k) {
    progress.file(k, 2);
    manifolds[k] = read_zones(request, k);
  }
  PublishedZones zones;
  TangleOptions options;
  options.bip = request.bip;
  for (std::size_t pair = 0; pair < request.pairs; ++pair) {
    const double share = 0.5 / static_cast<double>(request.pairs);
    const double begin = 0.3 + static_cast<double>(pair) * share;
    progress.phase("tangle", begin, begin + share);
    options.progress = [&](double fraction) { return progress.advance(fraction); };
    zones.add(pair, tangle_of(manifolds[0][pair], manifolds[1][pair], options));
  }
  progress.phase("writing", 0.8, 1);
  check_outputs(outputs_of(request, zones.lobes.size()), request.manifolds);  // now their number is known
  write(request, zones);
  if (!takes_standard_output(outputs_of(request, zones.lobes.size()))) print(zones.table);
}

}  // namespace lober::cli
