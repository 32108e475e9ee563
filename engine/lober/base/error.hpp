// Every exception that leaves the engine.
//
//   Error                  base: catch this to catch all
//     UsageError           contradictory or impossible options              (program: exit status 2)
//     DataError            a file or a curve that cannot be used            (program: exit status 1)
//       NotSimpleError     a curve that crosses or touches itself, with the point
//     DisagreementError    two routes to a number differ by more than their error bars (program: exit status 3)
//     Cancelled            the caller's progress callback returned false, or a flag of a CancellationScope is set
//                          (program: exit status 130)
//
// An exception that a callback of the caller throws is passed on as it is. Functions that destroy, swap or return sizes
// are noexcept; any other one may throw std::bad_alloc too. DisagreementError is in agreement.hpp.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"

namespace lober {

class LOBER_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class LOBER_API UsageError : public Error {
 public:
  using Error::Error;
};

class LOBER_API DataError : public Error {
 public:
  using Error::Error;
};

/// The work was cancelled, by a function for progress or by a CancellationScope.
class LOBER_API Cancelled : public Error {
 public:
  /// The message is "cancelled".
  Cancelled() : Error("cancelled") {}
};

/// A curve that has to be simple and is not. `curve` counts from 1 in the order of the call's arguments;
/// the two segments (segment k joins vertex k to vertex k + 1) meet at `at`, rounded to double.
class LOBER_API NotSimpleError : public DataError {
 public:
  /// The error of curve `curve_number` (1 or 2), whose segments `first` and `second` meet at `point`.
  NotSimpleError(int curve_number, std::uint32_t first, std::uint32_t second, Point point);
  int curve;               ///< number of the curve, from 1
  std::uint32_t segment1;  ///< number of the first segment
  std::uint32_t segment2;  ///< number of the second segment
  Point at;                ///< the point where they meet, rounded
};

}  // namespace lober
