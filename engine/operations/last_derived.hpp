// The consequences of options, kept for the next job that has the same ones (private to operations/).
//
// A batch runs thousands of small jobs with the options of one group, and reading these by name took longer than to
// order the crossings of two short curves.
#pragma once

#include <optional>
#include <utility>

#include "lober/operations/options.hpp"

namespace lober::detail::table {

template <typename T>
class LastDerived {
 public:
  /// make(options), by `owner`: made anew where the options or the owner are others than the last time. Copies of
  /// options are the same as these.
  template <typename Make>
  const T& of(const operations::Options& options, const void* owner, const Make& make) {
    if (!value_ || owner != owner_ || options.settings().data() != options_.settings().data()) {
      value_.reset();
      value_.emplace(make(options));
      options_ = options;  // which keeps other options from having their address
      owner_ = owner;
    }
    return *value_;
  }

 private:
  operations::Options options_;
  const void* owner_ = nullptr;
  std::optional<T> value_;
};

}  // namespace lober::detail::table
