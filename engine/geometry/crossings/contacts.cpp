#include "engine/geometry/crossings/contacts.hpp"

#include <algorithm>
#include <atomic>
#include <memory>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/geometry/crossings/common_runs.hpp"
#include "engine/geometry/crossings/pair_contacts.hpp"
#include "engine/geometry/crossings/sort_by_segment.hpp"
#include "engine/geometry/curve/countable.hpp"
#include "engine/geometry/curve/point_along.hpp"
#include "kernels/pair_filter.hpp"

namespace lober::detail {
namespace {

// A contact before its parameters are known.
struct Hit : ContactKind {
  std::uint32_t segment1, segment2;
};
Hit crossing(std::uint32_t i, std::uint32_t j, int rho) {
  return {{static_cast<std::int8_t>(rho), 0, false, false}, i, j};
}
Hit at_vertex(std::uint32_t i, std::uint32_t j, bool of1, bool of2) {
  return {{0, 0, of1, of2}, i, j};
}

struct Block {
  Buffer<PairVerdict> verdicts;
  Buffer<Hit> hits;
  CommonRuns runs;
  ContactCounts counts;
};

class ContactFinder final : public PairConsumer {
 public:
  ContactFinder(const CurveView& c1, const CurveView& c2, double scale)
      : c1_(c1),
        c2_(c2),
        source1_{c1.points.data(), static_cast<std::uint32_t>(c1.points.size() - 1)},
        source2_{c2.points.data(), static_cast<std::uint32_t>(c2.points.size() - 1)},
        scale_(scale),
        blocks_((c1.segments() + block_segments - 1) / block_segments) {}

  std::uint32_t consume(std::uint32_t number, std::span<const SegmentPair> pairs) override {
    std::unique_ptr<Block>& block = blocks_[number];
    if (!block) block = std::make_unique<Block>();
    const std::uint32_t end = std::min((number + 1) * block_segments, static_cast<std::uint32_t>(c1_.segments()));
    block->verdicts.resize(std::max(pairs.size(), block->verdicts.size()));
    filter_pairs(source1_, source2_, pairs.data(), pairs.size(), block->verdicts.data());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = pairs[k];
      const PairVerdict verdict = block->verdicts[k];
      if (verdict == PairVerdict::apart) continue;
      if (block->runs.covers(i)) continue;
      if (verdict == PairVerdict::uncertain) {
        classify(i, j, end, *block);
      } else {
        block->hits.push_back(crossing(i, j, verdict == PairVerdict::crosses_to_left ? 1 : -1));
      }
    }
    return block->runs.covered_end();
  }

  void finish(std::uint32_t number) override {
    if (!blocks_[number]) return;
    Block& block = *blocks_[number];
    drop_inside_runs(block);
    sort_by_segment(block.hits, number * block_segments, [](const Hit& hit) { return hit.segment1; });
    block.verdicts = {};
  }

  // Turns the hits of all blocks into contacts, in order along C1.
  Contacts gather() {
    Contacts result;
    std::vector<std::size_t> begin(blocks_.size() + 1, 0);
    for (std::size_t k = 0; k < blocks_.size(); ++k)
      begin[k + 1] = begin[k] + (blocks_[k] ? blocks_[k]->hits.size() : 0);
    require_countable(begin.back(), "points where the curves meet");
    result.list = ContactList(begin.back());
    std::atomic<bool> all_proper{true};
    for_each_block(blocks_.size(), 1, [&](std::size_t k, std::size_t) {
      if (!blocks_[k]) return;
      Block& block = *blocks_[k];
      Buffer<Contact> contacts(block.hits.size());
      if (!compute_parameters(block, contacts)) all_proper = false;
      order_on_segments(contacts, block);
      for (std::size_t m = 0; m < contacts.size(); ++m) result.list.set(begin[k] + m, contacts[m]);
      block.hits = {};
    });
    result.all_proper = all_proper;
    for (const std::unique_ptr<Block>& block : blocks_) {
      if (!block) continue;
      result.counts.predicates += block->counts.predicates;
      result.counts.exact_parameters += block->counts.exact_parameters;
      result.counts.exact_orders += block->counts.exact_orders;
      result.counts.comparisons += block->counts.comparisons;
      result.counts.shared_vertices += block->counts.shared_vertices;
    }
    return result;
  }

