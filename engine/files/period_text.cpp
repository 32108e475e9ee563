#include <cmath>
#include <numbers>

#include "engine/files/number.hpp"
#include "lober/curve/cylinders.hpp"

namespace lober {
using namespace detail;

bool take_period(std::string_view text, Periods& periods) {
  if (text.size() < 3 || (text[0] != 'x' && text[0] != 'y') || text[1] != '=') return false;
  std::string_view number = text.substr(2);
  const bool of_pi = number.ends_with("pi");
  if (of_pi) number.remove_suffix(2);
  double factor = 1;
  const bool is_known = (of_pi && number.empty()) || parse_number(number, factor) == NumberKind::finite;
  const double period = of_pi ? factor * std::numbers::pi : factor;
  if (!is_known || !(period > 0) || !std::isfinite(period)) return false;
  (text[0] == 'x' ? periods.x : periods.y) = period;
  return true;
}

}  // namespace lober
