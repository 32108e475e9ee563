#include "engine/dynamics/transport/sweep/sweep_value.hpp"

#include <exception>

#include "lober/base/error.hpp"

namespace lober::detail {

std::optional<KnownTurnstile> continued_to(const Family& family, double value, const KnownTurnstile& from,
                                           double step) {
  try {
    const FamilyMember member = family(value);
    return continued_turnstile(*member.map, member.connection, from, step);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception&) {  // who then works it out from nothing learns why
    return std::nullopt;
  }
}

}  // namespace lober::detail
