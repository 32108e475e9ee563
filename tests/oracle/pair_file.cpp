#include "tests/oracle/pair_file.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/oracle/exact_curve.hpp"

namespace lober::oracle {
namespace {

bool removed_one(CurvePair& pair, Polygon CurvePair::*member, const std::function<bool(const CurvePair&)>& fails) {
  bool any = false;
  for (std::size_t k = (pair.*member).size(); k-- > 0;) {
    CurvePair smaller = pair;
    (smaller.*member).erase((smaller.*member).begin() + static_cast<std::ptrdiff_t>(k));
    if (!is_simple(smaller.*member) || !fails(smaller)) continue;
    pair = smaller;
    any = true;
  }
  return any;
}

}  // namespace

std::string as_source(const CurvePair& pair) {
  std::ostringstream text;
  text << "// " << pair.family << ", seed " << pair.seed << "\n" << std::hexfloat;
  for (const auto& [name, polygon] : {std::pair{"first", &pair.first}, std::pair{"second", &pair.second}}) {
    text << "const std::vector<lober::Point> " << name << "{";
    for (const Point& point : *polygon) text << "{" << point.x << ", " << point.y << "}, ";
    text << "};\n";
  }
  return text.str();
}

std::string write_pair(const CurvePair& pair, const std::string& remark) {
  const char* chosen = std::getenv("LOBER_FAILURES");
  const std::filesystem::path folder =
      chosen != nullptr ? std::filesystem::path(chosen) : std::filesystem::temp_directory_path() / "lober-failures";
  std::filesystem::create_directories(folder);
  std::string name = pair.family + "-" + std::to_string(pair.seed) + ".txt";
  std::replace(name.begin(), name.end(), ' ', '_');
  const std::string path = folder / name;
  std::ofstream(path) << as_source(pair) << "/*\n" << remark << "*/\n";
  return path;
}

CurvePair minimised(CurvePair pair, const std::function<bool(const CurvePair&)>& fails) {
  bool smaller = true;
  while (smaller) {
    const bool first = removed_one(pair, &CurvePair::first, fails);
    smaller = removed_one(pair, &CurvePair::second, fails) || first;
  }
  return pair;
}

}  // namespace lober::oracle
