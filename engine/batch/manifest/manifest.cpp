// One class reads a manifest, and its file is a little longer than others for that: all keys share one place for
// errors.
#include "engine/batch/manifest/manifest.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <span>

#include "engine/base/even_values.hpp"
#include "engine/base/file_bytes.hpp"
#include "engine/base/nearest_word.hpp"
#include "engine/batch/manifest/recipe_reader.hpp"
#include "lober/curve/cylinders.hpp"

namespace lober::detail {
namespace {

std::size_t line_of(const toml::node& node) {
  return node.source().begin.line;
}

class Reader {
 public:
  explicit Reader(Manifest& manifest) : manifest_(manifest) {}

  void read(const toml::table& top) {
    const toml::node* const groups = top.get("group");
    if (groups == nullptr) {
      check_keys(top, true);
      read_group(top, top);
      return;
    }
    if (!groups->is_array_of_tables()) fail(*groups, "group", "has to be written [[group]]");
    check_keys(top, true);
    for (const toml::node& group : *groups->as_array()) {
      check_keys(*group.as_table(), false);
      read_group(*group.as_table(), top);
    }
  }

 private:
  [[noreturn]] void fail(const toml::node& node, const std::string& key, const std::string& message) const {
    manifest_.fail(line_of(node), key, message);
  }

  void check_keys(const toml::table& table, bool is_top) const {
    const std::vector<std::string> known{"name",     "operation", "curves",  "with", "closed",
                                         "periodic", "pairs",     "options", "grid", "group"};
    const std::span<const std::string> in_groups(known.data(), known.size() - 1);
    for (const auto& [name, node] : table) {
      const std::string key(name.str());
      if (std::find(known.begin(), known.end(), key) != known.end() && (is_top || key != "group")) continue;
      fail(node, key,
           "there is no such key; there are " + joined(in_groups) + " and [[group]]" + did_you_mean(key, known));
    }
  }

  // The value of a key: of the group, or else of the top.
  static const toml::node* find(const toml::table& group, const toml::table& top, std::string_view key) {
    const toml::node* const own = group.get(key);
    return own != nullptr ? own : top.get(key);
  }

  std::string text_of(const toml::node& node, const std::string& key) const {
    if (!node.is_string()) fail(node, key, "has to be a string");
    return **node.as_string();
  }

  void read_group(const toml::table& table, const toml::table& top) {
    ManifestGroup group;
    const toml::node* const name = find(table, top, "name");
    group.name = name != nullptr ? text_of(*name, "name") : "";
    read_operation(group, table, top);
    group.closed = !group.operation->open;
    if (const toml::node* const closed = find(table, top, "closed")) {
      if (!closed->is_boolean()) fail(*closed, "closed", "has to be true or false");
      group.closed = **closed->as_boolean();
      if (group.closed && group.operation->open) fail(*closed, "closed", group.operation->name + " takes open curves");
    }
    read_periods(group, table, top);
    group.curves = patterns(table, top, "curves");
    group.with = patterns(table, top, "with");
    read_pairs(group, table, top);
    read_options(group, table, top);
    if (group.operation->arity == Arity::none) {
      for (const char* const key : {"curves", "with", "pairs", "closed", "periodic"}) {
        if (const toml::node* const useless = table.get(key))
          fail(*useless, key, group.operation->name + " has no curves");
      }
      group.pairs = PairKind::none;
    } else if (group.pairs != PairKind::list && group.curves.empty())
      fail(table, "curves", "is missing");
    manifest_.groups.push_back(std::move(group));
  }

  // "x=2pi", or ["x=2pi", "y=1"], as --periodic takes them.
  void read_periods(ManifestGroup& group, const toml::table& table, const toml::table& top) const {
    const toml::node* const node = find(table, top, "periodic");
    if (node == nullptr) return;
    const auto take = [&](const toml::node& one) {
      if (one.is_string() && take_period(**one.as_string(), group.periods)) return;
      fail(one, "periodic", "has to be \"x=PERIOD\" or \"y=PERIOD\", such as \"x=2pi\", or a list of both");
    };
    if (!node->is_array()) return take(*node);
    for (const toml::node& one : *node->as_array()) take(one);
  }

