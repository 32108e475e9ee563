#include "engine/batch/manifest/recipe_reader.hpp"

#include <charconv>

#include "engine/base/nearest_word.hpp"

namespace lober::detail {
namespace {

class RecipeReader {
 public:
  RecipeReader(const Manifest& manifest, const toml::table& table, std::string key)
      : manifest_(manifest), table_(table), key_(std::move(key)) {}

  LocatedText read() {
    for (const auto& [name, node] : table_) entry(std::string(name.str()), node);
    if (image_ == has_manifold_) fail(table_, "has to have either manifold or image_of");
    if (image_ && (recipe_.length > 0 || recipe_.saddle || recipe_.branch != 0)) {
      fail(table_, "length, from and branch are for manifolds");
    }
    if (image_) recipe_.kind = CurveRecipe::Kind::image;
    if (iterates_.empty() && image_) fail(table_, "image_of needs iterates");
    if (iterates_.empty()) iterates_.push_back(-1);
    for (const int iterates : iterates_) {
      recipe_.iterates = iterates;
      located_.recipes.push_back(recipe_);
      try {
        check(recipe_);
      } catch (const UsageError& error) {
        fail(table_, error.what());
      }
    }
    located_.line = table_.source().begin.line;
    located_.key = key_;
    return std::move(located_);
  }

 private:
  [[noreturn]] void fail(const toml::node& node, const std::string& message) const {
    manifest_.fail(node.source().begin.line, key_, message);
  }

  void entry(const std::string& name, const toml::node& node) {
    if (name == "system") {
      recipe_.system = text(node, name);
    } else if (name == "parameters") {
      if (!node.is_table()) fail(node, "parameters has to be a table");
      for (const auto& [parameter, value] : *node.as_table()) {  // toml++ has them by name
        recipe_.parameters.emplace_back(std::string(parameter.str()), number(value, std::string(parameter.str())));
      }
    } else if (name == "manifold") {
      const std::string side = text(node, name);
      if (side != "unstable" && side != "stable") fail(node, "manifold has to be \"unstable\" or \"stable\"");
      recipe_.kind = side == "stable" ? CurveRecipe::Kind::stable : CurveRecipe::Kind::unstable;
      has_manifold_ = true;
    } else if (name == "image_of") {
      located_.text = text(node, name);
      image_ = true;
    } else if (name == "iterates") {
      read_iterates(node);
    } else if (name == "branch") {
      const std::string sign = text(node, name);
      if (sign != "+" && sign != "-") fail(node, "branch has to be \"+\" or \"-\"");
      recipe_.branch = sign == "+" ? 1 : -1;
    } else if (name == "from") {
      const toml::array* const two = node.as_array();
      if (two == nullptr || two->size() != 2) fail(node, "from has to be [x, y]");
      recipe_.saddle = Point{number((*two)[0], name), number((*two)[1], name)};
    } else if (name == "length" || name == "tolerance" || name == "integration_tolerance") {
      const double value = number(node, name);
      if (!(value > 0)) fail(node, name + " has to be positive");
      (name == "length"      ? recipe_.length
       : name == "tolerance" ? recipe_.tolerance
                             : recipe_.integration_tolerance) = value;
    } else {
      const std::vector<std::string> known{"system", "parameters", "manifold", "from",      "branch",
                                           "length", "image_of",   "iterates", "tolerance", "integration_tolerance"};
      fail(node, "a curve of a system has no " + name + "; it has " + joined(known) + did_you_mean(name, known));
    }
  }

  // k or "a:b".
  void read_iterates(const toml::node& node) {
    constexpr int most = 10'000;
    int first = 0, last = 0;
    if (const auto* const whole = node.as_integer()) {
      if (**whole < -most || **whole > most) fail(node, "iterates has to be from -10000 to 10000");
      first = last = static_cast<int>(**whole);
    } else {
      const std::string range = node.is_string() ? **node.as_string() : "";
      const std::size_t colon = std::min(range.find(':'), range.size());
      const char *const begin = range.data(), *const end = begin + range.size();
      const char* const second = std::min(begin + colon + 1, end);
      const auto [stop1, error1] = std::from_chars(begin, begin + colon, first);
      const auto [stop2, error2] = std::from_chars(second, end, last);
      if (error1 != std::errc{} || error2 != std::errc{} || stop1 != begin + colon || stop2 != end || first > last ||
          first < -most || last > most) {
        fail(node, "iterates has to be a whole number or \"a:b\" with a <= b, from -10000 to 10000");
      }
    }
    for (int k = first; k <= last; ++k) iterates_.push_back(k);
    if (first < 0 && table_.get("image_of") == nullptr) fail(node, "iterates of a manifold cannot be negative");
  }

  std::string text(const toml::node& node, const std::string& name) const {
    if (!node.is_string() || (**node.as_string()).empty()) fail(node, name + " has to be a string");
    return **node.as_string();
  }

  double number(const toml::node& node, const std::string& name) const {
    if (!node.is_number()) fail(node, name + " has to be a number");
    return *node.value<double>();
  }

  const Manifest& manifest_;
  const toml::table& table_;
  std::string key_;
  CurveRecipe recipe_;
  LocatedText located_;
  std::vector<int> iterates_;
  bool image_ = false, has_manifold_ = false;
};

}  // namespace

LocatedText read_recipes(const Manifest& manifest, const toml::table& table, const std::string& key) {
  return RecipeReader(manifest, table, key).read();
}

}  // namespace lober::detail
