// `lober batch picture STORE`: what the page of a batch shows as heat maps, in the style of all other pictures.

#include "cli/batch/batch_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "cli/batch/job_values.hpp"
#include "cli/picture/heat_map.hpp"
#include "cli/picture/picture_options.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/report.hpp"
#include "engine/base/nearest_word.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

struct BatchPictureRequest {
  std::string store, operation, x, y, value;
  std::vector<std::string> where;  // NAME=VALUE
  std::int64_t overlaps = -1;
  PictureRequest picture;
};

std::string plain(const Json& value) {
  return value.is_string()   ? short_name(value.get<std::string>())
         : value.is_number() ? rounded(value.get<double>())
                             : value.dump();
}

// The number n where the curve is image(FILE, ..., iterates=n, ...), 0 where it is FILE itself; nothing otherwise.
std::optional<std::string> iterate_of(const std::string& curve, const std::string& file) {
  if (curve == file) return "0";
  const std::string key = ", iterates=";
  const std::size_t at = curve.find(key);
  if (!curve.starts_with("image(" + file + ",") || at == std::string::npos) return std::nullopt;
  return curve.substr(at + key.size(), curve.find_first_of(",)", at + key.size()) - at - key.size());
}

// Names of curves without what all of them have in common, which the axis says: the file of all, or the curve of which
// they are images.
HeatAxis names_axis(const std::string& name, std::vector<std::string> names) {
  const std::size_t hash = names.front().find('#');
  const std::string file = names.front().substr(0, hash == std::string::npos ? 0 : hash + 1);
  const bool one_file = !file.empty() && std::all_of(names.begin(), names.end(),
                                                     [&](const std::string& one) { return one.starts_with(file); });
  if (one_file) {
    for (std::string& one : names) one.erase(0, file.size());
    return HeatAxis::of_names(name + " curve, " + file, std::move(names));
  }
  const std::string image = "image(";
  const std::string& first = names.front();
  const std::string base =
      first.starts_with(image) ? first.substr(image.size(), first.find(',') - image.size()) : first;
  std::vector<std::string> iterates;
  for (const std::string& one : names) {
    const std::optional<std::string> iterate = iterate_of(one, base);
    if (!iterate) return HeatAxis::of_names(name, std::move(names));
    iterates.push_back(*iterate);
  }
  if (iterates.size() < 2) return HeatAxis::of_names(name, std::move(names));
  return HeatAxis::of_names(name + " curve, iterate of " + base, std::move(iterates));
}

// The different values of a name, in order, and the position of each.
struct Steps {
  std::vector<Json> values;
  std::map<Json, std::size_t> positions;

  Steps(const JobValues& jobs, const std::vector<std::size_t>& chosen, const std::string& name) {
    for (const std::size_t k : chosen) {
      const Json value = jobs.value(k, name);
      if (!value.is_null() && positions.emplace(value, values.size()).second) values.push_back(value);
    }
    if (!are_numbers()) return;
    std::sort(values.begin(), values.end());
    for (std::size_t k = 0; k < values.size(); ++k) positions[values[k]] = k;
  }
  [[nodiscard]] bool are_numbers() const {
    return std::all_of(values.begin(), values.end(), [](const Json& value) { return value.is_number(); });
  }
  [[nodiscard]] std::optional<std::size_t> number_of(const Json& value) const {
    const auto found = positions.find(value);
    return found == positions.end() ? std::nullopt : std::optional(found->second);
  }
  [[nodiscard]] HeatAxis axis(const std::string& name, std::size_t max_names = 12) const {
    if (are_numbers()) {
      std::vector<double> numbers;
      for (const Json& value : values) numbers.push_back(value.get<double>());
      return HeatAxis::of_numbers(name, numbers, max_names);
    }
    std::vector<std::string> names;
    for (const Json& value : values) names.push_back(plain(value));
    return names_axis(name, std::move(names));
  }
};

