#include "engine/batch/plan.hpp"

#include <algorithm>
#include <map>

#include "engine/batch/bytes.hpp"
#include "engine/batch/curve_set.hpp"

namespace lober {
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
      const Placed& place = group.pairs == PairKind::list ? Placed{"", 1, "pairs"} : group.curves.front();
      manifest_.fail(place.line, place.key, "no pair comes of this");
    }
    for (const Options& options : group.options) {
      const std::span<const OptionSetting> settings = options.settings();
      PlannedGroup planned{group.name, group.operation->name, {settings.begin(), settings.end()}};
      const auto number = static_cast<std::uint32_t>(plan_.groups.size());
      plan_.groups.push_back(std::move(planned));
      for (const auto& [first, second] : pairs) plan_.jobs.push_back({number, first, second});
    }
  }

  Pairs pairs_of(const ManifestGroup& group) {
    Pairs pairs;
    const std::vector<CurveId> curves = numbers_of(group.curves, group.closed);
    switch (group.pairs) {
      case PairKind::none:
        pairs.emplace_back(no_curve, no_curve);
        break;
      case PairKind::all:
        for (std::size_t i = 0; i < curves.size(); ++i) {
          for (std::size_t k = i + 1; k < curves.size(); ++k) pairs.emplace_back(curves[i], curves[k]);
        }
        break;
      case PairKind::lag:
        for (std::size_t i = 0; i + group.lag < curves.size(); ++i)
          pairs.emplace_back(curves[i], curves[i + group.lag]);
        break;
      case PairKind::product: {
        const std::vector<CurveId> others = numbers_of(group.with, group.closed);
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
          pairs.emplace_back(single(first, group.closed), single(second, group.closed));
        }
        break;
    }
    return pairs;
  }

  CurveId single(const Placed& name, bool closed) {
    const std::vector<CurveId> found = numbers_of({name}, closed);
    if (found.size() != 1) manifest_.fail(name.line, name.key, name.text + " is more than one curve");
    return found[0];
  }

  std::vector<CurveId> numbers_of(const std::vector<Placed>& patterns, bool closed) {
    std::vector<CurveId> ids;
    for (const CurvePlace& place : resolve(manifest_, patterns)) {
      const bool manifold = place.file.empty();
      const bool closes = closed && !manifold;
      const auto [at, is_new] = curves_.try_emplace({place.name(), closes}, static_cast<CurveId>(plan_.curves.size()));
      ids.push_back(at->second);
      if (!is_new) continue;
      const std::string made = place.recipe != nullptr ? place.recipe->name() : "";
      const auto [source, new_source] =
          sources_.try_emplace({place.file, made}, static_cast<std::uint32_t>(plan_.sources.size()));
      if (new_source) {
        plan_.sources.push_back({place.file, {}});
        if (place.recipe != nullptr) plan_.sources.back().recipe = *place.recipe;
      }
      plan_.curves.push_back(
          {source->second, place.zone ? static_cast<std::int64_t>(*place.zone) : -1, closes, place.name()});
    }
    return ids;
  }

  const Manifest& manifest_;
  Plan plan_;
  std::map<std::pair<std::string, bool>, CurveId> curves_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> sources_;  ///< by file and recipe
};

void put(ByteWriter& writer, const OptionValue& value) {
  writer.put(static_cast<std::uint8_t>(value.index()));
  if (const auto* flag = std::get_if<bool>(&value)) {
    writer.put_flag(*flag);
  } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    writer.put(*whole);
  } else if (const auto* real = std::get_if<double>(&value)) {
    writer.put(*real);
  } else {
    writer.put_text(std::get<std::string>(value));
  }
}

OptionValue get_value(ByteReader& reader) {
  switch (reader.get_below<std::uint8_t>(std::variant_size_v<OptionValue>)) {
    case 0:
      return reader.get_flag();
    case 1:
      return reader.get<std::int64_t>();
    case 2:
      return reader.get<double>();
    default:
      return reader.get_text();
  }
}

}  // namespace

std::string PlannedGroup::to_string() const {
  return lober::to_string(options);
}

std::string Plan::encoded() const {
  ByteWriter writer;
  writer.put(std::uint64_t{groups.size()});
  for (const PlannedGroup& group : groups) {
    writer.put_text(group.name);
    writer.put_text(group.operation);
    writer.put(std::uint64_t{group.options.size()});
    for (const auto& [key, value] : group.options) {
      writer.put_text(key);
      put(writer, value);
    }
  }
  writer.put(std::uint64_t{sources.size()});
  for (const PlannedSource& source : sources) {
    writer.put_text(source.file);
    writer.put_flag(source.recipe.has_value());
    if (source.recipe) source.recipe->put(writer);
  }
  writer.put(std::uint64_t{curves.size()});
  for (const PlannedCurve& curve : curves) {
    writer.put(curve.source);
    writer.put(curve.zone);
    writer.put_flag(curve.closed);
    writer.put_text(curve.name);
  }
  writer.put_all(jobs);
  return writer.take();
}

Plan Plan::decoded(std::string_view bytes) {
  ByteReader reader(bytes);
  Plan plan;
  plan.groups.resize(reader.get_count());
  for (PlannedGroup& group : plan.groups) {
    group.name = reader.get_text();
    group.operation = reader.get_text();
    group.options.resize(reader.get_count());
    for (auto& [key, value] : group.options) {
      key = reader.get_text();
      value = get_value(reader);
    }
  }
  plan.sources.resize(reader.get_count());
  for (PlannedSource& source : plan.sources) {
    source.file = reader.get_text();
    if (reader.get_flag()) source.recipe = CurveRecipe::get(reader);
  }
  plan.curves.resize(reader.get_count());
  for (PlannedCurve& curve : plan.curves) {
    curve.source = reader.get_below(static_cast<std::uint32_t>(plan.sources.size()));
    curve.zone = reader.get<std::int64_t>();
    curve.closed = reader.get_flag();
    curve.name = reader.get_text();
  }
  plan.jobs = reader.get_all<PlannedJob>();
  const auto is_curve = [&](CurveId id) { return id == no_curve || id < plan.curves.size(); };
  for (const PlannedJob& job : plan.jobs) {
    if (job.group >= plan.groups.size() || !is_curve(job.first) || !is_curve(job.second)) {
      throw DataError("a job of the stored plan names what the plan does not have");
    }
  }
  if (!reader.at_end()) throw DataError("the stored plan goes on behind its end");
  return plan;
}

Plan make_plan(const Manifest& manifest) {
  return Planner(manifest).plan();
}

const Operation& operation_of(const PlannedGroup& group) {
  const Operation* const operation = find_operation(group.operation);
  if (operation == nullptr) throw UsageError("there is no operation \"" + group.operation + "\" in this version");
  return *operation;
}

Options options_of(const PlannedGroup& group) {
  return {operation_of(group).options, group.options};
}

std::vector<std::uint32_t> jobs_of(const Plan& plan, Shard shard) {
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

}  // namespace lober
