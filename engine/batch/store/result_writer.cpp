#include "engine/batch/store/result_writer.hpp"

#include <chrono>
#include <new>

#include "engine/base/processor_time.hpp"

namespace lober::detail {
namespace {

// A kill loses the results since the last commit: at most this long, or this number of results.
constexpr std::chrono::milliseconds interval(100);
constexpr std::size_t many = 4096;

}  // namespace

ResultWriter::ResultWriter(Store& store, std::function<void()> failed)
    : store_(store), failed_(std::move(failed)), thread_([this] { work(); }) {}

ResultWriter::~ResultWriter() {
  try {
    finish();
  } catch (...) {  // whoever wants to know calls `finish`
  }
}

void ResultWriter::add(Result&& result) {
  const std::lock_guard lock(mutex_);
  results_.push_back(std::move(result));
  if (results_.size() == many) wake_.notify_one();
}

void ResultWriter::add(const std::string& input, const std::string& digest) {
  const std::lock_guard lock(mutex_);
  digests_[input] = digest;
}

void ResultWriter::finish() {
  {
    const std::lock_guard lock(mutex_);
    finish_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
  if (error_) std::rethrow_exception(error_);
}

void ResultWriter::work() {
  const double start = processor_seconds();
  std::vector<Result> results;  // `add` fills one, while the other is written
  for (bool last = false; !last;) {
    results.clear();  // when nobody waits for the lock
    InputDigests digests;
    try {
      results.reserve(many);
    } catch (const std::bad_alloc&) {  // it grows as far as there is memory
    }
    {
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, interval, [&] { return finish_ || results_.size() >= many; });
      last = finish_;
      results.swap(results_);
      digests.swap(digests_);
    }
    if (error_) continue;
    try {
      if (results.empty() && digests.empty()) {
        store_.require_in_place();
      } else {
        store_.append(results, digests);
      }
    } catch (...) {
      error_ = std::current_exception();
      failed_();
    }
  }
  seconds_ = processor_seconds() - start;
}

}  // namespace lober::detail
