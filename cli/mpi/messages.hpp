// Messages between the ranks: bytes with a tag, of any length.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lober/batch.hpp"

namespace lober::cli {

enum class Tag : int {
  ready,    ///< worker: has nothing to do
  jobs,     ///< coordinator: do these; none: finish
  results,  ///< worker: these are done
  report,   ///< worker: has finished
  stop,     ///< coordinator: finish what runs, then ask
  more,     ///< the next piece of a message
};

struct Message {
  int rank;
  Tag tag;
  std::string bytes;
};

/// MPI counts bytes in an int, so that longer messages go in pieces of at most `piece` bytes. One thread at a time.
inline constexpr std::size_t longest_piece = std::size_t{1} << 30;
void send(int rank, Tag tag, const std::string& bytes, std::size_t piece = longest_piece);
/// Waits for a message, and for all of its pieces.
[[nodiscard]] Message receive();
/// Nothing if there is no message yet.
[[nodiscard]] std::optional<Message> receive_if_any();
/// The failure of one rank ends all of them, whatever they do: MPI_Abort with this exit status.
[[noreturn]] void abandon(const std::string& message, int status);

/// Sends bytes from rank 0 to all ranks.
void broadcast(std::string& bytes);

/// The data as CBOR; `decoded_...` throw DataError for other bytes. Results: see result.hpp.
[[nodiscard]] std::string encoded(const std::vector<std::uint32_t>& jobs);
[[nodiscard]] std::vector<std::uint32_t> decoded_jobs(const std::string& bytes);
[[nodiscard]] std::string encoded(const QueueReport& report);
[[nodiscard]] QueueReport decoded_report(const std::string& bytes);

}  // namespace lober::cli