void require_name(const char* option, const std::string& name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  throw UsageError(std::string(option) + " " + name + ": the jobs have no such " +
                   (known.empty() ? std::string("value") : "value; there are " + detail::joined(known)) +
                   detail::did_you_mean(name, known));
}

// The jobs that have the values of --where.
std::vector<std::size_t> chosen_jobs(const JobValues& jobs, const std::vector<std::string>& where) {
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < jobs.size(); ++k) chosen.push_back(k);
  for (const std::string& one : where) {
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos) throw UsageError("--where " + one + ": it has to be of the form NAME=VALUE");
    const std::string name = one.substr(0, equals), text = one.substr(equals + 1);
    const std::optional<double> number = number_of(text);
    require_name("--where", name, jobs.varied());
    std::erase_if(chosen, [&](std::size_t k) {
      const Json value = jobs.value(k, name);
      return !(value.is_number() ? number && value.get<double>() == *number : plain(value) == text || value == text);
    });
    if (chosen.empty()) throw UsageError("--where " + one + ": no job that is done has this value");
  }
  return chosen;
}

// Whatever distinguishes jobs with the same x and y, to say so.
[[noreturn]] void fail_of_two(const JobValues& jobs, std::size_t a, std::size_t b,
                              const std::vector<std::string>& axes) {
  std::string text = "several jobs have the same ";
  for (std::size_t k = 0; k < axes.size(); ++k) {
    text += (k > 0 ? " and " : "") + axes[k] + " = " + plain(jobs.value(a, axes[k]));
  }
  const auto differing = std::find_if(jobs.varied().begin(), jobs.varied().end(), [&](const std::string& name) {
    return jobs.value(a, name) != jobs.value(b, name);
  });
  if (differing != jobs.varied().end()) {
    text +=
        "; they differ in " + *differing + ": choose by --where " + *differing + "=" + plain(jobs.value(a, *differing));
  }
  throw UsageError(text);
}

std::string title_of(const BatchPictureRequest& request, const JobValues& jobs, const std::string& what) {
  const Json system = jobs.value(0, "system");
  std::string title =
      (system.is_string() ? short_name(system.get<std::string>()) : short_name(request.store)) + ": " + what;
  for (const std::string& one : request.where) title += ", " + one;
  return title;
}

// One quantity over another: dots and a line, with error bars where the store has them.
void add_curve(Figure& figure, const JobValues& jobs, const std::vector<std::size_t>& chosen, const std::string& x,
               const std::string& value) {
  const Steps steps(jobs, chosen, x);
  const HeatAxis axis = steps.axis(x, 0);
  std::map<std::size_t, std::size_t> job_at;
  for (const std::size_t k : chosen) {
    const auto at = steps.number_of(jobs.value(k, x));
    if (!at || !jobs.result(k, value).is_number()) continue;
    if (const auto [found, is_new] = job_at.emplace(*at, k); !is_new) fail_of_two(jobs, found->second, k, {x});
  }
  Layer dots = dot_layer(value, counted(job_at.size(), "job", "jobs"), {}, 1.4);
  Rectangle box;
  bool has_errors = false;
  for (const auto& [at, k] : job_at) {
    const double along = axis.axis.categories.empty() ? steps.values[at].get<double>() : static_cast<double>(at);
    const double height = jobs.result(k, value).get<double>();
    double error = 0;
    for (const std::string& name : {value + "_error", "discretisation_" + value}) {
      if (const Json one = jobs.result(k, name); one.is_number()) error = one.get<double>(), has_errors = true;
    }
    dots.points.push_back({along, height});
    dots.errors.push_back(error);
    box.add({along, height - error});
    box.add({along, height + error});
  }
  if (!has_errors) dots.errors.clear();
  figure.layers.push_back(line_layer(value + " (line)", "", palette::ink, 0.5));
  figure.layers.back().lines.push_back(polyline(dots.points, false, value));
  figure.layers.push_back(std::move(dots));
  figure.x = axis.axis;
  figure.y.name = value;
  figure.plane = false;
  figure.window = with_margin(box);
}

