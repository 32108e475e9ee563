#include "engine/c/disagreements.hpp"

#include "engine/base/text.hpp"
#include "engine/c/call.hpp"

namespace lober::detail::c {

std::string lines_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

void require_agreement(lober_result& result, const Agreement& agreement) {
  if (agreement.agrees()) return;
  std::vector<std::string> lines;
  for (const Comparison& one : agreement.disagreements()) {
    lines.push_back(one.what + ": " + detail::format_number(one.first) + " by " + one.first_by + ", " +
                    detail::format_number(one.second) + " by " + one.second_by + ", which differ by more than " +
                    detail::format_rounded(one.bar));
  }
  result.add("disagreements", lines_of(lines));
  throw WithResult{LOBER_DISAGREEMENT, lines_of(lines)};
}

}  // namespace lober::detail::c
