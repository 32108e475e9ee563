#include "engine/base/file_activity.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace lober::detail {
namespace {

std::mutex mutex;
std::string path_open;  // with `open_count` and `written_now`, under the mutex
int open_count = 0;
std::uint64_t number_opened = 0;
bool written_now = false;

std::atomic<std::uint64_t> size_to_read{0}, bytes_read{0}, bytes_parsed{0}, bytes_to_parse{0}, bytes_written{0};

double share(std::uint64_t part, std::uint64_t all) {
  return all == 0 ? 0 : std::min(1.0, static_cast<double>(part) / static_cast<double>(all));
}

}  // namespace

FileActivityScope::FileActivityScope(const std::string& path, bool is_written) {
  const std::lock_guard lock(mutex);
  ++open_count;
  ++number_opened;
  path_open = path;
  written_now = is_written;
  for (auto* const number : {&size_to_read, &bytes_read, &bytes_parsed, &bytes_to_parse, &bytes_written}) *number = 0;
}

FileActivityScope::~FileActivityScope() {
  const std::lock_guard lock(mutex);
  --open_count;
}

void note_size_to_read(std::uint64_t bytes) {
  size_to_read = bytes;
}
void note_read(std::uint64_t bytes) {
  bytes_read.fetch_add(bytes, std::memory_order_relaxed);
}
void note_parsed(std::uint64_t bytes, std::uint64_t all) {
  bytes_to_parse.store(all, std::memory_order_relaxed);
  bytes_parsed.fetch_add(bytes, std::memory_order_relaxed);
}
void note_written(std::uint64_t bytes) {
  bytes_written.fetch_add(bytes, std::memory_order_relaxed);
}

std::optional<FileActivity> file_activity() {
  const std::lock_guard lock(mutex);
  if (open_count == 0) return std::nullopt;
  FileActivity activity{path_open, written_now, 0, number_opened, 0};
  if (written_now) {
    activity.bytes = static_cast<double>(bytes_written.load());
  } else if (const std::uint64_t size = size_to_read; size != 0) {
    activity.fraction = 0.5 * share(bytes_read, size) + 0.5 * share(bytes_parsed, bytes_to_parse);
    activity.bytes = activity.fraction * static_cast<double>(size);
  } else {
    activity.bytes = static_cast<double>(bytes_read.load());
  }
  return activity;
}

}  // namespace lober::detail