void add_map(Figure& figure, const JobValues& jobs, const std::vector<std::size_t>& chosen, const std::string& x,
             const std::string& y, const std::string& value) {
  const Steps columns(jobs, chosen, x), rows(jobs, chosen, y);
  std::vector<HeatCell> cells;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> job_at;
  for (const std::size_t k : chosen) {
    const auto column = columns.number_of(jobs.value(k, x)), row = rows.number_of(jobs.value(k, y));
    if (!column || !row || !jobs.result(k, value).is_number()) continue;
    const auto [found, is_new] = job_at.emplace(std::pair(*column, *row), k);
    if (!is_new) fail_of_two(jobs, found->second, k, {x, y});
    cells.push_back({*column, *row, jobs.result(k, value).get<double>()});
  }
  add_heat_map(figure, columns.axis(x), rows.axis(y), cells);
}

// The first result that differs between jobs and does not repeat what was varied, such as the energy of an escape.
std::string first_that_varies(const JobValues& jobs) {
  for (const std::string& result : jobs.results()) {
    if (result.ends_with("_error")) continue;
    const auto same_as = [&](const std::string& other) {
      for (std::size_t k = 0; k < jobs.size(); ++k) {
        if (jobs.result(k, result) != jobs.value(k, other)) return false;
      }
      return true;
    };
    bool varies = false;
    for (std::size_t k = 1; k < jobs.size(); ++k) varies |= jobs.result(k, result) != jobs.result(0, result);
    if (varies && std::none_of(jobs.varied().begin(), jobs.varied().end(), same_as)) return result;
  }
  return jobs.results().front();
}

Figure jobs_figure(const BatchPictureRequest& request, const JobValues& jobs) {
  const std::vector<std::string>& varied = jobs.varied();
  if (jobs.results().empty()) throw DataError(request.store + ": the jobs have no numbers to draw");
  const auto is_result = [&](const char* name) {
    return std::find(jobs.results().begin(), jobs.results().end(), name) != jobs.results().end();
  };
  std::string value = request.value;
  for (const char* const usual : {"intersection", "lobe_area12", "flux12"}) {
    if (value.empty() && is_result(usual)) value = usual;
  }
  if (value.empty()) value = first_that_varies(jobs);
  require_name("--value", value, jobs.results());
  std::vector<std::string> free;  // that neither --where nor an axis fixes
  for (const std::string& name : varied) {
    const bool is_fixed = std::any_of(request.where.begin(), request.where.end(),
                                      [&](const std::string& one) { return one.starts_with(name + "="); });
    if (!is_fixed && name != request.x && name != request.y) free.push_back(name);
  }
  std::string x = request.x, y = request.y;
  if (!x.empty()) require_name("--x", x, varied);
  if (!y.empty()) require_name("--y", y, varied);
  const auto next = [&] {
    std::string name = free.empty() ? "" : free.front();
    if (!free.empty()) free.erase(free.begin());
    return name;
  };
  if (x.empty()) x = next();
  if (y.empty()) y = next();
  if (x.empty()) {
    throw UsageError(request.store + ": there is nothing over which to draw: " +
                     (jobs.size() == 1 ? "the store has one job" : "the jobs do not differ in any option") +
                     "; --overlaps JOB draws the overlaps of the lobes of a tangle");
  }
  Figure figure{.what = "Numbers of the jobs of a batch", .title = title_of(request, jobs, value)};
  const std::vector<std::size_t> chosen = chosen_jobs(jobs, request.where);
  y.empty() ? add_curve(figure, jobs, chosen, x, value) : add_map(figure, jobs, chosen, x, y, value);
  return figure;
}

