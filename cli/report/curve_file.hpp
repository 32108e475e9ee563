// Files of curves that commands write: in any format, with notes on where the curves come from.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lober/curve/files.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

struct CurveFileOptions {
  std::string format = {};  ///< by its name; empty: that of the ending, Tecplot without one, text for "-"
  bool closed = false;      ///< polygons, in formats that tell them from lines
  std::vector<std::pair<std::string, std::string>> notes = {};
  ZoneLines zone_lines = ZoneLines::where_needed;  ///< those of a Tecplot file
};

/// "FILE#ZONE sha256 HASH".
[[nodiscard]] std::string note_on(const NamedCurve& input);
template <typename Curves>
[[nodiscard]] std::vector<std::string> notes_on(const Curves& curves) {
  std::vector<std::string> notes;
  notes.reserve(curves.size());
  for (const NamedCurve& curve : curves) notes.push_back(note_on(curve));
  return notes;
}

/// The program, the command, its inputs (notes_on), the system, and the options with the values that were used: nothing
/// that differs from one run to the next.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> notes_of(std::string_view command,
                                                                        const operations::Outcome& outcome,
                                                                        const std::vector<std::string>& inputs,
                                                                        const std::string& system = {});

/// Throws UsageError, DataError.
void write_curve_file(const std::string& path, std::span<const Zone> zones, const CurveFileOptions& options);
/// The same for one curve.
void write_curve_file(const std::string& path, std::span<const Point> points, const CurveFileOptions& options);

}  // namespace lober::cli
