// The curves of a queue, in memory as long as the budget allows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/batch/operations/allowance.hpp"
#include "engine/batch/operations/job.hpp"
#include "engine/batch/operations/prepared_curve.hpp"
#include "engine/batch/queue/kept_curves.hpp"
#include "lober/batch.hpp"

namespace lober::detail {

struct LoadedCurve {
  std::shared_ptr<const Curve> curve;
  std::string digest;        ///< digest of the content; may be empty when none was asked for
  std::string error;         ///< why there is no such curve; empty if there is
  std::string warning = {};  ///< why its results may not mean what a user thinks; nearly always empty
};

/// The way in which a unit is to be loaded.
struct Loading {
  bool digests;  ///< hash the curves that are read
  const Allowance& allowance;
};

/// Curves that are read at once and leave memory at once: a file with those of its zones that jobs use, or one curve
/// that comes from elsewhere.
struct CurveUnit {
  std::size_t curves = 1;
  std::size_t points = 0;          ///< an estimate for all of them together, before they are read
  std::size_t reading_memory = 0;  ///< bytes needed besides while reading
  bool keep = false;               ///< cannot be read again
  KeptNames names = {};            ///< for KeptCurves, if there is one
  /// Returns that number of curves, in order; throws a std::exception when nothing can be read. The same
  /// content every time.
  std::function<std::vector<LoadedCurve>(const Loading&)> load;
};

/// Keeps the books. Not safe for several threads: the queue holds its lock for every call but `read`.
class CurveCache {
 public:
  using UnitId = std::uint32_t;
  enum class State : std::uint8_t { absent, loading, resident };

  /// `kept`, which may be null and has to outlive the cache, has curves of earlier caches and gets those of this one.
  explicit CurveCache(std::size_t budget, KeptCurves* kept = nullptr) : budget_(budget), kept_(kept) {}
  CurveCache(const CurveCache&) = delete;
  CurveCache& operator=(const CurveCache&) = delete;
  ~CurveCache() { book(-static_cast<std::ptrdiff_t>(used_)); }

  std::vector<CurveId> add(CurveUnit unit);
  /// Widens what the curve is prepared for. A curve in memory that lacks it is read again.
  void require(CurveId curve, const Requirements& requirements);

  [[nodiscard]] UnitId unit_of(CurveId curve) const { return members_[curve].unit; }
  [[nodiscard]] State state(UnitId unit) const { return units_[unit].state; }
  /// Bytes that the unit takes: as measured when it was in memory, before that estimated.
  [[nodiscard]] std::size_t bytes(UnitId unit) const { return units_[unit].bytes; }
  [[nodiscard]] std::size_t reading_memory(UnitId unit) const { return units_[unit].what.reading_memory; }
  [[nodiscard]] std::size_t points(CurveId curve) const;
  [[nodiscard]] std::size_t budget() const { return budget_; }

  /// Frees `more` bytes by dropping units that no job uses, least recently used first. When even all of them
  /// are not enough: false and nothing was dropped, or all of them were, if `regardless`.
  bool free_memory(std::size_t more, bool regardless = false);
  void take(std::size_t bytes);
  void give(std::size_t bytes) { book(-static_cast<std::ptrdiff_t>(bytes)); }

  void pin(UnitId unit);
  void unpin(UnitId unit) { --units_[unit].pins; }

  /// Announces that the caller is going to `read` the unit, and books the memory.
  void begin_loading(UnitId unit);
  struct Loaded;
  /// Reads and prepares, in parallel inside, or takes kept curves. Needs no lock. A curve that cannot be read or
  /// prepared, be it for want of memory, is one with an error; Cancelled and exceptions other than std::exception are
  /// thrown.
  [[nodiscard]] std::shared_ptr<Loaded> read(UnitId unit, const Loading& loading) const;
  void end_loading(UnitId unit, const Loaded& loaded);
  /// Instead, when `read` has thrown.
  void give_up_loading(UnitId unit);
  /// The number of bytes that the unit will take at least, as far as is known now.
  void expect(UnitId unit, std::size_t bytes);

  /// A curve of a resident unit.
  [[nodiscard]] const PreparedCurve& curve(CurveId curve) const { return *members_[curve].prepared; }
  [[nodiscard]] const std::string& digest(CurveId curve) const { return members_[curve].digest; }

  [[nodiscard]] const CacheCounts& counts() const { return counts_; }

 private:
  struct Member {
    UnitId unit;
    Requirements requirements;
    std::shared_ptr<const PreparedCurve> prepared;
    std::string digest;      ///< digest at the first reading
    std::size_t points = 0;  ///< 0: not read yet
  };
  struct Unit {
    CurveUnit what;
    CurveId first;
    State state = State::absent;
    std::uint32_t pins = 0;
    std::uint64_t last_use = 0, reads = 0;
    std::size_t bytes = 0;
  };
  void drop(Unit& unit);
  void book(std::ptrdiff_t bytes);
  [[nodiscard]] std::shared_ptr<Loaded> read_anew(const Unit& unit, const Loading& loading) const;
  [[nodiscard]] std::vector<Requirements> requirements_of(const Unit& unit) const;

  std::size_t budget_, used_ = 0;
  KeptCurves* kept_;
  std::uint64_t clock_ = 0;
  std::vector<Member> members_;
  std::vector<Unit> units_;
  CacheCounts counts_;
};

struct CurveCache::Loaded {
  std::vector<KeptCurves::Kept> curves;
  std::size_t bytes = 0;
  bool was_kept = false;
  double read_seconds = 0, prepare_seconds = 0;
};

}  // namespace lober::detail