  void read_operation(ManifestGroup& group, const toml::table& table, const toml::table& top) const {
    const toml::node* const node = find(table, top, "operation");
    if (node == nullptr) fail(table, "operation", "is missing");
    const std::string name = text_of(*node, "operation");
    group.operation = find_operation(name);
    if (group.operation != nullptr) return;
    std::vector<std::string> known;
    for (const Operation& any : all_operations()) known.push_back(any.name);
    fail(*node, "operation",
         "there is no operation \"" + name + "\" in this version; there are " + joined(known) +
             did_you_mean(name, known));
  }

  std::vector<LocatedText> patterns(const toml::table& table, const toml::table& top, const std::string& key) const {
    const toml::node* const node = find(table, top, key);
    if (node == nullptr) return {};
    if (!node->is_array()) return {pattern(*node, key)};
    if (node->as_array()->empty()) fail(*node, key, "has to be a pattern or a list of patterns");
    std::vector<LocatedText> all;
    for (const toml::node& one : *node->as_array()) all.push_back(pattern(one, key));
    return all;
  }

  LocatedText pattern(const toml::node& node, const std::string& key) const {
    if (node.is_string()) return {**node.as_string(), line_of(node), key};
    if (!node.is_table()) fail(node, key, "has to be a pattern, a curve of a system, or a list of such");
    return read_recipes(manifest_, *node.as_table(), key);
  }

  void read_pairs(ManifestGroup& group, const toml::table& table, const toml::table& top) const {
    const toml::node* const node = find(table, top, "pairs");
    const bool of_two = group.operation->arity == Arity::two;
    group.pairs = !of_two ? PairKind::single : group.with.empty() ? PairKind::all : PairKind::product;
    if (group.operation->arity == Arity::none) return;
    if (node == nullptr) {
      if (!of_two && table.contains("with")) fail(*table.get("with"), "with", "goes with pairs = \"product\" only");
      return;
    }
    if (const auto* const text = node->as_string()) {
      read_pair_word(group, *node, **text);
    } else if (const auto* const lag = node->as_table()) {
      const toml::node* const steps = lag->get("lag");
      if (steps == nullptr || lag->size() != 1 || !steps->is_integer() || **steps->as_integer() < 1) {
        fail(*node, "pairs", "as a table it has to be { lag = k } with k at least 1");
      }
      group.pairs = PairKind::lag;
      group.lag = static_cast<std::size_t>(**steps->as_integer());
    } else if (node->is_array()) {
      group.pairs = PairKind::list;
      for (const toml::node& one : *node->as_array()) {
        const toml::array* const two = one.as_array();
        if (two == nullptr || two->size() != 2) fail(one, "pairs", "each pair has to be two names [\"a\", \"b\"]");
        group.list.push_back({pattern((*two)[0], "pairs"), pattern((*two)[1], "pairs")});
      }
    } else {
      fail(*node, "pairs", "has to be a string, { lag = k } or a list of pairs");
    }
    const bool two = group.pairs != PairKind::single;
    if (!takes(group.operation->arity, two ? 2 : 1)) {
      fail(*node, "pairs", group.operation->name + (two ? " takes one curve" : " takes two curves"));
    }
    if (group.pairs == PairKind::product && group.with.empty()) {
      fail(*node, "pairs", "\"product\" needs the second set, with = ...");
    }
    if (group.pairs != PairKind::product && table.contains("with")) {
      fail(*table.get("with"), "with", "goes with pairs = \"product\" only");
    }
  }

