#include "engine/batch/manifest/plan.hpp"

#include <algorithm>
#include <map>

#include "engine/base/input_guard.hpp"
#include "engine/batch/manifest/curve_set.hpp"

namespace lober::detail {
namespace {

class Planner {
 public:
  explicit Planner(const Manifest& manifest) : manifest_(manifest) {}

  Plan plan() {
    for (const ManifestGroup& group : manifest_.groups) add(group);
    return std::move(plan_);
  }

 private:
  using Pairs = std::vector<std::pair<CurveId, CurveId>>;

  void add(const ManifestGroup& group) {
    const Pairs pairs = pairs_of(group);
    if (pairs.empty()) {
      const LocatedText& text = group.pairs == PairKind::list ? LocatedText{"", 1, "pairs"} : group.curves.front();
      manifest_.fail(text.line, text.key, "this gives no pair of curves" + why_no_pair(group));
    }
    plan_.jobs.reserve(plan_.jobs.size() + group.options.size() * pairs.size());
    for (const Options& options : group.options) {
      const auto number = static_cast<std::uint32_t>(plan_.groups.size());
      plan_.groups.push_back({group.name, group.operation, options, nullptr, group.periods});
      for (const auto& [first, second] : pairs) plan_.jobs.push_back({number, first, second});
    }
  }

  Pairs pairs_of(const ManifestGroup& group) {
    Pairs pairs;
    const std::vector<CurveId> curves = numbers_of(group.curves, group);
    switch (group.pairs) {
      case PairKind::none:
        pairs.emplace_back(no_curve, no_curve);
        break;
      case PairKind::all:
        pairs.reserve(curves.size() * (curves.size() - 1) / 2);  // none where there are none
        for (std::size_t i = 0; i < curves.size(); ++i) {
          for (std::size_t k = i + 1; k < curves.size(); ++k) pairs.emplace_back(curves[i], curves[k]);
        }
        break;
      case PairKind::lag:
        for (std::size_t i = 0; i + group.lag < curves.size(); ++i)
          pairs.emplace_back(curves[i], curves[i + group.lag]);
        break;
      case PairKind::product: {
        const std::vector<CurveId> others = numbers_of(group.with, group);
        for (const CurveId curve : curves) {
          for (const CurveId other : others) {
            if (curve != other) pairs.emplace_back(curve, other);
          }
        }
        break;
      }
      case PairKind::single:
        for (const CurveId curve : curves) pairs.emplace_back(curve, no_curve);
        break;
      case PairKind::list:
        for (const auto& [first, second] : group.list) {
          pairs.emplace_back(single(first, group), single(second, group));
        }
        break;
    }
    return pairs;
  }

  // The end of a message about curves of which there are too few: the reason, if it is not that there is only one.
  std::string why_no_pair(const ManifestGroup& group) const {
    std::vector<std::string> names, twice;
    for (const LocatedText& pattern : group.curves) {
      for (const CurveSource& source : resolve(manifest_, {pattern})) {
        std::vector<std::string>& list =
            std::find(names.begin(), names.end(), source.name()) == names.end() ? names : twice;
        list.push_back(source.name());
      }
    }
    if (group.pairs == PairKind::lag && names.size() > 1) {
      return ": there are " + std::to_string(names.size()) + ", and lag = " + std::to_string(group.lag) +
             " has to be less than that";
    }
    if (!twice.empty()) return ": " + twice.front() + " is given twice, and counts once";
    if (group.pairs == PairKind::product) return ": with has no other curve than " + names.front();
    return {};
  }

  CurveId single(const LocatedText& name, const ManifestGroup& group) {
    const std::vector<CurveId> found = numbers_of({name}, group);
    if (found.size() != 1) manifest_.fail(name.line, name.key, name.text + " is more than one curve");
    return found[0];
  }

  std::vector<CurveId> numbers_of(const std::vector<LocatedText>& patterns, const ManifestGroup& group) {
    std::vector<CurveId> ids;
    for (CurveSource& source : resolve(manifest_, patterns)) {
      source.closed = group.closed && !source.file.empty();
      if (!source.file.empty()) source.periods = group.periods;
      const auto [at, is_new] = curves_.try_emplace(source.input_name(), static_cast<CurveId>(plan_.curves.size()));
      ids.push_back(at->second);
      if (!is_new) continue;
      // From now on no output of the program replaces it, whichever job reads it when, if any does.
      if (!source.file.empty()) note_input(located(manifest_.path, source.file));
      plan_.curves.push_back(std::move(source));
    }
    return ids;
  }

  const Manifest& manifest_;
  Plan plan_;
  std::map<std::string, CurveId> curves_;  ///< by the names of inputs
};

}  // namespace

bool Plan::may_write() const {
  return std::any_of(groups.begin(), groups.end(),
                     [](const JobGroup& group) { return static_cast<bool>(group.operation->output); });
}

std::string Plan::output_of(const Job& job) const {
  const JobGroup& group = group_of(job);
  if (!group.operation->output) return {};
  return group.operation->output(group.options, name(job.first), name(job.second));
}

Plan make_plan(const Manifest& manifest) {
  return Planner(manifest).plan();
}

std::vector<std::uint32_t> jobs_of(const Plan& plan, Shard shard) {
  constexpr std::size_t max_shards = 0xffffffff;  // as many as there can be jobs; their product has to fit
  if (shard.number >= shard.of || shard.of > max_shards) {
    throw UsageError("shard " + std::to_string(shard.number) + " of " + std::to_string(shard.of) +
                     " does not exist; count shards from 0, below their number, which is at most " +
                     std::to_string(max_shards));
  }
  std::vector<std::uint32_t> chosen;
  for (std::size_t begin = 0; begin < plan.jobs.size();) {
    std::size_t end = begin;
    while (end < plan.jobs.size() && plan.jobs[end].group == plan.jobs[begin].group) ++end;
    const std::size_t count = end - begin;
    const std::size_t from = begin + count * shard.number / shard.of,
                      to = begin + count * (shard.number + 1) / shard.of;
    for (std::size_t k = from; k < to; ++k) chosen.push_back(static_cast<std::uint32_t>(k));
    begin = end;
  }
  return chosen;
}

}  // namespace lober::detail
