#include "engine/batch/manifest/curve_set.hpp"

#include <glob.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <set>

#include "engine/batch/manifest/file_unit.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {
namespace {

namespace fs = std::filesystem;

// Paths as the pattern spells them, in natural order; empty when there is no such file.
std::vector<std::string> matches(const std::string& manifest_path, const std::string& pattern) {
  std::error_code ignored;
  if (fs::exists(located(manifest_path, pattern), ignored)) return {pattern};
  // The folder is not part of the pattern, whatever characters it has.
  std::string folder = located(manifest_path, ""), escaped;
  if (fs::path(pattern).is_absolute()) folder.clear();
  for (const char c : folder) {
    if (std::string_view("*?[\\").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  glob_t found{};
  std::vector<std::string> files;
  if (glob((escaped + pattern).c_str(), GLOB_NOSORT, nullptr, &found) == 0) {
    for (std::size_t k = 0; k < found.gl_pathc; ++k) {
      if (fs::is_regular_file(found.gl_pathv[k], ignored)) {
        files.push_back(std::string(found.gl_pathv[k]).substr(folder.size()));
      }
    }
  }
  globfree(&found);
  std::sort(files.begin(), files.end(), natural_less);
  return files;
}

std::vector<CurveSource> zones_of(const Manifest& manifest, const LocatedText& pattern, const CurveSource& whole,
                                  const std::string& choice) {
  const auto zone = [&](std::size_t number) {
    CurveSource one = whole;
    one.zone = number;
    return one;
  };
  std::size_t number = 0;
  const char* const end = choice.data() + choice.size();
  const auto [stop, error] = std::from_chars(choice.data(), end, number);
  const bool is_number = stop == end && error == std::errc{};
  // A number is that of a group where columns part curves, which the file says, and else a position.
  if (is_number && whole.columns.empty()) return {zone(number)};
  const std::string path = located(manifest.path, whole.file);
  require_regular(path);
  const CurveFile content = read_curve_file(path, {.hash = false, .columns = whole.columns});
  if (is_number && !content.titled_by_group) return {zone(number)};
  std::vector<CurveSource> sources;
  for (std::size_t k = 0; k < content.zones.size(); ++k) {
    if (choice == "*" || content.zones[k].title == choice) sources.push_back(zone(k));
  }
  if (sources.empty() || (choice != "*" && sources.size() > 1)) {
    manifest.fail(
        pattern.line, pattern.key,
        whole.file + " has " + (sources.empty() ? "no" : "more than one") + " zone titled \"" + choice + "\"");
  }
  return sources;
}

}  // namespace

bool natural_less(const std::string& a, const std::string& b) {
  return strverscmp(a.c_str(), b.c_str()) < 0;
}

std::vector<CurveSource> resolve(const Manifest& manifest, const std::vector<LocatedText>& patterns) {
  std::vector<CurveSource> all;
  std::set<std::string> known;
  const auto take = [&](CurveSource source) {
    if (known.insert(source.name()).second) all.push_back(std::move(source));
  };
  for (const LocatedText& pattern : patterns) {
    if (pattern.text.empty()) {
      for (const CurveRecipe& recipe : pattern.recipes) take(CurveSource{"", std::nullopt, recipe});
      continue;
    }
    std::string files = pattern.text, choice;
    std::error_code ignored;
    if (const std::size_t at = files.rfind('#');
        at != std::string::npos && at != 0 && !fs::exists(located(manifest.path, files), ignored)) {
      choice = files.substr(at + 1);
      files.resize(at);
    }
    std::vector<std::string> found = matches(manifest.path, files);
    std::string columns;
    if (const std::size_t at = files.rfind(':'); found.empty() && at != std::string::npos && at != 0) {
      columns = files.substr(at + 1);
      files.resize(at);
      found = matches(manifest.path, files);
    }
    if (found.empty()) manifest.fail(pattern.line, pattern.key, "there is no file " + files);
    for (const std::string& file : found) {
      CurveSource whole{file};
      whole.columns = columns;
      const std::vector<CurveSource> sources =
          choice.empty() ? std::vector{whole} : zones_of(manifest, pattern, whole, choice);
      for (const CurveSource& source : sources) {
        if (pattern.recipes.empty()) take(source);
        for (const CurveRecipe& recipe : pattern.recipes) {
          CurveSource image = source;
          if (recipe.iterates != 0) image.recipe = recipe;
          take(std::move(image));
        }
      }
    }
  }
  return all;
}

}  // namespace lober::detail
