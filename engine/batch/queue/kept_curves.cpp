#include "engine/batch/queue/kept_curves.hpp"

#include <utility>

#include "engine/base/machine_memory.hpp"

namespace lober::detail {
namespace {

std::size_t bytes_of_budget(std::size_t budget) {
  return budget != 0 ? budget : machine_memory() / 2;
}

// Whether a curve that was prepared for `all` is so for `some`.
bool serves(const Requirements& all, const Requirements& some) {
  Requirements both = all;
  both |= some;
  return both == all;
}

}  // namespace

KeptCurves::KeptCurves(std::size_t budget, std::chrono::nanoseconds age)
    : age_(age), budget_(bytes_of_budget(budget)) {}

// Entries that go are destroyed when the lock is open again, as that of a large curve takes milliseconds; pointers that
// are handed out have to be, as their end takes the lock.

void KeptCurves::set_budget(std::size_t budget) {
  Entries removed;
  const std::lock_guard lock(mutex_);
  budget_ = bytes_of_budget(budget);
  drop_idle(removed);
}

std::size_t KeptCurves::points(const KeptNames& names) const {
  std::size_t sum = 0;
  const std::lock_guard lock(mutex_);
  for (const std::string& name : names.curves) {
    const auto at = entries_.find(name);
    if (at == entries_.end()) return 0;
    sum += at->second->kept.curve->curve().points.size();
  }
  return sum;
}

std::optional<FileStamp> KeptCurves::stamp_of(const KeptNames& names) const {
  if (names.curves.empty()) return std::nullopt;
  if (names.path.empty()) return FileStamp{};
  return file_stamp(names.path, age_);
}

std::optional<std::vector<KeptCurves::Kept>> KeptCurves::find(const KeptNames& names,
                                                              std::span<const Requirements> requirements) {
  {
    const std::lock_guard lock(mutex_);
    if (names.curves.empty() || !entries_.contains(names.curves.front())) return std::nullopt;
  }
  const std::optional<FileStamp> now = stamp_of(names);
  Entries found, removed;
  std::vector<Kept> curves;
  const std::lock_guard lock(mutex_);
  for (std::size_t k = 0; k < names.curves.size(); ++k) {
    const auto at = entries_.find(names.curves[k]);
    if (at == entries_.end()) return std::nullopt;
    const std::shared_ptr<Entry> entry = at->second;
    if (!now || entry->stamp != *now) {
      remove(entry, removed);
      return std::nullopt;
    }
    if (!serves(entry->requirements, requirements[k])) return std::nullopt;
    found.push_back(entry);
  }
  for (const std::shared_ptr<Entry>& entry : found) curves.push_back({lent(entry), entry->kept.digest});
  counts_.found += curves.size();
  return curves;
}

void KeptCurves::keep(const KeptNames& names, std::span<const Requirements> requirements, const FileStamp& before,
                      std::span<Kept> curves) {
  if (stamp_of(names) != before) return;
  Entries removed;
  const std::lock_guard lock(mutex_);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const auto at = entries_.find(names.curves[k]);
    std::shared_ptr<Entry> entry = at == entries_.end() ? nullptr : at->second;
    // Another queue may have kept the same meanwhile.
    if (!entry || entry->stamp != before || !serves(entry->requirements, requirements[k])) {
      if (entry) remove(entry, removed);
      const std::size_t bytes = curves[k].curve->memory();
      entry = std::make_shared<Entry>(Entry{names.curves[k], before, requirements[k], curves[k], bytes});
      entries_.emplace(names.curves[k], entry);
      ++counts_.kept;
    }
    curves[k].curve = lent(entry);
  }
}

void KeptCurves::occupy(std::ptrdiff_t bytes) {
  const std::size_t taken = occupied_ += static_cast<std::size_t>(bytes);  // modulo 2^64, as it comes back to 0
  if (bytes <= 0 || taken + idle_bytes_ <= budget_) return;
  Entries removed;
  const std::lock_guard lock(mutex_);
  drop_idle(removed);
}

KeptCurves::Counts KeptCurves::counts() const {
  const std::lock_guard lock(mutex_);
  Counts counts = counts_;
  counts.curves = entries_.size();
  counts.idle_bytes = idle_bytes_;
  counts.occupied_bytes = occupied_;
  return counts;
}

// Says when the last pointer to a curve is gone.
struct KeptCurves::Loan {
  explicit Loan(KeptCurves& of) : kept(of) {}
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;
  ~Loan() {
    if (entry) kept.give_back(entry);
  }
  KeptCurves& kept;
  std::shared_ptr<Entry> entry;
};

std::shared_ptr<const PreparedCurve> KeptCurves::lent(const std::shared_ptr<Entry>& entry) {
  const auto loan = std::make_shared<Loan>(*this);
  loan->entry = entry;
  ++entry->users;
  if (entry->idle_at) {
    idle_.erase(*std::exchange(entry->idle_at, std::nullopt));
    idle_bytes_ -= entry->bytes;
  }
  return {loan, entry->kept.curve.get()};
}

void KeptCurves::give_back(const std::shared_ptr<Entry>& entry) {
  Entries removed;
  const std::lock_guard lock(mutex_);
  if (--entry->users != 0) return;
  const auto at = entries_.find(entry->name);
  if (at == entries_.end() || at->second != entry) return;  // the file has changed meanwhile
  entry->idle_at = idle_.insert(idle_.end(), entry);
  idle_bytes_ += entry->bytes;
  drop_idle(removed);
}

void KeptCurves::remove(const std::shared_ptr<Entry>& entry, Entries& removed) {
  if (entry->idle_at) {
    idle_.erase(*std::exchange(entry->idle_at, std::nullopt));
    idle_bytes_ -= entry->bytes;
  }
  entries_.erase(entry->name);
  removed.push_back(entry);
}

void KeptCurves::drop_idle(Entries& removed) {
  while (!idle_.empty() && occupied_ + idle_bytes_ > budget_) {
    remove(std::shared_ptr<Entry>(idle_.front()), removed);
    ++counts_.dropped;
  }
}

}  // namespace lober::detail
