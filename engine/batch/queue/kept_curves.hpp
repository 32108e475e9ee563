// Prepared curves that outlive their queue, so that a process which computes one portion after the other reads and
// indexes each file once.
//
//   KeptCurves kept(std::size_t{1} << 30);
//   run_portion(portion, {.manifest_path = "job.toml", .kept = &kept});   // any number of them, also at the same time
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/batch/operations/prepared_curve.hpp"
#include "engine/batch/queue/file_stamp.hpp"

namespace lober::detail {

/// The names by which the curves of a unit are known from one queue to the next. The names say everything that decides
/// about a curve besides the contents of the file.
struct KeptNames {
  std::string path = {};                 ///< file that the curves come from; empty: from none
  std::vector<std::string> curves = {};  ///< a name for each curve; empty: the unit is not kept
};

/// For any thread. Curves are handed out as pointers that have to be gone before the object goes.
class KeptCurves {
 public:
  /// `budget`: bytes for the curves and for what the queues that share them take, as QueueOptions::memory. Curves that
  /// no queue uses are dropped, least recently used first, before more is taken. `age`: as file_stamp.
  explicit KeptCurves(std::size_t budget = 0, std::chrono::nanoseconds age = std::chrono::seconds(2));
  KeptCurves(const KeptCurves&) = delete;
  KeptCurves& operator=(const KeptCurves&) = delete;

  /// Changes the budget, and drops what has no room in it any more.
  void set_budget(std::size_t budget);

  /// A prepared curve and the digest of its content.
  struct Kept {
    std::shared_ptr<const PreparedCurve> curve;
    std::string digest;
  };
  /// The curves of a unit, if all of them are there as `requirements` want them, from the file as it is now.
  [[nodiscard]] std::optional<std::vector<Kept>> find(const KeptNames& names,
                                                      std::span<const Requirements> requirements);
  /// The points of the curves of a unit when they were kept, for an estimate that reads nothing; 0: not all are there.
  [[nodiscard]] std::size_t points(const KeptNames& names) const;
  /// The stamp to take before a unit is read, for `keep`; none: its curves cannot be kept.
  [[nodiscard]] std::optional<FileStamp> stamp_of(const KeptNames& names) const;
  /// Keeps the curves of a unit and puts in their place the pointers by which it learns when they are not used any
  /// more; not if the file has changed since `before`.
  void keep(const KeptNames& names, std::span<const Requirements> requirements, const FileStamp& before,
            std::span<Kept> curves);

  /// Says that a queue takes this number of bytes more (or less, if negative), curves that are in use included.
  void occupy(std::ptrdiff_t bytes);

  struct Counts {
    std::size_t curves = 0, idle_bytes = 0, occupied_bytes = 0;  ///< now
    std::uint64_t found = 0, kept = 0, dropped = 0;              ///< curves, since the beginning
  };
  [[nodiscard]] Counts counts() const;

 private:
  struct Entry {
    std::string name;
    FileStamp stamp;
    Requirements requirements;
    Kept kept;
    std::size_t bytes = 0, users = 0;
    std::optional<std::list<std::shared_ptr<Entry>>::iterator> idle_at = {};  ///< if nobody uses it
  };
  struct Loan;
  using Entries = std::vector<std::shared_ptr<Entry>>;
  [[nodiscard]] std::shared_ptr<const PreparedCurve> lent(const std::shared_ptr<Entry>& entry);
  void give_back(const std::shared_ptr<Entry>& entry);
  void remove(const std::shared_ptr<Entry>& entry, Entries& removed);
  void drop_idle(Entries& removed);

  const std::chrono::nanoseconds age_;
  mutable std::mutex mutex_;  ///< for all that follows, except that the sums are read without it
  std::atomic<std::size_t> budget_, idle_bytes_{0}, occupied_{0};
  std::unordered_map<std::string, std::shared_ptr<Entry>> entries_;
  std::list<std::shared_ptr<Entry>> idle_;  ///< those that nobody uses, least recently used first
  Counts counts_;
};

}  // namespace lober::detail
