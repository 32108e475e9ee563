#include "bench/harness/options.hpp"

#include <charconv>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace lober::bench {
namespace {

constexpr const char* usage = R"(bench_overlay: exact overlay of two closed curves, by scene, phase and rival
  --n N              points per curve (1000000)
  --small N          points per curve for the slow rivals (10000)
  --scenes A,B,...   only these; `--scenes list` prints all
  --threads A,B,...  the first is the base of all ratios (1,2)
  --index KIND       auto, tree, grid or kd (auto)
  --repeat K         at least K runs, of which the median counts (5)
  --rivals WHICH     none, fast (GEOS, Boost) or all (CGAL and the quadratic method too) (fast)
  --limit S          seconds for one rival on one scene (60)
  --no-growth        leave out the runs from 10^4 to 10^7 points
  --markdown FILE    write the tables there too
)";

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

template <typename Number>
Number number(const std::string& option, const std::string& text, Number least) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < static_cast<double>(least) || value > 1e8) {
    throw std::invalid_argument(option + ": bad number " + text);
  }
  return static_cast<Number>(value);
}

IndexKind index_kind(const std::string& text) {
  if (text == "auto") return IndexKind::automatic;
  for (const IndexKind kind : {IndexKind::tree, IndexKind::grid, IndexKind::kd}) {
    if (text == name(kind)) return kind;
  }
  throw std::invalid_argument("--index: auto, tree, grid or kd, not " + text);
}

RivalChoice rival_choice(const std::string& text) {
  if (text == "none") return RivalChoice::none;
  if (text == "fast") return RivalChoice::fast;
  if (text == "all") return RivalChoice::all;
  throw std::invalid_argument("--rivals: none, fast or all, not " + text);
}

void choose_scenes(const std::string& list, Options& options) {
  options.scenes.clear();
  for (const std::string& name : split(list)) {
    const SceneKind* scene = find_scene(name);
    if (scene == nullptr) throw std::invalid_argument("--scenes: no scene " + name);
    options.scenes.push_back(scene);
  }
}

}  // namespace

bool parse_options(int count, char** arguments, Options& options) {
  for (const SceneKind& scene : scenes()) options.scenes.push_back(&scene);
  for (int k = 1; k < count; ++k) {
    const std::string option = arguments[k];
    if (option == "--help") {
      std::cout << usage;
      return false;
    }
    if (option == "--no-growth") {
      options.growth = false;
      continue;
    }
    if (k + 1 == count) throw std::invalid_argument(option + ": unknown, or a value is missing; see --help");
    const std::string value = arguments[++k];
    if (option == "--n") {
      options.points = number<std::size_t>(option, value, 1000);
    } else if (option == "--small") {
      options.small_points = number<std::size_t>(option, value, 1000);
    } else if (option == "--scenes") {
      if (value == "list") {
        for (const SceneKind& scene : scenes()) std::cout << scene.name << ": " << scene.description << '\n';
        return false;
      }
      choose_scenes(value, options);
    } else if (option == "--threads") {
      options.threads.clear();
      for (const std::string& part : split(value)) options.threads.push_back(number<int>(option, part, 1));
    } else if (option == "--index") {
      options.index = index_kind(value);
    } else if (option == "--repeat") {
      options.repeat = number<int>(option, value, 1);
    } else if (option == "--rivals") {
      options.rivals = rival_choice(value);
    } else if (option == "--limit") {
      options.limit = number<double>(option, value, 0.1);
    } else if (option == "--markdown") {
      options.markdown = value;
    } else if (option == "--child") {
      options.child = value;
    } else {
      throw std::invalid_argument(option + ": unknown; see --help");
    }
  }
  return true;
}

}  // namespace lober::bench
