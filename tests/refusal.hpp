// Messages of refusals.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "lober/base/error.hpp"

namespace lober::test {

/// The message of the error that the call throws. Fails the test when it throws none.
template <typename Error = DataError, typename Call>
[[nodiscard]] std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

}  // namespace lober::test
