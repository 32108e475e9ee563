#include "cli/mpi/messages.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "cli/program/log.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

using Json = nlohmann::json;

std::string cbor(const Json& made) {
  std::string bytes;
  Json::to_cbor(made, bytes);
  return bytes;
}

template <typename T, typename Read>
T read(const std::string& bytes, const Read& from_json) {
  try {
    return from_json(Json::from_cbor(bytes));
  } catch (const Json::exception& error) {
    throw DataError(std::string("a message of another rank cannot be read: ") + error.what());
  }
}

// Receives the message that was probed and appends it.
void append(MPI_Status& status, std::string& bytes) {
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  const std::size_t before = bytes.size();
  bytes.resize(before + static_cast<std::size_t>(size));
  MPI_Recv(bytes.data() + before, size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

// Pieces of one rank come in order, and no other message of that rank between them.
Message take(MPI_Status& status) {
  Message message{status.MPI_SOURCE, static_cast<Tag>(status.MPI_TAG), {}};
  std::string first;
  append(status, first);
  std::uint64_t size = 0;
  if (first.size() < sizeof(size)) throw DataError("a message of another rank is cut off");
  std::memcpy(&size, first.data(), sizeof(size));
  message.bytes.reserve(size);
  message.bytes = first.substr(sizeof(size));
  while (message.bytes.size() < size) {
    MPI_Probe(message.rank, static_cast<int>(Tag::more), MPI_COMM_WORLD, &status);
    append(status, message.bytes);
  }
  return message;
}

void send_piece(int rank, Tag tag, std::string_view bytes) {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, static_cast<int>(tag), MPI_COMM_WORLD);
}

}  // namespace

void send(int rank, Tag tag, const std::string& bytes, std::size_t piece) {
  const std::uint64_t size = bytes.size();
  std::string first(reinterpret_cast<const char*>(&size), sizeof(size));  // how much there is in all
  const std::string_view all = bytes;
  const std::size_t begin = std::min(all.size(), piece);
  send_piece(rank, tag, first.append(all.substr(0, begin)));
  for (std::size_t at = begin; at < all.size(); at += piece) send_piece(rank, Tag::more, all.substr(at, piece));
}

void abandon(const std::string& message, int status) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  log_error(fmt::format("rank {}: {}", rank, message));
  flush_log();
  MPI_Abort(MPI_COMM_WORLD, status);
  std::_Exit(status);
}

Message receive() {
  MPI_Status status;
  MPI_Probe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &status);
  return take(status);
}

std::optional<Message> receive_if_any() {
  MPI_Status status;
  int there = 0;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  return take(status);
}

void broadcast(std::string& bytes) {
  auto size = static_cast<unsigned long long>(bytes.size());
  MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, 0, MPI_COMM_WORLD);
  bytes.resize(size);
  constexpr unsigned long long most = 1ULL << 30;  // counts are int
  for (unsigned long long at = 0; at < size; at += most) {
    MPI_Bcast(bytes.data() + at, static_cast<int>(std::min(most, size - at)), MPI_BYTE, 0, MPI_COMM_WORLD);
  }
}

std::string encoded(const std::vector<std::uint32_t>& jobs) {
  return cbor(Json(jobs));
}

std::vector<std::uint32_t> decoded_jobs(const std::string& bytes) {
  return read<std::vector<std::uint32_t>>(bytes,
                                          [](const Json& from) { return from.get<std::vector<std::uint32_t>>(); });
}

std::string encoded(const QueueReport& report) {
  const CacheCounts& cache = report.cache;
  return cbor({{"jobs", report.jobs},
               {"failed", report.failed},
               {"stopped", report.stopped},
               {"points", report.points},
               {"wall_seconds", report.wall_seconds},
               {"operation_seconds", report.operation_seconds},
               {"callback_seconds", report.callback_seconds},
               {"threads", report.threads},
               {"units_read", cache.units_read},
               {"curves_indexed", cache.curves_indexed},
               {"max_reads", cache.max_reads},
               {"evictions", cache.evictions},
               {"peak_bytes", cache.peak_bytes},
               {"read_seconds", cache.read_seconds},
               {"prepare_seconds", cache.prepare_seconds}});
}

QueueReport decoded_report(const std::string& bytes) {
  return read<QueueReport>(bytes, [](const Json& from) {
    QueueReport report;
    CacheCounts& cache = report.cache;
    from.at("jobs").get_to(report.jobs);
    from.at("failed").get_to(report.failed);
    from.at("stopped").get_to(report.stopped);
    from.at("points").get_to(report.points);
    from.at("wall_seconds").get_to(report.wall_seconds);
    from.at("operation_seconds").get_to(report.operation_seconds);
    from.at("callback_seconds").get_to(report.callback_seconds);
    from.at("threads").get_to(report.threads);
    from.at("units_read").get_to(cache.units_read);
    from.at("curves_indexed").get_to(cache.curves_indexed);
    from.at("max_reads").get_to(cache.max_reads);
    from.at("evictions").get_to(cache.evictions);
    from.at("peak_bytes").get_to(cache.peak_bytes);
    from.at("read_seconds").get_to(cache.read_seconds);
    from.at("prepare_seconds").get_to(cache.prepare_seconds);
    return report;
  });
}

}  // namespace lober::cli
