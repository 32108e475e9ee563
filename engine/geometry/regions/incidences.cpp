#include "engine/geometry/regions/incidences.hpp"

#include <algorithm>
#include <memory>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/crossings/common_runs.hpp"
#include "engine/geometry/crossings/pair_contacts.hpp"
#include "engine/geometry/crossings/sort_by_segment.hpp"
#include "kernels/pair_filter.hpp"

namespace lober::detail {
namespace {

// The segments that have a point in common with others of their own curve, neighbours apart.
class MetSegments {
 public:
  MetSegments(const EdgeChains& edge_chains, const Incidences& with_themselves,
              const std::vector<SegmentPair>& together) {
    if (with_themselves.list.empty() && with_themselves.spikes.empty() && together.empty()) return;
    met_.resize(edge_chains.segments());
    for (const Incidence& incidence : with_themselves.list) met_[incidence.first] = met_[incidence.second] = true;
    for (const auto& [first, second] : together) met_[first] = met_[second] = true;
    for (const std::uint32_t spike : with_themselves.spikes) met_[spike] = met_[edge_chains.previous(spike)] = true;
  }

  [[nodiscard]] bool has(std::uint32_t segment) const { return !met_.empty() && met_[segment]; }

 private:
  std::vector<bool> met_;  // empty: none
};

constexpr std::int8_t right_to_left = 1, left_to_right = -1;

class IncidenceFinder final : public PairConsumer {
 public:
  // `first`, `second`: the two curves, which may be one and the same. Runs of common vertices are followed if it is
  // told which segments meet others of their own curve.
  IncidenceFinder(const EdgeChains& edge_chains, int first, int second, std::array<std::uint32_t, 2> extreme,
                  double scale, const MetSegments* met = nullptr)
      : edge_chains_(edge_chains),
        c1_(edge_chains.curve(first)),
        c2_(edge_chains.curve(second)),
        begin1_(edge_chains.first_of(first)),
        begin2_(edge_chains.first_of(second)),
        source1_{c1_.points.data(), static_cast<std::uint32_t>(c1_.points.size() - 1)},
        source2_{c2_.points.data(), static_cast<std::uint32_t>(c2_.points.size() - 1)},
        extreme_(extreme),
        scale_(scale),
        met_(met),
        blocks_((c1_.segments() + block_segments - 1) / block_segments) {}

  std::uint32_t consume(std::uint32_t number, std::span<const SegmentPair> pairs) override {
    std::unique_ptr<Block>& block = blocks_[number];
    if (!block) block = std::make_unique<Block>();
    block->verdicts.resize(std::max(pairs.size(), block->verdicts.size()));
    filter_pairs(source1_, source2_, pairs.data(), pairs.size(), block->verdicts.data());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = pairs[k];
      const PairVerdict verdict = block->verdicts[k];
      if (verdict == PairVerdict::apart) continue;
      if (block->runs.covers(i)) continue;
      if (verdict == PairVerdict::uncertain) {
        classify(i, j, number, *block);
      } else {
        block->list.push_back(
            {i, j, verdict == PairVerdict::crosses_to_left ? right_to_left : left_to_right, false, false});
      }
    }
    return block->runs.covered_end();
  }

  void finish(std::uint32_t number) override {
    if (!blocks_[number]) return;
    blocks_[number]->verdicts = {};
    drop_inside_runs(*blocks_[number]);
    sort_by_segment(blocks_[number]->list, number * block_segments, [](const Incidence& found) { return found.first; });
  }

  // Appends the findings; returns the number of incidences, those inside runs included.
  std::uint64_t append_to(Incidences& all, std::vector<SegmentPair>& together) {
    const std::size_t before = all.list.size(), together_before = together.size();
    std::vector<std::size_t> begin(blocks_.size() + 1, before);
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      begin[k + 1] = begin[k] + (blocks_[k] ? blocks_[k]->list.size() : 0);
    }
    all.list.resize(begin.back());
    for (Buffer<DD>& parameters : all.parameters) parameters.resize(begin.back());
    for_each_block(blocks_.size(), 1, [&](std::size_t k, std::size_t) {
      if (blocks_[k]) move_to(all, begin[k], *blocks_[k]);
    });
    std::uint64_t inside_runs = 0;
    for (const std::unique_ptr<Block>& block : blocks_) {
      if (!block) continue;
      inside_runs += block->inside_runs;
      all.spikes.insert(all.spikes.end(), block->spikes.begin(), block->spikes.end());
      together.insert(together.end(), block->together.begin(), block->together.end());
      all.counts.predicates += block->predicates;
      all.counts.exact_parameters += block->exact_parameters;
    }
    all.counts.along += inside_runs;
    return all.list.size() - before + together.size() - together_before + inside_runs;
  }