 private:
  void classify(std::uint32_t i, std::uint32_t j, std::uint32_t block_end, Block& block) {
    const PairContacts found = contacts_of(c1_.segment(i), c2_.segment(j), block.counts.predicates);
    if (found.rho != 0) block.hits.push_back(crossing(i, j, found.rho));
    if (found.coincide) {
      block.hits.push_back(at_vertex(i, j, true, true));
      if (const auto run = block.runs.follow(c1_, c2_, i, j, block_end, EveryStep{})) {
        block.hits.back().run = static_cast<std::int8_t>(run->direction);
      }
    }
    if (found.start1_on) block.hits.push_back(at_vertex(i, j, true, false));
    if (found.start2_on) block.hits.push_back(at_vertex(i, j, false, true));
  }

  // Contacts inside a run that were found before the run was known.
  static void drop_inside_runs(Block& block) {
    block.runs.merge();
    if (block.runs.runs().empty()) return;
    for (const CommonRun& run : block.runs.runs()) block.counts.shared_vertices += run.last - run.first;
    std::erase_if(block.hits, [&](const Hit& hit) { return block.runs.has_inside(hit.segment1); });
  }

  // Computes the parameters of all hits of the block. Returns whether all are proper crossings.
  bool compute_parameters(Block& block, std::span<Contact> contacts) {
    ParameterBatch<Contact> batch(scale_);
    bool all_proper = true;
    for (std::uint32_t k = 0; k < block.hits.size(); ++k) {
      const Hit& hit = block.hits[k];
      contacts[k] = {hit.kind(), hit.segment1, hit.segment2, {}, {}};
      batch.add(c1_.segment(hit.segment1), c2_.segment(hit.segment2), hit.vertex1, hit.vertex2, contacts[k]);
      all_proper = all_proper && hit.proper();
    }
    batch.flush();
    block.counts.exact_parameters += batch.exact();
    return all_proper;
  }

  // Brings the contacts of each segment of C1 into their order along it. Nearly always there are a few and they come in
  // order or in the opposite one; where there are more, insertion would cost the square of their number.
  void order_on_segments(std::span<Contact> list, Block& block) {
    constexpr std::size_t few = 16;
    const auto less = [&](const Contact& x, const Contact& y) { return before(x, y, block); };
    for (std::size_t first = 0; first < list.size();) {
      std::size_t last = first + 1;
      while (last < list.size() && list[last].segment1 == list[first].segment1) ++last;
      if (last - first > few) {
        std::stable_sort(&list[first], &list[first] + (last - first), less);
      } else {
        for (std::size_t k = first + 1; k < last; ++k) {
          for (std::size_t m = k; m > first && less(list[m], list[m - 1]); --m) std::swap(list[m], list[m - 1]);
        }
      }
      first = last;
    }
  }

  bool before(const Contact& x, const Contact& y, Block& block) const {
    ++block.counts.comparisons;
    if (x.vertex1 != y.vertex1) return x.vertex1;
    const double difference = (x.t1.hi - y.t1.hi) + (x.t1.lo - y.t1.lo);
    if (difference < -parameter_uncertainty) return true;
    if (difference > parameter_uncertainty) return false;
    ++block.counts.exact_orders;
    const auto [a, b] = c1_.segment(x.segment1);
    return compare_along(a, b, implicit(x), implicit(y)) < 0;
  }

  [[nodiscard]] ImplicitPoint implicit(const Contact& contact) const {
    if (contact.vertex1) {
      const Point vertex = c1_.points[contact.segment1];
      return {vertex, vertex, true};
    }
    const auto [c, d] = c2_.segment(contact.segment2);
    return contact.proper() ? ImplicitPoint{c, d} : ImplicitPoint{c, c, true};
  }

  CurveView c1_, c2_;
  SegmentSource source1_, source2_;
  double scale_;
  std::vector<std::unique_ptr<Block>> blocks_;
};

}  // namespace

Point contact_point(const Contact& contact, const CurveView& c1, const CurveView& c2) {
  if (contact.vertex1) return c1.points[contact.segment1];
  if (contact.vertex2) return c2.points[contact.segment2];
  return point_along(c1.segment(contact.segment1), contact.t1);
}

Contacts find_contacts(const IndexedCurve& c1, const IndexedCurve& c2, IndexKind kind) {
  Stopwatch watch;
  return find_contacts(c1, c2, kind, watch);
}

Contacts find_contacts(const IndexedCurve& c1, const IndexedCurve& c2, IndexKind kind, Stopwatch& watch) {
  const double scale = union_of(c1.tree().box(), c2.tree().box()).extent();
  ContactFinder finder(c1.view(), c2.view(), scale);
  const SearchCounts search = find_pairs(c1, c2, kind, finder);
  Contacts contacts = finder.gather();
  contacts.search_seconds = watch.lap();
  contacts.counts.search = search;
  contacts.order2 = sort_along_second(contacts.list, c1.view(), c2.view(), contacts.counts);
  contacts.order_seconds = watch.lap();
  return contacts;
}

}  // namespace lober::detail
