// The work of a job. One table of operations; each is a file in operations/.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/batch/operations/allowance.hpp"
#include "engine/batch/operations/options.hpp"
#include "engine/batch/operations/prepared_curve.hpp"
#include "engine/batch/operations/result.hpp"

namespace lober::detail {

class OutputFolder;

/// The number of curves that a job of an operation has.
enum class Arity : std::uint8_t { none, one, two, one_or_two };
[[nodiscard]] bool takes(Arity arity, std::size_t curves);

/// The curves of a job, in order, and the limits of the job.
class JobCurves {
 public:
  JobCurves(std::span<const PreparedCurve* const> curves, const Allowance& allowance,
            const OutputFolder* outputs = nullptr)
      : curves_(curves), allowance_(allowance), outputs_(outputs) {}
  [[nodiscard]] std::size_t size() const { return curves_.size(); }
  [[nodiscard]] const PreparedCurve* operator[](std::size_t k) const { return curves_[k]; }
  [[nodiscard]] const Allowance& allowance() const { return allowance_; }
  /// Below which the job writes its file; null: anywhere.
  [[nodiscard]] const OutputFolder* outputs() const { return outputs_; }

 private:
  std::span<const PreparedCurve* const> curves_;
  const Allowance& allowance_;
  const OutputFolder* outputs_;
};

/// A job without curves that is like another one and takes less time.
struct Pilot {
  Options options;
  /// Seconds of the other job, from the seconds of this one and its result, which has failed where it was broken off.
  std::function<double(double seconds, const Result& result)> forecast;
};

/// A program that feeds the queue may bring its own.
struct Operation {
  std::string name;
  std::string summary = {};  ///< one line; of those in the table
  std::string view = {};     ///< view of its results in a store, for SQL; only for those in the table
  int revision = 1;          ///< goes into the key of results: raise it when the numbers change
  Arity arity = Arity::two;
  bool open = false;  ///< curves of a manifest are open unless it says otherwise
  std::vector<OptionSpec> options = {};
  /// Flags among the options that no job may set, since no column or list has their results: nothing proposes them.
  std::vector<std::string> not_kept = {};
  /// Whether a job may set that option.
  [[nodiscard]] bool keeps(const std::string& key) const {
    return std::find(not_kept.begin(), not_kept.end(), key) == not_kept.end();
  }
  std::vector<Column> columns = {};  ///< names that SQL takes in quotes; of those in the table, see store_format
  std::vector<std::string> lists = {};
  /// The elements of lists as columns of their own, which exports have behind the others: those of one result, where
  /// their number depends on it. May be empty. A pure function of the values and lists.
  std::function<std::vector<std::pair<Column, double>>(const Result&)> spread = {};
  /// Throws UsageError "key: message" for options that cannot go together; may be empty.
  std::function<void(const Options&)> check = {};
  std::function<Requirements(const Options&)> requirements;
  /// Makes the values and the lists. Called from several threads at the same time. May throw any std::exception: the
  /// job has failed then.
  std::function<Result(JobCurves curves, const Options& options)> run;
  /// The name of the file that a job on curves of these names writes, as its options have it; empty for none.
  std::function<std::string(const Options& options, std::string_view first, std::string_view second)> output = {};
  /// Microseconds on one core for a number of points, roughly: the first term costs most.
  std::function<double(std::size_t points)> cost;
  /// For operations without curves whose time nobody can tell from their options: a job of a tenth of a second or so
  /// that can be run instead. May be empty.
  std::function<Pilot(const Options& options)> pilot = {};
  /// Bytes of the data that it makes of its first curve, roughly, where its options decide that; may be empty.
  std::function<double(const Curve& curve, const Options& options)> result_bytes = {};
  std::size_t memory = 0;  ///< bytes that a job takes beyond the usual ones for that number of points
};

/// The options of a job. Throws UsageError "key: message" as Options does, but names only keys that jobs may set, and
/// says of a key like that of one of `not_kept` that it is refused.
[[nodiscard]] Options job_options(const Operation& operation, std::span<const OptionSetting> settings);
/// The reason why a flag of `not_kept` is refused: the end of a sentence.
[[nodiscard]] std::string reason_not_kept(const Operation& operation);

/// The operations that a manifest can name.
[[nodiscard]] std::span<const Operation> all_operations();
[[nodiscard]] const Operation* find_operation(std::string_view name);  ///< null if there is none

}  // namespace lober::detail
