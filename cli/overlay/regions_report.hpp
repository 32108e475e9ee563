// Everything that `lober overlay --rule` found, for the table, the JSON and the files to show.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "cli/overlay/overlay_report.hpp"
#include "lober/regions.hpp"

namespace lober::cli {

struct RegionsReport {
  std::array<NamedCurve, 2> inputs;
  FillRule rule = FillRule::nonzero;
  IndexKind index = IndexKind::automatic;  ///< as asked for
  bool areas_only = false;
  Regions result;
  std::array<RegionPieces, 4> pieces;  ///< by Pairing; empty for totals only
  double read_seconds = 0, pieces_seconds = 0, write_seconds = 0;

  [[nodiscard]] const RegionPieces& pieces_of(Pairing pairing) const {
    return pieces[static_cast<std::size_t>(pairing)];
  }
};

/// The short aligned table for people.
[[nodiscard]] std::string regions_table(const RegionsReport& report);

/// Writes the JSON object; `seconds_so_far` as for write_overlay_json.
void write_regions_json(const std::string& path, RegionsReport& report, const std::function<double()>& seconds_so_far);

/// One Tecplot zone for each piece of C1 \ C2, then of C2 \ C1, as write_lobes.
void write_region_lobes(const std::string& path, const RegionsReport& report);

}  // namespace lober::cli