  void read_pair_word(ManifestGroup& group, const toml::node& node, const std::string& word) const {
    if (word == "all") {
      group.pairs = PairKind::all;
    } else if (word == "consecutive") {
      group.pairs = PairKind::lag;
      group.lag = 1;
    } else if (word == "product") {
      group.pairs = PairKind::product;
    } else if (word == "single") {
      group.pairs = PairKind::single;
    } else {
      const std::vector<std::string> known{"all", "consecutive", "product", "single"};
      fail(node, "pairs",
           "\"" + word + "\" cannot be read as pairs; give " + joined(known) + ", { lag = k } or a list of pairs" +
               did_you_mean(word, known));
    }
  }

  OptionValue value_of(const toml::node& node, const std::string& key) const {
    if (node.is_boolean()) return **node.as_boolean();
    if (node.is_integer()) return std::int64_t{**node.as_integer()};
    if (node.is_floating_point()) return **node.as_floating_point();
    if (node.is_string()) return **node.as_string();
    std::vector<double> numbers;
    for (const toml::array* const list = node.as_array(); list != nullptr && numbers.size() < list->size();) {
      const auto number = list->get(numbers.size())->value<double>();
      if (!number) break;
      numbers.push_back(*number);
      if (numbers.size() == list->size()) return numbers;
    }
    fail(node, key, "has to be true, false, a number, a string or a list of numbers, as a point [x, y]");
  }

  const toml::table* subtable(const toml::table& table, std::string_view key) const {
    const toml::node* const node = table.get(key);
    if (node != nullptr && !node->is_table()) fail(*node, std::string(key), "has to be a table");
    return node != nullptr ? node->as_table() : nullptr;
  }

  // Options at the top are for those operations that know them, and some group's has to.
  void read_options(ManifestGroup& group, const toml::table& table, const toml::table& top) {
    std::vector<OptionSetting> settings;
    const auto known = [&](std::string_view key) {
      const std::vector<OptionSpec>& specs = group.operation->options;
      return std::any_of(specs.begin(), specs.end(), [&](const OptionSpec& spec) { return spec.is_for(key); });
    };
    const auto take = [&](const std::string& key, const toml::node& node, bool only_known) {
      if (only_known && !known(key) && is_known_to_some(key)) return;
      settings.push_back({key, value_of(node, key)});
      (void)checked(group, {settings.back()}, node);
    };
    const bool grouped = &table != &top;
    if (grouped) {
      if (const toml::table* const options = subtable(top, "options")) {
        each_entry(*options, "", [&](const std::string& key, const toml::node& node) { take(key, node, true); });
      }
    }
    if (const toml::table* const options = subtable(table, "options")) {
      each_entry(*options, "", [&](const std::string& key, const toml::node& node) { take(key, node, false); });
    }
    std::vector<std::vector<OptionSetting>> rounds{settings};
    if (const toml::node* const node = find(table, top, "grid")) {
      if (!node->is_table()) fail(*node, "grid", "has to be a table of lists");
      each_entry(*node->as_table(), "",
                 [&](const std::string& key, const toml::node& list) { rounds = combined(group, rounds, key, list); });
    }
    for (const std::vector<OptionSetting>& round : rounds) {
      group.options.push_back(checked(group, round, table));
      if (group.operation->check) explained(table, [&] { group.operation->check(group.options.back()); });
    }
  }

  // Entries of a table, those of tables in it by "table.key".
  static void each_entry(const toml::table& table, const std::string& prefix,
                         const std::function<void(const std::string&, const toml::node&)>& take) {
    for (const auto& [key, node] : table) {
      const std::string name = prefix + std::string(key.str());
      if (node.is_table()) {
        each_entry(*node.as_table(), name + ".", take);
      } else {
        take(name, node);
      }
    }
  }

  static bool is_known_to_some(std::string_view key) {
    const std::span<const Operation> all = all_operations();
    return std::any_of(all.begin(), all.end(), [&](const Operation& any) {
      return std::any_of(any.options.begin(), any.options.end(),
                         [&](const OptionSpec& spec) { return spec.is_for(key); });
    });
  }

