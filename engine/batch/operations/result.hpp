// The outcome of a job.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lober/base/buffer.hpp"

namespace lober::detail {

/// One number of a result. Counts are kept as doubles too: they are exact below 2^53.
struct Column {
  enum class Kind : std::uint8_t { real, count };
  std::string name;
  Kind kind = Kind::real;
  std::string unit = {};     ///< as operations::Field::unit
  std::string meaning = {};  ///< as operations::Field::meaning; empty where nothing is known
};

/// SHA-256 of what a result depends on; see JobKeys.
using JobKey = std::array<std::byte, 32>;

/// Stands for a job number: no job of the present plan.
inline constexpr std::uint32_t no_job = 0xffffffff;

/// An operation fills in the values and the lists, the queue and the store the rest.
struct Result {
  /// In the order of the operation's columns; none if the job failed. One thread makes them and another gives them
  /// back, for which a heap of the C library grows and shrinks all the time.
  Buffer<double> values = {};
  std::vector<std::vector<double>> lists = {};  ///< in the order of the operation's lists; none for all of them empty
  std::string error = {};                       ///< why the job failed; empty if it did not
  double seconds = 0;                           ///< the operation alone
  std::uint32_t job = 0;                        ///< as `submit` numbered it, or its number in the plan
  /// Digests of the curves' contents, hexadecimal, only if JobQueueOptions::digests; empty for a curve that was not
  /// read. Views: they end with what has made the result, a queue or DecodedResults.
  std::array<std::string_view, 2> digests = {};
  JobKey key = {};       ///< key of a job of a plan
  std::int64_t run = 0;  ///< run of the store in which it was computed; 0: the present one

  [[nodiscard]] bool failed() const { return !error.empty(); }
};

struct DecodedResults {
  std::vector<Result> results;
  std::vector<std::string> texts;  ///< their digests are views of these
};

/// Results as CBOR, to be sent, and back, bit for bit. `decoded_results` throws DataError for bytes that are none.
[[nodiscard]] std::string encoded(std::span<const Result> results);
[[nodiscard]] DecodedResults decoded_results(std::string_view bytes);

/// The lists of a result as JSON, to be stored where SQL can look into them: {"flux12": [0.1, ...], ...}, every double
/// with the digits that give it back, null for NaN, "Infinity" and "-Infinity"; no text for lists that are all empty.
/// `decoded_lists` throws DataError for other texts.
[[nodiscard]] std::string encoded_lists(std::span<const std::vector<double>> lists, std::span<const std::string> names);
[[nodiscard]] std::vector<std::vector<double>> decoded_lists(std::string_view text, std::span<const std::string> names);

}  // namespace lober::detail
