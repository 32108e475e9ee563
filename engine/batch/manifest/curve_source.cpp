#include "engine/batch/manifest/curve_source.hpp"

#include <filesystem>

#include "engine/base/text.hpp"
#include "engine/batch/manifest/file_unit.hpp"

namespace lober::detail {

std::string CurveSource::periodic() const {
  return (periods.x == 0 ? "" : " x=" + format_number(periods.x)) +
         (periods.y == 0 ? "" : " y=" + format_number(periods.y));
}

CurveUnit unit_of(const std::vector<CurveSource>& sources, const std::string& manifest_path, const KeptCurves* kept) {
  const CurveSource& any = sources.front();
  const std::string path = any.file.empty() ? "" : located(manifest_path, any.file);
  KeptNames names{path, {}};
  for (const CurveSource& source : sources) names.curves.push_back(path + '\n' + source.input_name());
  const std::size_t points = kept != nullptr && !any.recipe ? kept->points(names) : 0;
  CurveUnit unit = path.empty() ? manifold_unit(*any.recipe) : file_unit(path, sources, points);
  if (any.recipe && !path.empty()) unit = image_unit(*any.recipe, std::move(unit));
  unit.names = std::move(names);
  return unit;
}

std::vector<std::string> digests_of(const std::vector<CurveSource>& sources, const std::string& manifest_path) {
  const CurveSource& any = sources.front();
  if (any.file.empty()) return {recipe_digest(*any.recipe)};
  const std::string sha256 = file_sha256(located(manifest_path, any.file));
  std::vector<std::string> digests;
  for (const CurveSource& source : sources) {
    const std::string digest = zone_digest(sha256, source);
    digests.push_back(source.recipe ? recipe_digest(*source.recipe, digest) : digest);
  }
  return digests;
}

std::string located(const std::string& manifest_path, const std::string& file) {
  const std::filesystem::path path(file);
  if (path.is_absolute()) return file;
  const std::string folder = std::filesystem::path(manifest_path).parent_path();
  return folder.empty() ? file : folder + "/" + file;
}

}  // namespace lober::detail
