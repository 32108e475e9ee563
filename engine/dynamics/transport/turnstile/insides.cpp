#include "engine/dynamics/transport/turnstile/insides.hpp"

#include <algorithm>
#include <utility>

#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {
namespace {

// U from pip `first` to pip `last` and back along S, with the corners where the smooth curves cross.
std::vector<Point> loop_between(const Tangle& tangle, std::size_t first, std::size_t last) {
  const Pip &from = tangle.pips[first], &to = tangle.pips[last];
  std::vector<Point> points{from.at};
  points.insert(points.end(), tangle.u().points.begin() + from.u.segment + 1,
                tangle.u().points.begin() + to.u.segment + 1);
  points.push_back(to.at);
  points.insert(points.end(), tangle.s().points.begin() + to.s.segment + 1,
                tangle.s().points.begin() + from.s.segment + 1);
  return points;
}

double curve_error_of(const Barrier& c, int m, const Barrier& d, int n) {
  return std::max(c.error_up_to(c.pip(m)), d.error_up_to(d.pip(n)));
}

}  // namespace

InsidesInCommon::Change InsidesInCommon::change_after(std::span<const Barrier* const> barriers, std::size_t number,
                                                      int images) {
  const Barrier& barrier = *barriers[number];
  const std::size_t here = barrier.pip(0), there = barrier.pip(images);
  const int sign = sign_of(barrier);
  return {number, images, images > 0 ? sign : -sign,
          std::make_shared<std::vector<Point>>(images > 0 ? loop_between(*barrier.tangle, here, there)
                                                          : loop_between(*barrier.tangle, there, here))};
}

// The changes that the pairs ask for, each once.
std::vector<InsidesInCommon::Change> InsidesInCommon::changes_of(std::span<const Barrier* const> barriers,
                                                                 std::span<const Pair> pairs) const {
  std::vector<std::pair<std::size_t, int>> wanted;
  for (const Pair& pair : pairs) {
    if (pair.m != 0) wanted.emplace_back(pair.c, pair.m);
    if (pair.n != 0) wanted.emplace_back(pair.d, pair.n);
  }
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  std::vector<Change> changes(wanted.size());
  for_each_block(wanted.size(), 1, [&](std::size_t k, std::size_t) {
    changes[k] = change_after(barriers, wanted[k].first, wanted[k].second);
    for (const Change& before : changes_) {
      if (before.barrier == changes[k].barrier && before.images == changes[k].images &&
          *before.loop == *changes[k].loop) {
        changes[k].loop = before.loop;
      }
    }
  });
  return changes;
}

// Manifolds that are grown on may be refined anywhere.
void InsidesInCommon::forget_what_changed(std::span<const Barrier* const> barriers) {
  outlines_.resize(barriers.size());
  for (std::size_t c = 0; c < barriers.size(); ++c) {
    std::vector<Point> outline = outline_of(*barriers[c], 0);
    if (outline == outlines_[c]) continue;
    outlines_[c] = std::move(outline);
    std::erase_if(taken_, [&](const Taken& one) { return one.inside == c; });
  }
}

std::vector<Measured> InsidesInCommon::of(std::span<const Barrier* const> barriers, std::span<const Pair> pairs) {
  std::vector<Measured> common(pairs.size());
  if (pairs.empty()) return common;
  if (barriers.front()->lattice == Point{}) {
    for_each_block(pairs.size(), 1, [&](std::size_t k, std::size_t) {
      const Barrier &c = *barriers[pairs[k].c], &d = *barriers[pairs[k].d];
      const int m = pairs[k].m, n = pairs[k].n;
      const Measured both = area_in_common(outline_of(c, m), outline_of(d, n), curve_error_of(c, m, d, n), {});
      common[k] = {both.value, both.error + error_at_corner(c, m) + error_at_corner(d, n)};
    });
    return common;
  }

  forget_what_changed(barriers);
  changes_ = changes_of(barriers, pairs);
  std::vector<Taken> taken;
  std::vector<std::size_t> missing;
  const auto find = [](const std::vector<Taken>& list, const Change& change, std::size_t inside) {
    return std::find_if(list.begin(), list.end(),
                        [&](const Taken& one) { return one.loop == change.loop && one.inside == inside; });
  };
  const auto change_of = [&](std::size_t barrier, int images) -> const Change* {
    const auto at = std::find_if(changes_.begin(), changes_.end(), [&](const Change& change) {
      return change.barrier == barrier && change.images == images;
    });
    return at == changes_.end() ? nullptr : &*at;
  };
  const auto want = [&](const Change* change, std::size_t inside) {
    if (!change || find(taken, *change, inside) != taken.end()) return;
    if (const auto known = find(taken_, *change, inside); known != taken_.end()) {
      taken.push_back(*known);
    } else {
      missing.push_back(taken.size());
      taken.push_back({change->loop, inside, {}});
    }
  };
  for (const Pair& pair : pairs) {
    want(change_of(pair.c, pair.m), pair.d);
    want(change_of(pair.d, pair.n), pair.c);
  }
  loops_taken_ += missing.size();

  std::vector<ProductOnCylinder> of_both(pairs.size());
  for_each_block(missing.size() + pairs.size(), 1, [&](std::size_t k, std::size_t) {
    if (k < missing.size()) {
      Taken& one = taken[missing[k]];
      one.product = product_with_inside(*one.loop, *barriers[one.inside]);
      return;
    }
    const Pair& pair = pairs[k - missing.size()];
    const Change *const w = change_of(pair.c, pair.m), *const v = change_of(pair.d, pair.n);
    if (w && v) of_both[k - missing.size()] = product_on_cylinder(*w->loop, *v->loop, barriers[pair.c]->lattice);
  });
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Pair& pair = pairs[k];
    const double curve_error = curve_error_of(*barriers[pair.c], pair.m, *barriers[pair.d], pair.n);
    const Change *const w = change_of(pair.c, pair.m), *const v = change_of(pair.d, pair.n);
    common[k] = pair.at_rest;
    for (const auto& [barrier, image] : {std::pair(pair.c, pair.m), std::pair(pair.d, pair.n)}) {
      if (image == 0) continue;
      for (const int corner : {0, image}) common[k].error += error_at_corner(*barriers[barrier], corner);
    }
    if (w) common[k] = common[k] + w->sign * find(taken, *w, pair.d)->product.with(curve_error);
    if (v) common[k] = common[k] + v->sign * find(taken, *v, pair.c)->product.with(curve_error);
    if (w && v) common[k] = common[k] + (w->sign * v->sign) * of_both[k].with(curve_error);
  }
  taken_ = std::move(taken);
  return common;
}

}  // namespace lober::detail
