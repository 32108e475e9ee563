#include "cli/mpi/messages.hpp"

#include "engine/jobs/bytes.hpp"

namespace lober::cli {
namespace {

Message take(MPI_Status& status) {
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{status.MPI_SOURCE, static_cast<Tag>(status.MPI_TAG), std::string(static_cast<std::size_t>(size), 0)};
  MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.rank, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

}  // namespace

void send(int rank, Tag tag, const std::string& bytes) {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, static_cast<int>(tag), MPI_COMM_WORLD);
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
    writer.put(result.failed);
    writer.put(result.seconds);
    writer.put_text(result.value);
    writer.put_text(result.digest1);
    writer.put_text(result.digest2);
  }
  return writer.take();
}

std::vector<PlanResult> decoded_results(const std::string& bytes) {
  ByteReader reader(bytes);
  std::vector<PlanResult> results(reader.get<std::uint64_t>());
  for (PlanResult& result : results) {
    result.job = reader.get<std::uint32_t>();
    result.key = reader.get<JobKey>();
    result.failed = reader.get<bool>();
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
