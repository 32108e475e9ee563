#include "engine/batch/queue/curve_cache.hpp"

#include <algorithm>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {
constexpr std::size_t bytes_per_cached_point = sizeof(Point) + 12;  // with the index, the sums and the boxes of arcs
// The sums of short curves have each chord (DiscretisationSums).
constexpr std::size_t short_curve = 2048, more_bytes_of_a_short_one = 24;

std::size_t expected_bytes(const CurveUnit& unit) {
  const bool is_short = unit.points <= short_curve * unit.curves;
  return unit.points * (bytes_per_cached_point + (is_short ? more_bytes_of_a_short_one : 0));
}
}  // namespace

std::vector<CurveId> CurveCache::add(CurveUnit what) {
  const auto number = static_cast<UnitId>(units_.size());
  std::vector<CurveId> ids;
  Unit unit;
  unit.first = static_cast<CurveId>(members_.size());
  unit.bytes = expected_bytes(what);
  for (std::size_t k = 0; k < what.curves; ++k) {
    ids.push_back(static_cast<CurveId>(members_.size()));
    members_.push_back({number, {}, nullptr, {}, 0});
  }
  unit.what = std::move(what);
  units_.push_back(std::move(unit));
  return ids;
}

void CurveCache::require(CurveId id, const Requirements& requirements) {
  Member& member = members_[id];
  Requirements wider = member.requirements;
  wider |= requirements;
  if (wider == member.requirements) return;
  member.requirements = wider;
  Unit& unit = units_[member.unit];
  if (unit.state == State::resident) drop(unit);
}

std::size_t CurveCache::points(CurveId id) const {
  const Member& member = members_[id];
  if (member.points != 0) return member.points;
  const CurveUnit& what = units_[member.unit].what;
  return what.points / std::max<std::size_t>(what.curves, 1);
}

bool CurveCache::free_memory(std::size_t more, bool regardless) {
  if (used_ + more <= budget_) return true;
  std::vector<Unit*> idle;
  std::size_t can_go = 0;
  for (Unit& unit : units_) {
    if (unit.state != State::resident || unit.pins != 0 || unit.what.keep) continue;
    idle.push_back(&unit);
    can_go += unit.bytes;
  }
  if (used_ - can_go + more > budget_ && !regardless) return false;
  std::sort(idle.begin(), idle.end(), [](const Unit* a, const Unit* b) { return a->last_use < b->last_use; });
  for (Unit* const unit : idle) {
    if (used_ + more <= budget_) break;
    drop(*unit);
    ++counts_.evictions;
  }
  return used_ + more <= budget_;
}

void CurveCache::drop(Unit& unit) {
  for (std::size_t k = 0; k < unit.what.curves; ++k) members_[unit.first + k].prepared = nullptr;
  unit.state = State::absent;
  give(unit.bytes);
}

void CurveCache::take(std::size_t bytes) {
  book(static_cast<std::ptrdiff_t>(bytes));
  counts_.peak_bytes = std::max(counts_.peak_bytes, used_);
}

void CurveCache::book(std::ptrdiff_t bytes) {
  used_ += static_cast<std::size_t>(bytes);
  if (kept_ != nullptr) kept_->occupy(bytes);
}

void CurveCache::pin(UnitId number) {
  ++units_[number].pins;
  units_[number].last_use = ++clock_;
}

void CurveCache::begin_loading(UnitId number) {
  Unit& unit = units_[number];
  unit.state = State::loading;
  take(unit.bytes + unit.what.reading_memory);
}

void CurveCache::give_up_loading(UnitId number) {
  Unit& unit = units_[number];
  unit.state = State::absent;
  give(unit.bytes + unit.what.reading_memory);
}

void CurveCache::expect(UnitId number, std::size_t bytes) {
  Unit& unit = units_[number];
  if (unit.state == State::absent) unit.bytes = std::max(unit.bytes, bytes);
}

namespace {

// Calls load(); an error is passed to failed(message), unless the work is to be dropped.
template <typename Load, typename Failed>
void load_or(const Load& load, const Failed& failed) {
  try {
    load();
  } catch (const Cancelled&) {
    throw;
  } catch (const std::bad_alloc&) {
    failed("out of memory");
  } catch (const std::exception& error) {
    failed(error.what());
  }
}

}  // namespace

