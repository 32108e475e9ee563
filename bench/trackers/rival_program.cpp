#include "bench/trackers/rival_program.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>

namespace lober::bench {
namespace {

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return text;
}

}  // namespace

int run_rival_program(std::span<char* const> arguments, const std::string& version, RivalOverlays overlays,
                      RivalOverlays with_integers) {
  if (arguments.size() < 3 || arguments.size() > 4) return 2;
  const RivalOverlays chosen = arguments.size() == 4 ? with_integers : overlays;
  if (chosen == nullptr) return 2;
  try {
    const trust::TrackerCase given = trust::read_tracker_case(arguments[1]);
    const ArrangedShapes shapes = arranged(given, std::atoi(arguments[2]));
    RivalAnswer answer = chosen(shapes.a, shapes.b);
    if (shapes.exchanged) std::swap(answer.overlays[0], answer.overlays[1]);
    std::cout << std::setprecision(17) << version << "\n"
              << answer.grid << " " << (answer.invalid_input.empty() ? "valid" : one_line(answer.invalid_input))
              << "\n";
    for (std::size_t k = 0; k < 4 && answer.taken; ++k) {
      const RivalOverlay& overlay = answer.overlays[k];
      std::cout << trust::area_names[k + 2] << " " << overlay.area << " "
                << (!overlay.error.empty() ? "error " + one_line(overlay.error)
                    : overlay.valid        ? "valid"
                                           : "not valid")
                << "\n";
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}

}  // namespace lober::bench
