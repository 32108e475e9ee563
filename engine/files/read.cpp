#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/base/file_activity.hpp"
#include "engine/base/file_bytes.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/text.hpp"
#include "engine/files/closing.hpp"
#include "engine/files/curve_spec.hpp"
#include "engine/files/foreign.hpp"
#include "engine/files/formats/format_table.hpp"
#include "engine/files/formats/gzip.hpp"
#include "engine/files/geographic.hpp"
#include "engine/files/plausible.hpp"
#include "engine/files/read_memory.hpp"
#include "engine/files/sniff.hpp"
#include "lober/curve/cylinders.hpp"
#include "lober/curve/files.hpp"
#include "lober/curve/zone_names.hpp"

namespace lober {
using namespace detail;
namespace {

bool exists(const std::string& path) {
  std::error_code ignored;
  return path == "-" || std::filesystem::exists(path, ignored);
}

}  // namespace

CurveSpec detail::split_spec(const std::string& spec) {
  const auto with_columns = [](const std::string& name) -> std::optional<CurveSpec> {
    if (exists(name)) return CurveSpec{name};
    for (std::size_t at = name.rfind(':'); at != std::string::npos && at != 0; at = name.rfind(':', at - 1)) {
      if (exists(name.substr(0, at))) return CurveSpec{name.substr(0, at), name.substr(at + 1)};
    }
    return std::nullopt;
  };
  if (const auto whole = with_columns(spec); whole && spec.find('#') == std::string::npos) return *whole;
  if (exists(spec)) return {spec};
  const std::size_t last = spec.rfind('#');
  if (last == std::string::npos || last == 0) return {spec};
  for (std::size_t at = last; at != std::string::npos && at != 0; at = spec.rfind('#', at - 1)) {
    auto found = with_columns(spec.substr(0, at));
    // In quotes it belongs to the name of a column.
    if (found && std::count(found->columns.begin(), found->columns.end(), '"') % 2 == 0) {
      found->zone = spec.substr(at + 1);
      return *found;
    }
  }
  if (const auto whole = with_columns(spec)) return *whole;
  return {spec.substr(0, last), {}, spec.substr(last + 1)};
}

CurveFile detail::read_curve_bytes(std::string name, std::span<const std::byte> bytes, std::size_t chunk_size,
                                   std::string_view columns) {
  CurveFile file;
  file.path = std::move(name);
  if (bytes.empty()) throw DataError(file.path + ": the file is empty");
  Buffer<std::byte> unpacked;
  if (is_gzip(bytes)) {
    unpacked = unzipped(file.path, bytes);
    bytes = unpacked;
    if (bytes.empty()) throw DataError(file.path + ": the file is empty");
    if (is_gzip(bytes)) throw DataError(file.path + ": is compressed by gzip twice; gunzip it once");
  }
  const FormatEntry& entry = insists_on_raw(file.path) ? entry_of(Format::raw) : recognised(bytes);
  if ((entry.format == Format::raw && !insists_on_raw(file.path)) || entry.format == Format::text) {
    std::string foreign = foreign_format(bytes);
    if (foreign.empty() && entry.format == Format::text) foreign = foreign_text(bytes.subspan(byte_order_mark(bytes)));
    if (!foreign.empty()) throw DataError(file.path + ": this is " + foreign);
  }
  if (!columns.empty() && !entry.has_columns) {
    throw DataError(file.path +
                    ": columns are chosen of tables, and arrays of NPZ, MAT, HDF5 and NetCDF files; this is " +
                    std::string(entry.name));
  }
  file.format = entry.format;
  entry.read({bytes, columns, chunk_size}, file);
  return file;
}

CurveFile read_curve_file(const std::string& path, const ReadOptions& options) {
  constexpr std::size_t worth_two_threads = std::size_t{1} << 16;
  const FileActivityScope activity(path, false);
  const FileBytes content(path);
  CurveFile file;
  std::string hash;
  parallel_if(
      options.hash && content.bytes().size() > worth_two_threads,
      [&] { file = read_curve_bytes(path, content.bytes(), default_chunk_size, options.columns); },
      [&] {
        if (options.hash) hash = sha256(content.bytes());
      });
  file.sha256 = std::move(hash);
  return file;
}

namespace {

CurveFile read_file_of(const CurveSpec& parts, const std::string& spec, const ReadOptions& options) {
  if (!parts.columns.empty() && !options.columns.empty()) {
    throw UsageError(spec + ": columns are chosen twice, by the name and by the options");
  }
  return read_curve_file(parts.file,
                         {.hash = options.hash, .columns = parts.columns.empty() ? options.columns : parts.columns});
}

}  // namespace

CurveFile read_curves(const std::string& spec, const ReadOptions& options) {
  const CurveSpec parts = split_spec(spec);
  CurveFile file = read_file_of(parts, spec, options);
  if (parts.zone) {
    Zone chosen = std::move(file.zones[ZoneNames(file).find(*parts.zone)]);
    file.zones.clear();
    file.zones.push_back(std::move(chosen));
  }
  return file;
}

NamedCurve read_curve(const std::string& spec, bool closed, const ReadOptions& options) {
  const CurveSpec parts = split_spec(spec);
  const std::string& path = parts.file;
  CurveFile file = read_file_of(parts, spec, options);
  NamedCurve result;
  result.zones = file.zones.size();
  const bool chosen = parts.zone.has_value();
  if (!chosen && result.zones > 1) {
    const std::string before = parts.columns.empty() ? path : path + ":" + parts.columns;
    const ZoneNames names(file);
    const std::string titles = names.titles();
    throw DataError(path + ": has " + std::to_string(result.zones) + " zones; choose one with " + names.range(before) +
                    (titles.empty() ? "" : ", or by its title: " + titles));
  }
  {
    const ZoneNames names(file);
    if (chosen) result.zone = names.find(*parts.zone);
    if (names.named_by_title(result.zone)) result.group = names.name(result.zone);
  }
  Zone& zone = file.zones[result.zone];
  result.curve = {std::move(zone.points), closed, zone.title.empty() ? path : zone.title};
  const std::size_t seams = unwrap(result.curve.points, options.periods);
  result.file = path;
  result.sha256 = std::move(file.sha256);
  if (closed) {
    const std::size_t given = result.curve.points.size();
    drop_closing_vertex(result.curve.points);
    require_closed_in_the_plane(result.curve.points, options.periods, spec);
    if (result.curve.points.size() == given) result.remark = closing_remark(result.curve.points);
  }
  ColumnsRemark columns = columns_remark(file.header, result.curve.points);
  if (!columns.text.empty()) result.remark = columns.text + (result.remark.empty() ? "" : "; " + result.remark);
  result.warning = std::move(columns.warning);
  if (seams > 0) {
    result.remark += result.remark.empty() ? "" : "; ";
    result.remark += "crosses the seam of a period " + std::to_string(seams) + (seams == 1 ? " time" : " times") +
                     " and is followed across it";
  }
  result.curve.latitude_first = latitude_first(file);
  result.header = std::move(file.header);
  validate(result.curve, spec);
  return result;
}

std::optional<bool> latitude_first(const CurveFile& file) {
  return detail::latitude_first(file.header);
}

void require_same_columns(const Curve& first, const Curve& second) {
  if (!first.latitude_first || !second.latitude_first || *first.latitude_first == *second.latitude_first) return;
  const bool swapped = *first.latitude_first;
  throw DataError("the columns of " + (swapped ? first : second).name + " are latitude and longitude, those of " +
                  (swapped ? second : first).name + " longitude and latitude; exchange the columns of one of them");
}

}  // namespace lober
