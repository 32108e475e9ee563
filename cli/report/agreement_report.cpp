#include "cli/report/agreement_report.hpp"

#include <spdlog/fmt/fmt.h>

namespace lober::cli {
namespace {

std::string sentence(const std::vector<Comparison>& disagreements) {
  const auto worst = std::max_element(disagreements.begin(), disagreements.end(), [](const auto& x, const auto& y) {
    return x.difference() - x.bar < y.difference() - y.bar;
  });
  std::string text = fmt::format(
      "{} is {:.12g} by {} and {:.12g} by {}; they differ by {:.1e}, their error bars allow {:.1e}", worst->what,
      worst->first, worst->first_by, worst->second, worst->second_by, worst->difference(), worst->bar);
  if (disagreements.size() > 1) text += fmt::format(" (and {} more)", disagreements.size() - 1);
  return text;
}

Json disagreements_json(const Agreement& agreement) {
  Json list = Json::array();
  for (const Comparison& comparison : agreement.disagreements()) {
    list.push_back({{"what", comparison.what},
                    {"first", {{"by", comparison.first_by}, {"value", comparison.first}}},
                    {"second", {{"by", comparison.second_by}, {"value", comparison.second}}},
                    {"difference", comparison.difference()},
                    {"bar", comparison.bar}});
  }
  return list;
}

}  // namespace

std::string agreement_text(const Agreement& agreement) {
  const std::vector<Comparison> disagreements = agreement.disagreements();
  return disagreements.empty() ? std::string() : "DISAGREEMENT: " + sentence(disagreements) + "\n";
}

void add_agreement(Json& json, const Agreement& agreement) {
  json["agreement"] = agreement.agrees();
  json["disagreements"] = disagreements_json(agreement);
}

void add_agreement(JsonFile& json, const Agreement& agreement) {
  json.member("agreement", agreement.agrees());
  json.member("disagreements", disagreements_json(agreement));
}

void require_agreement(const Agreement& agreement) {
  const std::vector<Comparison> disagreements = agreement.disagreements();
  if (!disagreements.empty()) throw DisagreementError("two routes disagree: " + sentence(disagreements));
}

}  // namespace lober::cli
