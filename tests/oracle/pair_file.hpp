// Writing down a pair on which two answers differ, so that it can be studied and become a test.
#pragma once

#include <functional>
#include <string>

#include "tests/oracle/families.hpp"

namespace lober::oracle {

/// The pair as C++: two initialisers of hexadecimal floating-point numbers, with its name above.
[[nodiscard]] std::string as_source(const CurvePair& pair);

/// Writes `as_source` and `remark` to `FAMILY-SEED.txt` in the folder of the environment variable
/// LOBER_FAILURES, or else in `lober-failures` in the system's temporary folder. Returns the path.
std::string write_pair(const CurvePair& pair, const std::string& remark);

/// A pair that still fails with as few vertices as removing them one by one gives. Both curves stay simple.
[[nodiscard]] CurvePair minimised(CurvePair pair, const std::function<bool(const CurvePair&)>& fails);

}  // namespace lober::oracle
