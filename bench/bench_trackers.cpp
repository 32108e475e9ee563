// The cases of tests/corpus/trackers by lober and by other libraries: one line a case with its exact area, lober's
// error and bar, and a verdict on each library. Columns are separated by tabs.
//
// usage: bench_trackers FOLDER RIVAL...      a RIVAL is one of the programs trackers_geos, trackers_boost, ...
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/trackers/rival_program.hpp"
#include "bench/trackers/verdict.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"

namespace lober::bench {
namespace {

// The output of a command of the shell, which has 20 seconds.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(("timeout 20 " + command + " 2>/dev/null").c_str(), "r"),
                                                   pclose);
  if (pipe == nullptr) throw std::runtime_error("cannot start " + command);
  std::string output;
  std::array<char, 4096> buffer;
  for (std::size_t count; (count = fread(buffer.data(), 1, buffer.size(), pipe.get())) > 0;)
    output.append(buffer.data(), count);
  return output;
}

std::string quoted(const std::string& text) {
  return "'" + text + "'";
}

// The worst verdict of all arrangements, and the number of arrangements that are not right where it is not all of them.
std::string verdict_of(const std::string& rival, const std::string& file, const trust::TrackerCase& given,
                       bool integers) {
  Judgement worst;
  int bad = 0;
  for (int arrangement = 0; arrangement < arrangement_count; ++arrangement) {
    const std::string command =
        quoted(rival) + " " + quoted(file) + " " + std::to_string(arrangement) + (integers ? " integers" : "");
    const Judgement one = judge(output_of(command), given);
    if (one.verdict > Verdict::right) ++bad;
    if (arrangement == 0 || one.verdict > worst.verdict) worst = one;
  }
  if (bad > 0 && bad < arrangement_count) worst.text += " (" + std::to_string(bad) + " of 6)";
  return worst.text;
}

struct OwnAnswer {
  double area = 0, bar = 0;
};

OwnAnswer own_answer(const trust::TrackerCase& given) {
  const auto value = [&](const Areas& areas) {
    const std::array<double, trust::area_count> all{areas.c1,          areas.c2,           areas.c1_minus_c2,
                                                    areas.c2_minus_c1, areas.intersection, areas.union_};
    return all[static_cast<std::size_t>(std::find(trust::area_names.begin(), trust::area_names.end(), given.operation) -
                                        trust::area_names.begin())];
  };
  const ClosedCurve c1(trust::joined(given.a)), c2(trust::joined(given.b));
  try {
    const Overlay result = overlay(c1, c2);
    return {value(result.areas), value(result.rounding)};
  } catch (const NotSimpleError&) {
    const Regions result = regions(c1, c2);
    return {value(result.areas(FillRule::nonzero)), value(result.rounding(FillRule::nonzero))};
  }
}

void print_case(const trust::TrackerCase& given, const std::string& folder, const std::vector<std::string>& rivals) {
  const OwnAnswer own = own_answer(given);
  const std::string& exact = given.areas[static_cast<std::size_t>(
      std::find(trust::area_names.begin(), trust::area_names.end(), given.operation) - trust::area_names.begin())];
  const long double error = static_cast<long double>(own.area) - std::strtold(exact.c_str(), nullptr);
  std::printf("%s\t%s\t%.2Lg\t%.2g", given.name.c_str(), exact.c_str(), error < 0 ? -error : error, own.bar);
  for (const std::string& rival : rivals) {
    const std::string file = folder + "/" + given.name + ".dat";
    std::string text = verdict_of(rival, file, given, false);
    if (given.integers && !output_of(quoted(rival) + " " + quoted(file) + " 0 integers").empty()) {
      text += "; as integers: " + verdict_of(rival, file, given, true);
    }
    std::printf("\t%s", text.c_str());
  }
  std::printf("\n");
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  using namespace lober;
  if (count < 3) {
    std::cerr << "usage: bench_trackers FOLDER RIVAL...\n";
    return 2;
  }
  try {
    const std::string folder = arguments[1];
    const std::vector<std::string> rivals(arguments + 2, arguments + count);
    const std::vector<trust::TrackerCase> cases = trust::tracker_cases(folder);
    if (cases.empty()) throw std::runtime_error("no case in " + folder);
    std::printf("# case\texact\terror of lober\tbar of lober");
    for (const std::string& rival : rivals) {
      const std::string answer = bench::output_of(bench::quoted(rival) + " " +
                                                  bench::quoted(folder + "/" + cases.front().name + ".dat") + " 0");
      if (answer.empty()) throw std::runtime_error("no answer from " + rival);
      std::printf("\t%s", answer.substr(0, answer.find('\n')).c_str());
    }
    std::printf("\n");
    for (const trust::TrackerCase& given : cases) bench::print_case(given, folder, rivals);
  } catch (const std::exception& error) {
    std::cerr << "bench_trackers: " << error.what() << "\n";
    return 1;
  }
}