 private:
  struct Block {
    Buffer<PairVerdict> verdicts;
    Buffer<Incidence> list;
    std::vector<std::uint32_t> spikes;
    std::vector<SegmentPair> together;  // first ends in common where both edge chains keep together
    CommonRuns runs;
    std::uint64_t inside_runs = 0;  // vertices, their ends excluded
    PredicateCounts predicates;
    std::uint64_t exact_parameters = 0;
  };

  void classify(std::uint32_t i, std::uint32_t j, std::uint32_t number, Block& block) {
    const auto [a, b] = c1_.segment(i);
    const auto [c, d] = c2_.segment(j);
    PredicateCounts& counts = block.predicates;
    if (a == b || c == d) return;  // repeated vertices carry no segment
    if (a == c) {
      meet_at_vertex(begin1_ + i, begin2_ + j, block);
      if (met_ != nullptr) follow_run(i, j, number, block);
      return;
    }
    // Segments that join end to start, as neighbours do: nothing unless the second folds back on the first.
    if (b == c && (goes_on(a, b, d) || orient2d(a, b, d, counts) != 0)) return;
    if (d == a && (goes_on(c, d, b) || orient2d(c, d, b, counts) != 0)) return;
    const PairContacts found = contacts_of({a, b}, {c, d}, counts);
    if (found.rho != 0) block.list.push_back({i, j, found.rho > 0 ? right_to_left : left_to_right, false, false});
    if (found.start1_on) block.list.push_back({i, j, 0, true, false});
    if (found.start2_on) block.list.push_back({i, j, 0, false, true});
    if (!found.one_line || begin1_ != begin2_) return;
    if (b == c && follows(i, j) && folds(a, b, d, counts)) block.spikes.push_back(begin2_ + j);
    if (d == a && follows(j, i) && folds(c, d, b, counts)) block.spikes.push_back(begin1_ + i);
  }

  // Whether `after` is the next segment along the curve that has a length.
  [[nodiscard]] bool follows(std::uint32_t before, std::uint32_t after) const {
    return edge_chains_.next(begin1_ + before) == begin1_ + after;
  }

  [[nodiscard]] bool is_extreme(std::uint32_t segment) const {
    return segment == extreme_[0] || segment == extreme_[1];
  }

  // Vertex i of C1 is vertex j of C2: follows both as long as they have the same vertices and meet nothing else, inside
  // the block and up to the next extreme vertex.
  void follow_run(std::uint32_t i, std::uint32_t j, std::uint32_t number, Block& block) {
    const std::uint32_t end = std::min((number + 1) * block_segments, static_cast<std::uint32_t>(c1_.points.size()));
    block.runs.follow(c1_, c2_, i, j, end,
                      [&](std::uint32_t last, std::uint32_t other, std::uint32_t next, std::uint32_t next_other) {
                        if (met_->has(last) || met_->has(begin2_ + other) || met_->has(begin2_ + next_other))
                          return RunStep::not_there;
                        return is_extreme(next) || is_extreme(begin2_ + next_other) ? RunStep::there_at_last
                                                                                    : RunStep::on;
                      });
  }

  // Counts the vertices inside runs, and leaves out what was found there before the run was known.
  static void drop_inside_runs(Block& block) {
    block.runs.merge();
    if (block.runs.runs().empty()) return;
    for (const CommonRun& run : block.runs.runs()) block.inside_runs += run.last - run.first - 1;
    std::erase_if(block.list, [&](const Incidence& incidence) { return block.runs.has_inside(incidence.first); });
    std::erase_if(block.together, [&](const SegmentPair& pair) { return block.runs.has_inside(pair.first); });
    block.runs = {};
  }

  // The first ends of two segments are one point.
  void meet_at_vertex(std::uint32_t first, std::uint32_t second, Block& block) {
    if (!is_extreme(first) && !is_extreme(second) && keep_together(first, second, block.predicates)) {
      block.together.push_back({first, second});
    } else {
      block.list.push_back({first - begin1_, second - begin2_, 0, true, true});
    }
  }

  // Whether both edge chains come from one vertex and go on to one vertex, in one direction or in opposite ones, and do
  // not fold back here.
  [[nodiscard]] bool keep_together(std::uint32_t first, std::uint32_t second, PredicateCounts& counts) const {
    const auto [joint, after1] = edge_chains_.segment(first);
    const Point after2 = edge_chains_.segment(second).b;
    const Point before1 = edge_chains_.start(edge_chains_.previous(first));
    const Point before2 = edge_chains_.start(edge_chains_.previous(second));
    if (!(before1 == before2 && after1 == after2) && !(before1 == after2 && after1 == before2)) return false;
    return goes_on(before1, joint, after1) || orient2d(before1, joint, after1, counts) != 0 ||
           !folds(before1, joint, after1, counts);
  }

