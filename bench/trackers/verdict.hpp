// A library's answer to a case, judged by the exact areas.
#pragma once

#include <array>
#include <string>

#include "tests/trust/tracker_case.hpp"

namespace lober::bench {

/// From good to bad. In place of 1e-9 of the union stands the error that coordinates rounded to doubles explain, where
/// that is more.
enum class Verdict {
  not_taken,  ///< the library has no coordinates of this kind
  right,      ///< all four areas, and all four results are valid polygons
  invalid,    ///< areas are right, a result is not valid
  imprecise,  ///< an area is off by less than a thousandth of itself, by more than 1e-9 of the union
  lost,       ///< an area is off by more than a hundredth of itself, by less than 1e-9 of the union
  no_input,   ///< the library does not take A or B as valid, and its answer is not right
  failed,     ///< an exception, a crash, or no end within the time limit
  wrong,      ///< an area is off by more than a thousandth of itself and 1e-9 of the union
};

struct Judgement {
  Verdict verdict = Verdict::right;
  std::string text;  ///< for a table: the verdict with the area that shows it best
};

/// `answer` is what a rival program prints (rival_program.hpp).
[[nodiscard]] Judgement judge(const std::string& answer, const trust::TrackerCase& given);

}  // namespace lober::bench
