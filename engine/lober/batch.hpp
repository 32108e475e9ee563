// Batches of many curves and pairs: a manifest says what to compute, and a store keeps the results.
//
//   lober::BatchOptions options;
//   options.store = "pairs.results";
//   const lober::BatchReport report = lober::run_batch("pairs.toml", options);
//   lober::export_results("pairs.results", "pairs.csv", lober::ExportFormat::csv);
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"

namespace lober {

/// An option of an operation, as a manifest gives it.
struct OperationOption {
  std::string key;                   ///< "parameters.*" stands for a table of any names
  std::string type;                  ///< "true or false", "whole number", "number" or "text"
  std::string fallback;              ///< the value when it is not given
  std::vector<std::string> choices;  ///< the allowed values of a text; empty: any
  std::optional<double> min, max;    ///< the bounds of a number
  bool above_min = false;            ///< min itself is excluded
  std::string meaning;               ///< a phrase
};

/// An operation that a manifest can ask for, and the parts of its results that are stored.
struct OperationInfo {
  std::string name, summary;                   ///< its name, and a sentence about it
  std::size_t min_curves = 0, max_curves = 0;  ///< numbers of curves that a job can have
  bool open = false;                           ///< curves are open unless the manifest says otherwise
  std::string view;                            ///< name of the view of its results in a store, for SQL
  std::vector<OperationOption> options;        ///< in their order
  std::vector<std::string> columns;            ///< names of the numbers of a result, in SQL and exports
  std::vector<std::string> lists;              ///< names of the lists of numbers of a result
};

/// All operations of batches.
[[nodiscard]] LOBER_API std::vector<OperationInfo> list_operations();

/// One of several processes or machines that share a plan: `number` counts from 0 and is less than `of`.
struct Shard {
  std::size_t number = 0, of = 1;  ///< number of the part, and number of parts
};

/// Counts of the reading and indexing of curves.
struct CacheCounts {
  std::uint64_t units_read = 0, curves_indexed = 0;  ///< files or zones that were read, and curves that were indexed
  std::uint64_t max_reads = 0;                       ///< how often one unit was read at most
  std::uint64_t evictions = 0;                       ///< curves that were dropped to make room for others
  std::size_t peak_bytes = 0;                        ///< curves, indexes, and the memory that running jobs may take
  double read_seconds = 0, prepare_seconds = 0;      ///< wall time of each reading, added up
};

/// Limits of a run.
struct QueueOptions {
  int threads = 0;         ///< 0: as many as the calling thread may use
  std::size_t memory = 0;  ///< bytes for curves, their indexes and the work on them; 0: half of the machine's
};

/// The work of a run. Seconds of threads are added up over all threads.
struct QueueReport {
  std::size_t jobs = 0, failed = 0;  ///< number of jobs that ran, and how many of them failed
  bool stopped = false;              ///< jobs are left, because of `stop`
  std::uint64_t points = 0;          ///< points of the curves of all jobs, a curve counted as often as it was used
  CacheCounts cache;                 ///< counts of curves
  double wall_seconds = 0;           ///< wall time of the run
  double operation_seconds = 0;      ///< time of threads in operations
  double callback_seconds = 0;       ///< time of threads in the callback, and waiting for it
  int threads = 0;                   ///< number of threads
  /// A line for each curve, and each pair, whose results may not mean what a user thinks, because of longitudes that
  /// were stored modulo 360 and no period in the manifest; sorted, the first thousand that were found.
  std::vector<std::string> warnings{};
};

/// How far a run is. Costs are in the unit of Operation::cost.
struct QueueProgress {
  std::size_t jobs = 0, done = 0, failed = 0;  ///< jobs in all, jobs that are done, and jobs that failed
  double cost = 0, cost_done = 0;              ///< cost of all jobs, and of those that are done
  std::uint64_t points_done = 0;               ///< points of the curves of the jobs that are done
};

/// Options of run_batch.
struct BatchOptions {
  std::string store;   ///< path of the store, a file that is made where there is none
  Shard shard;         ///< part of the jobs to run
  QueueOptions queue;  ///< limits of threads and memory
  /// Called about ten times a second while jobs run, from a thread of its own; return false to stop: jobs that run are
  /// finished and stored if they end within `patience` seconds, else broken off. An exception that it throws stops the
  /// run too and is passed on.
  std::function<bool(const QueueProgress&)> progress;
  double patience = 1;  ///< seconds that running jobs have after a stop
  /// The folder below which jobs write their files, and which names of outputs are relative to; empty: the folder of
  /// the manifest. It has to exist.
  std::string output_root = {};
};

/// The account of a run.
struct BatchReport {
  QueueReport queue;                 ///< the work on jobs
  std::size_t jobs = 0;              ///< jobs of the shard
  std::size_t finished_before = 0;   ///< jobs of the shard whose results were in the store
  std::vector<std::string> damaged;  ///< a line for each stored result that cannot be read; its job is done again
  /// results that the store had before and keeps, but that views, status and exports do not show any more: of another
  /// plan, or of inputs with other contents
  std::size_t hidden = 0;
  std::size_t stored_meanwhile = 0;  ///< results that another process stored while this run computed them too
  double store_seconds = 0;          ///< processor time of the thread that writes
  double wall_seconds = 0;           ///< wall time of the whole run
};

/// Runs what the manifest asks for and the store does not have yet. Throws DataError when the manifest or a store
/// cannot be read, UsageError "path:line: key: what is wrong" for everything in the manifest that is not understood and
/// for a shard that does not exist, DataError as soon as the store can no longer be written; a job that fails is not an
/// exception but counted. Jobs run side by side; results do not depend on the number of threads, on shards or on the
/// memory given.
[[nodiscard]] LOBER_API BatchReport run_batch(const std::string& manifest, const BatchOptions& options);

/// Format of an export.
enum class ExportFormat : std::uint8_t {
  csv,         ///< a header line; lists are put into one field, separated by blanks; unknown values are empty
  json_lines,  ///< one object a line; numbers that are not finite are null
  npy,         ///< a structured array, texts as bytes; no lists; unknown values are NaN, unknown counts -1
  netcdf,  ///< NetCDF, classic: a variable for each column along the dimension row; no lists; all numbers are float64
  hdf5,    ///< HDF5: the same as datasets of one axis; needs the HDF5 library, and memory for the whole table
};
/// The format that the end of a file's name stands for (.csv, .jsonl, .npy, .nc, .h5 or .hdf5). Throws UsageError for
/// any other end.
[[nodiscard]] LOBER_API ExportFormat export_format(const std::string& path);

/// Numbers of jobs of an export.
struct ExportCounts {
  std::size_t done = 0, failed = 0, missing = 0;  ///< jobs with a result, jobs that failed, and jobs without either
  std::vector<std::string> damaged;               ///< a line for each job whose result is damaged; it counts as missing
};

/// Writes the jobs of the store's plan that have a result or have failed, in the order of the plan, numbers in the
/// shortest form that reads back to the same bits. A damaged result is left out, like a missing one. CSV, NPY, NetCDF
/// and HDF5 hold one operation, which has to be named when the plan has several. The file appears when it is complete;
/// "-" is standard output. Throws DataError, UsageError.
LOBER_API ExportCounts export_results(const std::string& store, const std::string& path, ExportFormat format,
                                      const std::optional<std::string>& operation = {});

/// Copies the results of stores of the same plan, as shards write them, to the store `target`, which is created where
/// there is none: all of them, or nothing. Where two stores have the same job, a result takes the place of a failure.
/// Returns a line for each damaged result, which is left out. Throws UsageError when a store is named twice, DataError
/// when plans differ or when the same input was read with different contents, Cancelled when `progress` says so. The
/// time of a read and a write of all.
LOBER_API std::vector<std::string> merge_stores(const std::string& target, const std::vector<std::string>& stores,
                                                const Progress& progress = {});

}  // namespace lober
