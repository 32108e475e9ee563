// The one thread that writes to a store: results come from many threads and go to disk many at a time.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/batch/store/store.hpp"

namespace lober::detail {

class ResultWriter {
 public:
  /// `failed` is called once, from the writer's thread, when the store cannot be written (a full disk).
  ResultWriter(Store& store, std::function<void()> failed);
  /// Writes the results that are left, unless writing has failed.
  ~ResultWriter();
  ResultWriter(const ResultWriter&) = delete;
  ResultWriter& operator=(const ResultWriter&) = delete;

  void add(Result&& result);
  void add(const std::string& input, const std::string& digest);
  /// Returns when all is committed; throws what went wrong. Nothing may be added afterwards.
  void finish();
  [[nodiscard]] double seconds() const { return seconds_; }  ///< processor time, after `finish`

 private:
  void work();

  Store& store_;
  std::function<void()> failed_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<Result> results_;
  InputDigests digests_;
  bool finish_ = false;
  std::exception_ptr error_;
  double seconds_ = 0;
  std::thread thread_;
};

}  // namespace lober::detail
