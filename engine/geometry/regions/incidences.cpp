#include "engine/geometry/regions/incidences.hpp"

#include <algorithm>
#include <memory>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/crossings/pair_contacts.hpp"
#include "kernels/pair_filter.hpp"

namespace lober::detail {
namespace {

class IncidenceFinder final : public PairConsumer {
 public:
  // `begin1`, `begin2`: what EdgeChains call the first segment of the two curves, which may be one and the same.
  IncidenceFinder(const CurveView& c1, std::uint32_t begin1, const CurveView& c2, std::uint32_t begin2, double scale)
      : c1_(c1),
        c2_(c2),
        begin1_(begin1),
        begin2_(begin2),
        source1_{c1.points.data(), static_cast<std::uint32_t>(c1.points.size() - 1)},
        source2_{c2.points.data(), static_cast<std::uint32_t>(c2.points.size() - 1)},
        scale_(scale),
        blocks_((c1.segments() + block_segments - 1) / block_segments) {}

  std::uint32_t consume(std::uint32_t number, std::span<const SegmentPair> pairs) override {
    std::unique_ptr<Block>& block = blocks_[number];
    if (!block) block = std::make_unique<Block>();
    block->verdicts.resize(std::max(pairs.size(), block->verdicts.size()));
    filter_pairs(source1_, source2_, pairs.data(), pairs.size(), block->verdicts.data());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = pairs[k];
      const PairVerdict verdict = block->verdicts[k];
      if (verdict == PairVerdict::apart) continue;
      if (verdict == PairVerdict::uncertain) {
        classify(i, j, *block);
      } else {
        block->list.push_back({{}, {}, i, j, false, false});
      }
    }
    return 0;
  }

  void finish(std::uint32_t number) override {
    if (!blocks_[number]) return;
    blocks_[number]->verdicts = {};
    compute_parameters(*blocks_[number]);
  }

  // Appends the findings; returns the number of incidences.
  std::uint64_t append_to(Incidences& all) {
    const std::size_t before = all.list.size();
    std::vector<std::size_t> begin(blocks_.size() + 1, before);
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      begin[k + 1] = begin[k] + (blocks_[k] ? blocks_[k]->list.size() : 0);
    }
    all.list.resize(begin.back());
    for_each_block(blocks_.size(), 1, [&](std::size_t k, std::size_t) {
      if (!blocks_[k]) return;
      std::copy(blocks_[k]->list.begin(), blocks_[k]->list.end(),
                all.list.begin() + static_cast<std::ptrdiff_t>(begin[k]));
      blocks_[k]->list = {};
    });
    for (const std::unique_ptr<Block>& block : blocks_) {
      if (!block) continue;
      all.spikes.insert(all.spikes.end(), block->spikes.begin(), block->spikes.end());
      all.counts.predicates += block->predicates;
      all.counts.exact_parameters += block->exact_parameters;
    }
    return all.list.size() - before;
  }

 private:
  struct Block {
    Buffer<PairVerdict> verdicts;
    Buffer<Incidence> list;
    std::vector<std::uint32_t> spikes;
    PredicateCounts predicates;
    std::uint64_t exact_parameters = 0;
  };

  void classify(std::uint32_t i, std::uint32_t j, Block& block) {
    const auto [a, b] = c1_.segment(i);
    const auto [c, d] = c2_.segment(j);
    PredicateCounts& counts = block.predicates;
    if (a == b || c == d) return;  // repeated vertices carry no segment
    // Segments that join end to start, as neighbours do: nothing unless they lie on one line.
    if (b == c && orient2d(a, b, d, counts) != 0) return;
    if (d == a && orient2d(c, d, b, counts) != 0) return;
    const PairContacts found = contacts_of({a, b}, {c, d}, counts);
    if (found.rho != 0) block.list.push_back({{}, {}, i, j, false, false});
    if (found.coincide) block.list.push_back({{}, {}, i, j, true, true});
    if (found.start1_on) block.list.push_back({{}, {}, i, j, true, false});
    if (found.start2_on) block.list.push_back({{}, {}, i, j, false, true});
    if (!found.one_line || found.coincide) return;
    if (b == c && folds(a, b, d, counts)) block.spikes.push_back(begin2_ + j);
    if (d == a && folds(c, d, b, counts)) block.spikes.push_back(begin1_ + i);
  }

  // Whether the way from `before` to `joint` to `after`, three points of one line, turns back at the joint.
  static bool folds(Point before, Point joint, Point after, PredicateCounts& counts) {
    return on_segment(joint, after, before, counts) || on_segment(joint, before, after, counts);
  }

  // Computes the parameters of a block and gives the segments their numbers.
  void compute_parameters(Block& block) {
    ParameterBatch<Incidence> batch(scale_);
    for (Incidence& incidence : block.list) {
      batch.add(c1_.segment(incidence.first), c2_.segment(incidence.second), incidence.starts1, incidence.starts2,
                incidence);
      incidence.first += begin1_;
      incidence.second += begin2_;
    }
    batch.flush();
    block.exact_parameters += batch.exact();
  }

  CurveView c1_, c2_;
  std::uint32_t begin1_, begin2_;
  SegmentSource source1_, source2_;
  double scale_;
  std::vector<std::unique_ptr<Block>> blocks_;
};

}  // namespace

Incidences find_incidences(const IndexedCurve& c1, const IndexedCurve* c2, IndexKind kind) {
  Incidences found;
  const double scale = (c2 == nullptr ? c1.tree().box() : union_of(c1.tree().box(), c2->tree().box())).extent();
  const auto begin2 = static_cast<std::uint32_t>(c1.segments());
  const auto with_itself = [&](const IndexedCurve& curve, std::uint32_t begin) {
    IncidenceFinder finder(curve.view(), begin, curve.view(), begin, scale);
    found.counts.search += find_self_pairs(curve, finder);
    return finder.append_to(found);
  };
  found.counts.self1 = with_itself(c1, 0);
  if (c2 == nullptr) return found;
  found.counts.self2 = with_itself(*c2, begin2);
  IncidenceFinder finder(c1.view(), 0, c2->view(), begin2, scale);
  found.counts.search += find_pairs(c1, *c2, kind, finder);
  found.counts.mutual = finder.append_to(found);
  return found;
}

}  // namespace lober::detail
