// The format of an output, and the endings that its name may have.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lober/curve/files.hpp"

namespace lober::cli {

/// The format of a file of curves: the one that is named, as `--format` does, or that of the ending; text for "-".
/// Without an ending Tecplot, or else (`or_tecplot` is false) a UsageError, as for formats that are not written.
[[nodiscard]] Format curve_format(const std::string& path, const std::string& named, bool or_tecplot);
/// Whether a file of that format holds several curves. Throws UsageError as `curve_format` does without an ending.
[[nodiscard]] bool takes_several(const std::string& path, const std::string& named);
/// The formats in which curves are written, by their names; and their endings: ".npy, .csv, ...".
[[nodiscard]] std::vector<std::string> written_formats();
[[nodiscard]] std::string written_endings();

/// The format of a table of numbers, by the ending of its path: npy, csv, text, tecplot or raw; text for "-". Throws
/// UsageError for any other.
[[nodiscard]] Format table_format(const std::string& path);

/// Formats of pictures.
enum class PictureFormat : std::uint8_t { svg, pdf, png };

/// The format that the ending of the path names: .pdf, .png; SVG for any other, as for "-".
[[nodiscard]] PictureFormat picture_format(const std::string& path);

/// Throws UsageError, with the endings that are accepted, where the path ends as another format does than the one that
/// `option` writes: --json x.svg, --lobes x.geojson. A name without an ending is accepted, and so is one that ends in
/// a number or an assignment (out.0.6, out.K=2). Options that are not in the table, such as -o, are left to those who
/// know them. Where `format` is given, as --format does, files of curves may have any ending.
void require_fitting_name(std::string_view option, const std::string& path, const std::string& format = {});

}  // namespace lober::cli
