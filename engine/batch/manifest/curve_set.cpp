#include "engine/batch/manifest/curve_set.hpp"

#include <glob.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>

#include "engine/batch/manifest/file_unit.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "lober/curve/zone_names.hpp"

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

std::optional<std::size_t> position_of(const std::string& choice) {
  std::size_t number = 0;
  const char* const end = choice.data() + choice.size();
  const auto [stop, error] = std::from_chars(choice.data(), end, number);
  if (stop != end || error != std::errc{}) return std::nullopt;
  return number;
}

// Whether a number may be the id of a group: in tables for which columns are chosen, and in files of arrays.
bool may_be_grouped(const std::string& path, const std::string& columns) {
  std::error_code ignored;
  if (!columns.empty()) return true;
  return fs::is_regular_file(path, ignored) && fs::file_size(path, ignored) > 0 && !begins_as_text(path);
}

// The curves of `whole` that `choice` names, or all of them for "*". A number is the id of a group in some files and a
// position in others, which the file says.
std::vector<CurveSource> zones_of(const Manifest& manifest, const LocatedText& pattern, const CurveSource& whole,
                                  const std::string& choice) {
  const auto zone = [&](std::size_t number, std::string name) {
    CurveSource one = whole;
    one.zone = number;
    one.zone_name = std::move(name);
    return one;
  };
  const std::optional<std::size_t> position = position_of(choice);
  const std::string path = located(manifest.path, whole.file);
  if (position && !may_be_grouped(path, whole.columns)) return {zone(*position, {})};
  CurveFile content;
  try {
    require_regular(path);
    content = read_curve_file(path, {.hash = false, .columns = whole.columns});
  } catch (const DataError&) {
    if (position && whole.columns.empty()) return {zone(*position, {})};  // an error of its jobs, and the others run
    throw;
  }
  content.path = whole.file;
  const ZoneNames names(content);
  const auto named = [&](std::size_t k) { return zone(k, names.named_by_title(k) ? names.name(k) : std::string()); };
  if (choice == "*") {
    std::vector<CurveSource> sources;
    for (std::size_t k = 0; k < content.zones.size(); ++k) sources.push_back(named(k));
    return sources;
  }
  try {
    return {named(names.find(choice))};
  } catch (const DataError& error) {
    if (position && !content.titled_by_group) return {zone(*position, {})};  // as above
    manifest.fail(pattern.line, pattern.key, whole.file + std::string(error.what()).substr(whole.file.size() + 1));
  }
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
