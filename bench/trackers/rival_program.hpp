// A library asked for the four overlays of a case of tests/corpus/trackers, as a program of its own: a library may
// crash or never end, and two versions of one library cannot share a program.
//
// usage: PROGRAM FILE ARRANGEMENT [integers]
// prints the version; whether the input is valid; and for each overlay its name, its area and `valid`, `not valid` or
// `error` with the reason.
#pragma once

#include <array>
#include <span>
#include <string>

#include "tests/trust/tracker_case.hpp"

namespace lober::bench {

struct RivalOverlay {
  double area = 0;
  bool valid = false;
  std::string error;  ///< the message of an exception; empty when there was none
};

struct RivalAnswer {
  bool taken = true;          ///< whether the library takes coordinates of this kind
  double grid = 0;            ///< the distance of the coordinates that it can have, 0 for doubles
  std::string invalid_input;  ///< the reason why the library calls A or B not valid; empty when they are
  std::array<RivalOverlay, 4> overlays;
};

/// The four overlays in the order of lober::all_pairings.
using RivalOverlays = RivalAnswer (*)(const trust::Shape& a, const trust::Shape& b);

/// Number of arrangements of a case: as it stands, B backwards, B from its middle vertex; and these with A and B
/// exchanged.
inline constexpr int arrangement_count = 6;
struct ArrangedShapes {
  trust::Shape a, b;
  bool exchanged = false;
};
[[nodiscard]] ArrangedShapes arranged(const trust::TrackerCase& given, int arrangement);

/// The main function. `with_integers` is null where the library has floating-point coordinates alone.
int run_rival_program(std::span<char* const> arguments, const std::string& version, RivalOverlays overlays,
                      RivalOverlays with_integers);

}  // namespace lober::bench
