// Run by mpirun: rank 0 receives, from all others at the same time, messages that go in pieces.

#include "cli/mpi/messages.hpp"

#include <cstdio>
#include <map>

using namespace lober::cli;

namespace {

constexpr std::size_t piece = 1000;
constexpr std::size_t sizes[] = {0, 1, 991, 992, 999, 1000, 1001, 2000, 2001, 123'457};

std::string content(int rank, std::size_t size) {
  std::string bytes(size, '\0');
  for (std::size_t k = 0; k < size; ++k) bytes[k] = static_cast<char>(k * 7 + static_cast<std::size_t>(rank));
  return bytes;
}

bool receives_all(int ranks) {
  std::map<int, std::size_t> next;
  for (std::size_t left = std::size(sizes) * static_cast<std::size_t>(ranks - 1); left > 0; --left) {
    const Message message = receive();
    const std::size_t size = sizes[next[message.rank]++];
    if (message.tag != Tag::results || message.bytes != content(message.rank, size)) return false;
  }
  return !receive_if_any();
}

}  // namespace

int main(int count, char** arguments) {
  MPI_Init(&count, &arguments);
  int rank = 0, ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  int status = 0;
  if (rank == 0) {
    status = receives_all(ranks) ? 0 : 1;
  } else {
    for (const std::size_t size : sizes) send(0, Tag::results, content(rank, size), piece);
  }
  std::string all = rank == 0 ? content(0, 5000) : "";
  broadcast(all);
  if (all != content(0, 5000)) status = 1;
  if (status != 0) std::fprintf(stderr, "rank %d: a message is not what was sent\n", rank);
  MPI_Finalize();
  return status;
}
