// Writers of the formats that are points and little else.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/base/output_file.hpp"
#include "lober/curve/formats.hpp"

namespace lober::detail {

/// Points that cannot be read back are not written. Throws DataError.
void require_finite(const std::string& path, std::span<const Point> points);

/// A line for each point, with `behind` at its end. Formats in parallel, writes in order.
void put_points(OutputFile& file, std::span<const Point> points, char separator, std::string_view behind = {});
void put_zones(OutputFile& file, std::span<const Zone> zones, ZoneLines lines);
[[nodiscard]] std::string_view as_bytes(std::span<const Point> points);

/// Whether the name ends in .tsv, so that columns are parted by tabs and not by blanks.
[[nodiscard]] bool is_parted_by_tabs(std::string_view path);

/// Several curves are parted by lines "> TITLE", as GMT has them.
void put_text(OutputFile& file, std::span<const Zone> zones, const WriteOptions& options);
/// Several curves are told apart by a third column, the number of the curve.
void put_csv(OutputFile& file, std::span<const Zone> zones, const WriteOptions& options);
void put_tecplot(OutputFile& file, std::span<const Zone> zones, const WriteOptions& options);
/// One curve.
void put_npy(OutputFile& file, std::span<const Zone> zones, const WriteOptions& options);
void put_raw(OutputFile& file, std::span<const Zone> zones, const WriteOptions& options);

}  // namespace lober::detail
