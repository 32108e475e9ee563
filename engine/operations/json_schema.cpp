// JSON Schema of results.
#include <array>

#include "engine/base/json_text.hpp"
#include "lober/operations.hpp"

namespace lober::operations {
namespace {

using detail::json_string;

std::string properties_of(std::span<const Field> fields);

// As json.cpp writes them.
std::string type_of(FieldKind kind) {
  static const std::array<const char*, 9> types{
      R"("type":["number","null"])",
      R"("type":"integer")",
      R"("type":"boolean")",
      R"("type":"string")",
      R"("type":"array","items":{"type":"string"})",
      R"("type":"array","items":{"type":["number","null"]})",
      R"("type":"array","items":{"type":"integer"})",
      R"("type":"array","items":{"type":["number","null"]},"minItems":2,"maxItems":2)",
      R"("type":"array","items":{"type":"array","items":{"type":["number","null"]}})"};
  return types.at(static_cast<std::size_t>(kind));
}

std::string schema_of(const Field& field) {
  const std::string about = ",\"description\":" + json_string(field.meaning);
  const std::string unit = field.unit.empty() ? "" : ",\"unit\":" + json_string(field.unit);
  std::string type;
  switch (field.kind) {
    case FieldKind::object:
      type = properties_of(field.members);
      break;
    case FieldKind::list:
      type = R"("type":"array","items":{)" + properties_of(field.members) + "}";
      break;
    case FieldKind::points:
      type = R"("type":"array","items":{)" + type_of(FieldKind::point) + "}";
      break;
    default:
      type = type_of(field.kind);
  }
  if (field.null) type = R"("anyOf":[{)" + type + R"(},{"type":"null"}])";
  return "{" + type + about + unit + "}";
}

std::string properties_of(std::span<const Field> fields) {
  std::string text;
  const auto add = [&](const std::string& name, const std::string& schema) {
    text += (text.empty() ? "" : ",") + json_string(name) + ":" + schema;
  };
  for (const Field& field : fields) {
    if (!field.in_json) continue;
    add(field.name, schema_of(field));
    if (field.bar.empty()) continue;
    Field bar = field;
    bar.meaning = "error bar of " + field.name;
    add(field.bar, schema_of(bar));
  }
  return R"("type":"object","properties":{)" + text + "}";
}

}  // namespace

std::string json_schema(std::span<const Field> fields) {
  return "{" + properties_of(fields) + "}";
}

}  // namespace lober::operations