  // Whether x or y grows, or falls, all the way from `before` to `joint` to `after`: seen without any arithmetic.
  static bool goes_on(Point before, Point joint, Point after) {
    return (before.x < joint.x && joint.x < after.x) || (before.x > joint.x && joint.x > after.x) ||
           (before.y < joint.y && joint.y < after.y) || (before.y > joint.y && joint.y > after.y);
  }

  // Whether the way from `before` to `joint` to `after`, three points of one line, turns back at the joint.
  static bool folds(Point before, Point joint, Point after, PredicateCounts& counts) {
    return on_segment(joint, after, before, counts) || on_segment(joint, before, after, counts);
  }

  struct Parameters {
    DD t1, t2;
  };

  // Moves the incidences of a block to where they stay, from `begin` on, gives their segments their numbers and
  // computes their parameters.
  void move_to(Incidences& all, std::size_t begin, Block& block) const {
    ParameterBatch<Parameters> batch(scale_);
    Buffer<Parameters> computed(block.list.size());
    for (std::size_t k = 0; k < computed.size(); ++k) {
      const Incidence& found = block.list[k];
      batch.add(c1_.segment(found.first), c2_.segment(found.second), found.starts1, found.starts2, computed[k]);
      all.list[begin + k] = found;
      all.list[begin + k].first += begin1_;
      all.list[begin + k].second += begin2_;
    }
    batch.flush();
    for (std::size_t k = 0; k < computed.size(); ++k) {
      all.parameters[0][begin + k] = computed[k].t1;
      all.parameters[1][begin + k] = computed[k].t2;
    }
    block.exact_parameters += batch.exact();
    block.list = {};
  }

  const EdgeChains& edge_chains_;
  CurveView c1_, c2_;
  std::uint32_t begin1_, begin2_;  // what EdgeChains call the first segments of the two curves
  SegmentSource source1_, source2_;
  std::array<std::uint32_t, 2> extreme_;
  double scale_;
  const MetSegments* met_;
  std::vector<std::unique_ptr<Block>> blocks_;
};

// The number of vertices where edge chains keep together and no node is, those inside runs left out.
std::uint64_t vertices_along(const EdgeChains& edge_chains, const Incidences& found,
                             const std::vector<SegmentPair>& together) {
  if (together.empty()) return 0;
  std::vector<bool> at_node(edge_chains.segments()), passing(at_node.size()), repeated(at_node.size());
  for (const Incidence& incidence : found.list) {
    if (incidence.starts1) at_node[incidence.first] = true;
    if (incidence.starts2) at_node[incidence.second] = true;
  }
  // Among the edge chains of a vertex each but the lowest is the higher one of some pair.
  std::uint64_t vertices = 0;
  const auto mark = [](std::vector<bool>& marks, std::uint32_t segment) {
    const bool fresh = !marks[segment];
    marks[segment] = true;
    return fresh ? 1U : 0U;
  };
  for (const auto& [first, second] : together) {
    if (at_node[first]) continue;
    vertices += mark(passing, first) + mark(passing, second);
    vertices -= mark(repeated, std::max(first, second));
  }
  return vertices;
}

}  // namespace

Incidences find_incidences(const IndexedCurve& c1, const IndexedCurve* c2, IndexKind kind,
                           std::array<std::uint32_t, 2> extreme) {
  Incidences found;
  const EdgeChains edge_chains = c2 == nullptr ? EdgeChains(c1.view()) : EdgeChains(c1.view(), c2->view());
  const double scale = (c2 == nullptr ? c1.tree().box() : union_of(c1.tree().box(), c2->tree().box())).extent();
  std::vector<SegmentPair> together;
  const auto with_itself = [&](const IndexedCurve& curve, int number) {
    IncidenceFinder finder(edge_chains, number, number, extreme, scale);
    found.counts.search += find_self_pairs(curve, finder);
    return finder.append_to(found, together);
  };
  found.counts.self1 = with_itself(c1, 0);
  found.begin[1] = found.list.size();
  if (c2 != nullptr) {
    found.counts.self2 = with_itself(*c2, 1);
    found.begin[2] = found.list.size();
    const MetSegments met(edge_chains, found, together);
    IncidenceFinder finder(edge_chains, 0, 1, extreme, scale, &met);
    found.counts.search += find_pairs(c1, *c2, kind, finder);
    found.counts.mutual = finder.append_to(found, together);
  }
  if (c2 == nullptr) found.begin[2] = found.list.size();
  found.begin[3] = found.list.size();
  found.counts.along += vertices_along(edge_chains, found, together);
  return found;
}

}  // namespace lober::detail