  // Each round once for each value of the list.
  std::vector<std::vector<OptionSetting>> combined(const ManifestGroup& group,
                                                   const std::vector<std::vector<OptionSetting>>& rounds,
                                                   const std::string& key, const toml::node& list) const {
    std::vector<OptionSetting> settings;
    if (list.is_string()) {
      for (const OptionValue& value : range_of(list, "grid." + key)) {
        settings.push_back({key, value});
        (void)checked(group, {settings.back()}, list);
      }
    } else {
      if (!list.is_array() || list.as_array()->empty()) fail(list, "grid." + key, grid_form);
      for (const toml::node& node : *list.as_array()) {
        settings.push_back({key, value_of(node, "grid." + key)});
        (void)checked(group, {settings.back()}, node);
      }
    }
    std::vector<std::vector<OptionSetting>> all;
    for (const std::vector<OptionSetting>& round : rounds) {
      for (const OptionSetting& setting : settings) {
        all.push_back(round);
        all.back().push_back(setting);
      }
    }
    return all;
  }

  // The values of "FIRST:LAST:STEP": whole numbers if all three are spelled so.
  std::vector<OptionValue> range_of(const toml::node& node, const std::string& key) const {
    std::vector<double> numbers;
    const std::string text = **node.as_string();
    const char* at = text.data();
    const char* const end = at + text.size();
    while (numbers.size() < 3 && at <= end) {
      double number = 0;
      const auto [stop, error] = std::from_chars(at, end, number);
      if (error != std::errc{} || !std::isfinite(number) || (stop != end && *stop != ':')) break;
      numbers.push_back(number);
      at = stop + 1;
    }
    if (numbers.size() != 3 || at != end + 1) fail(node, key, grid_form);
    const auto values = even_values(numbers[0], numbers[1], numbers[2]);
    if (!values) fail(node, key, "needs a step that leads from the first value to the last in at most 100000 values");
    if (values->size() == 1) {
      fail(node, key, "stands for one value, since its step is longer than the range; the third number is the step");
    }
    const bool are_whole = text.find_first_not_of("+-0123456789:") == std::string::npos;
    std::vector<OptionValue> all;
    for (const double value : *values) {
      are_whole ? all.emplace_back(static_cast<std::int64_t>(value)) : all.emplace_back(value);
    }
    return all;
  }

  static constexpr const char* grid_form = "has to be a list of values, or a range \"FIRST:LAST:STEP\"";

  Options checked(const ManifestGroup& group, const std::vector<OptionSetting>& settings,
                  const toml::node& node) const {
    Options options;
    explained(node, [&] { options = job_options(*group.operation, settings); });
    return options;
  }

  // Says where an option stands: "key: message", or a message that names options as option "key".
  void explained(const toml::node& node, const std::function<void()>& function) const {
    try {
      function();
    } catch (const UsageError& error) {
      std::string text = error.what();
      const std::size_t colon = text.find(": ");
      if (colon < text.find(' '))
        manifest_.fail(line_of(node), "options." + text.substr(0, colon), text.substr(colon + 2));
      const std::string_view word = "option \"";
      for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at)) text.erase(at, word.size() - 1);
      manifest_.fail(line_of(node), "options", text);
    }
  }

  Manifest& manifest_;
};

}  // namespace

void Manifest::fail(std::size_t line, const std::string& key, const std::string& message) const {
  throw UsageError(path + ":" + std::to_string(line) + ": " + key + ": " + message);
}

Manifest read_manifest(const std::string& path) {
  const FileBytes file(path);
  return parse_manifest({reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()}, path);
}

Manifest parse_manifest(std::string text, const std::string& path) {
  Manifest manifest;
  manifest.path = path;
  manifest.text = std::move(text);
  toml::table top;
  try {
    top = toml::parse(manifest.text);
  } catch (const toml::parse_error& error) {
    throw UsageError(path + ":" + std::to_string(error.source().begin.line) + ": " + std::string(error.description()));
  }
  Reader(manifest).read(top);
  return manifest;
}

}  // namespace lober::detail