std::vector<Requirements> CurveCache::requirements_of(const Unit& unit) const {
  std::vector<Requirements> all;
  for (std::size_t k = 0; k < unit.what.curves; ++k) all.push_back(members_[unit.first + k].requirements);
  return all;
}

std::shared_ptr<CurveCache::Loaded> CurveCache::read(UnitId number, const Loading& loading) const {
  const Unit& unit = units_[number];
  // A kept curve has its digest.
  if (kept_ == nullptr || unit.what.names.curves.empty() || !loading.digests) return read_anew(unit, loading);
  const std::vector<Requirements> requirements = requirements_of(unit);
  if (auto found = kept_->find(unit.what.names, requirements)) {
    auto loaded = std::make_shared<Loaded>();
    loaded->curves = std::move(*found);
    loaded->was_kept = true;
    for (const KeptCurves::Kept& one : loaded->curves) loaded->bytes += one.curve->memory();
    return loaded;
  }
  const std::optional<FileStamp> before = kept_->stamp_of(unit.what.names);
  std::shared_ptr<Loaded> loaded = read_anew(unit, loading);
  // A curve that could not be read, for want of memory for instance, may be readable the next time.
  const bool complete = std::all_of(loaded->curves.begin(), loaded->curves.end(),
                                    [](const auto& one) { return !one.curve->curve().points.empty(); });
  if (before && complete) kept_->keep(unit.what.names, requirements, *before, loaded->curves);
  return loaded;
}

std::shared_ptr<CurveCache::Loaded> CurveCache::read_anew(const Unit& unit, const Loading& loading) const {
  auto loaded = std::make_shared<Loaded>();
  const Stopwatch read_watch;
  std::vector<LoadedCurve> curves;
  load_or([&] { curves = unit.what.load(loading); },
          [&](const char* message) {
            curves.assign(unit.what.curves, LoadedCurve{nullptr, {}, message});
          });
  loaded->read_seconds = read_watch.seconds();
  const Stopwatch prepare_watch;
  loaded->curves.resize(curves.size());
  for_each_block(curves.size(), 1, [&](std::size_t k, std::size_t) {
    LoadedCurve& curve = curves[k];
    std::shared_ptr<const PreparedCurve>& made = loaded->curves[k].curve;
    const std::string name = curve.curve ? curve.curve->name : "";
    load_or(
        [&] {
          made = curve.error.empty()
                     ? std::make_shared<const PreparedCurve>(
                           std::move(curve.curve), members_[unit.first + k].requirements, std::move(curve.warning))
                     : std::make_shared<const PreparedCurve>(std::move(curve.error));
        },
        [&](const char* message) { made = std::make_shared<const PreparedCurve>(name + ": " + message); });
  });
  for (std::size_t k = 0; k < curves.size(); ++k) {
    loaded->bytes += loaded->curves[k].curve->memory();
    loaded->curves[k].digest = std::move(curves[k].digest);
  }
  loaded->prepare_seconds = prepare_watch.seconds();
  return loaded;
}

void CurveCache::end_loading(UnitId number, const Loaded& loaded) {
  Unit& unit = units_[number];
  for (std::size_t k = 0; k < unit.what.curves; ++k) {
    Member& member = members_[unit.first + k];
    const auto& [curve, digest] = loaded.curves[k];
    member.prepared = curve;
    if (unit.reads == 0) member.digest = digest;
    if (member.digest != digest) {
      member.prepared = std::make_shared<const PreparedCurve>("the input changed while it was in use");
    }
    member.points = member.prepared->curve().points.size();
    const bool indexed = member.prepared->error(member.requirements).empty() && member.requirements.index;
    if (indexed && !loaded.was_kept) ++counts_.curves_indexed;
  }
  unit.state = State::resident;
  give(unit.bytes + unit.what.reading_memory);
  unit.bytes = loaded.bytes;
  take(unit.bytes);
  if (!loaded.was_kept) ++counts_.units_read;
  counts_.max_reads = std::max(counts_.max_reads, ++unit.reads);
  counts_.read_seconds += loaded.read_seconds;
  counts_.prepare_seconds += loaded.prepare_seconds;
}

}  // namespace lober::detail
