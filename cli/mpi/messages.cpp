#include "cli/mpi/messages.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdlib>

#include "cli/program/log.hpp"
#include "engine/batch/bytes.hpp"

namespace lober::cli {
namespace {

// Receives what was probed and appends it.
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
  const auto size = ByteReader(first).get<std::uint64_t>();
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
  ByteWriter first;  // how much there is in all, and the first piece
  first.put(std::uint64_t{bytes.size()});
  const std::string_view all = bytes;
  const std::size_t begin = std::min(all.size(), piece);
  send_piece(rank, tag, first.take() + std::string(all.substr(0, begin)));
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

std::string encoded(const std::vector<PlanResult>& results) {
  ByteWriter writer;
  writer.put(std::uint64_t{results.size()});
  for (const PlanResult& result : results) {
    writer.put(result.job);
    writer.put(result.key);
    writer.put_flag(result.failed);
    writer.put(result.seconds);
    writer.put_text(result.value);
    writer.put_text(result.digest1);
    writer.put_text(result.digest2);
  }
  return writer.take();
}

std::vector<PlanResult> decoded_results(const std::string& bytes) {
  ByteReader reader(bytes);
  std::vector<PlanResult> results(reader.get_count());
  for (PlanResult& result : results) {
    result.job = reader.get<std::uint32_t>();
    result.key = reader.get<JobKey>();
    result.failed = reader.get_flag();
    result.seconds = reader.get<double>();
    result.value = reader.get_text();
    result.digest1 = reader.get_text();
    result.digest2 = reader.get_text();
  }
  return results;
}

std::string encoded(const std::vector<std::uint32_t>& jobs) {
  ByteWriter writer;
  writer.put_all(jobs);
  return writer.take();
}

std::vector<std::uint32_t> decoded_jobs(const std::string& bytes) {
  return ByteReader(bytes).get_all<std::uint32_t>();
}

}  // namespace lober::cli
