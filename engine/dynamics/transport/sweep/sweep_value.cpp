#include "engine/dynamics/transport/sweep/sweep_value.hpp"

#include <exception>
#include <utility>

#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// How often a step that is too large is halved.
constexpr int max_halvings = 4;

// The result of a function at a value; nothing where the family has no such member, or that no such saddle. Who then
// works the value out from nothing learns why.
template <typename Function>
auto found_by(const Function& function) -> std::optional<decltype(function())> {
  try {
    return function();
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<KnownManifolds> manifolds_at(const Family& family, double value, const KnownManifolds& from,
                                           double step) {
  return found_by([&] {
    const FamilyMember member = family(value);
    return continued_manifolds(*member.map, member.connection, from, step);
  });
}

std::optional<KnownManifolds> followed_manifolds(const Family& family, double from, const KnownManifolds& known,
                                                 double to, int halvings) {
  std::optional<KnownManifolds> there = manifolds_at(family, to, known, to - from);
  if (there || halvings == 0) return there;
  const double middle = 0.5 * (from + to);
  const std::optional<KnownManifolds> halfway = followed_manifolds(family, from, known, middle, halvings - 1);
  return halfway ? followed_manifolds(family, middle, *halfway, to, halvings - 1) : std::nullopt;
}

// The way from one value to another, whose manifolds are known at both ends, and about known in between: there the
// orbits of the pips only have to show which one is which.
class Way {
 public:
  Way(const Family& family, double from, double to, const KnownManifolds& last)
      : family_(family), from_(from), to_(to), last_(last) {}

  [[nodiscard]] std::optional<KnownTurnstile> followed(const KnownTurnstile& known, double begin, double end,
                                                       int halvings) const {
    std::optional<KnownTurnstile> there = continued(known, begin, end);
    if (there || halvings == 0) return there;
    const double middle = 0.5 * (begin + end);
    const std::optional<KnownTurnstile> halfway = followed(known, begin, middle, halvings - 1);
    return halfway ? followed(*halfway, middle, end, halvings - 1) : std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<KnownTurnstile> continued(const KnownTurnstile& known, double begin, double end) const {
    const double step = to_ - from_;
    return found_by([&] {
             const FamilyMember member = family_(end == 1 ? to_ : from_ + end * step);
             const double part = (end - begin) * step;
             KnownManifolds there = end == 1 ? last_
                                    : are_known_between(last_)
                                        ? manifolds_between(last_, (end - 1) * step)
                                        : continued_manifolds(*member.map, member.connection, known.on, part);
             return continued_turnstile(*member.map, std::move(there), known, part);
           })
        .value_or(std::nullopt);
  }

  const Family& family_;
  double from_, to_;
  const KnownManifolds& last_;
};

}  // namespace

std::optional<KnownTurnstile> continued_to(const Family& family, double value, const KnownTurnstile& from,
                                           double step) {
  return found_by([&] {
           const FamilyMember member = family(value);
           return continued_turnstile(*member.map, continued_manifolds(*member.map, member.connection, from.on, step),
                                      from, step);
         })
      .value_or(std::nullopt);
}

Followed followed_to(const Family& family, double value, double from_value, const KnownTurnstile& from) {
  Followed result{followed_manifolds(family, from_value, from.on, value, max_halvings), {}};
  if (result.manifolds)
    result.turnstile = Way(family, from_value, value, *result.manifolds).followed(from, 0, 1, max_halvings);
  return result;
}

}  // namespace lober::detail