// The overlaps of the lobes of one job, for i against j and for j against i.
Figure overlaps_figure(const BatchPictureRequest& request, const JobValues& jobs) {
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    if (jobs.number(k) != request.overlaps) continue;
    const auto i = jobs.list(k, "overlap_i"), j = jobs.list(k, "overlap_j"), areas = jobs.list(k, "overlap_areas");
    if (areas.empty() && jobs.value(k, "overlaps") != true) {
      throw UsageError("--overlaps " + std::to_string(request.overlaps) +
                       ": the job has no overlaps of lobes; a job of tangle has them with the option overlaps = true");
    }
    const Json counted_lobes = jobs.value(k, "lobes");
    std::size_t lobes = counted_lobes.is_number() ? counted_lobes.get<std::size_t>() : 0;
    std::vector<HeatCell> cells;
    for (std::size_t n = 0; n < areas.size(); ++n) {
      const auto a = static_cast<std::size_t>(i[n]), b = static_cast<std::size_t>(j[n]);
      cells.push_back({a, b, areas[n]});
      if (a != b) cells.push_back({b, a, areas[n]});
      lobes = std::max({lobes, a + 1, b + 1});
    }
    std::vector<double> numbers;
    for (std::size_t n = 0; n < std::max<std::size_t>(lobes, 1); ++n) numbers.push_back(static_cast<double>(n));
    Figure figure{.what = "Overlaps of the lobes of a tangle",
                  .title = title_of(request, jobs, "overlap areas, job " + std::to_string(request.overlaps))};
    add_heat_map(figure, HeatAxis::of_numbers("lobe i", numbers), HeatAxis::of_numbers("lobe j", numbers), cells);
    return figure;
  }
  throw UsageError("--overlaps " + std::to_string(request.overlaps) + ": no job of this number is done");
}

}  // namespace

void run_batch_picture(const std::vector<std::string>& arguments) {
  BatchPictureRequest request;
  OptionParser parser(
      "Draws a number of the jobs of a store over two options, parameters or curves that differ, as a heat map; over "
      "one, as a curve; or the overlap areas of the lobes of a tangle.",
      "lober batch picture");
  parser.add_example("lober batch picture job.results --picture map.pdf", "the first two things that differ");
  parser.add_example("lober batch picture job.results --x K --value flux12 --picture flux.svg",
                     "a flux over a parameter of the system");
  parser.add("STORE", request.store, "The store, a file that lober batch run has written.").required();
  parser
      .add("--x", request.x,
           "The option, parameter or curve (first, second) along the x axis (default: the first that differs among the "
           "jobs).")
      .value("NAME");
  parser.add("--y", request.y, "The same for the y axis (default: the next one that differs, if there is one).")
      .value("NAME");
  parser
      .add(
          "--value", request.value,
          "The result that is drawn, a column of lober batch export (default: intersection, lobe_area12, flux12 or the "
          "first number).")
      .value("NAME");
  parser.add("--where", request.where, "Draw only jobs with this value of an option or parameter; may be given again.")
      .value("NAME=VALUE");
  const Option overlaps = parser
                              .add("--overlaps", request.overlaps,
                                   "Draw the overlap areas of lobes i and j of the job with this number, from 0 "
                                   "(default: numbers of the jobs).")
                              .value("JOB");
  parser
      .add("--operation", request.operation,
           "The operation whose jobs are drawn (default: the one that the store has).")
      .value("NAME");
  add_picture_options(parser, request.picture, "the heat map or the curve");
  if (!parser.parse(arguments)) return;
  const std::vector<Output> outputs = checked_outputs({}, std::vector{request.store}, request.picture.outputs());
  if (outputs.empty())
    throw UsageError("the picture is missing; give --picture or --data (see lober batch picture --help)");
  Progress progress;
  progress.phase("results", 0, 0.4);
  const JobValues jobs(request.store, request.operation, told_to(progress));
  progress.phase("drawing", 0.8, 1);
  write_figure(request.picture, overlaps.given() ? overlaps_figure(request, jobs) : jobs_figure(request, jobs));
}

}  // namespace lober::cli
