// Results in JSON.
#include <cmath>

#include "engine/base/json_text.hpp"
#include "engine/base/parallel/ordered_pipeline.hpp"
#include "lober/operations.hpp"

namespace lober::operations {
namespace {

using detail::append_json_number;
using detail::json_string;
using Elements = Field::Elements;

void append_part(std::string& text, double number) {
  append_json_number(text, number);
}
void append_part(std::string& text, std::int64_t number) {
  text += std::to_string(number);
}
void append_part(std::string& text, const std::string& string) {
  text += json_string(string);
}
void append_part(std::string& text, Point point) {
  text += '[';
  append_json_number(text, point.x);
  text += ',';
  append_json_number(text, point.y);
  text += ']';
}

template <typename Each>
void append_array(std::string& text, std::size_t size, const Each& each) {
  text += '[';
  for (std::size_t k = 0; k < size; ++k) {
    if (k != 0) text += ',';
    each(k);
  }
  text += ']';
}

void append_rows(std::string& text, const Matrix& matrix, double Measured::*part) {
  append_array(text, matrix.rows, [&](std::size_t i) {
    append_array(text, matrix.columns,
                 [&](std::size_t j) { append_json_number(text, matrix.entries[i * matrix.columns + j].*part); });
  });
}

bool is_known(const FieldValue& value) {
  if (const auto* point = std::get_if<Point>(&value)) return !std::isnan(point->x);
  const auto* matrix = std::get_if<Matrix>(&value);
  return matrix == nullptr || !std::isnan(matrix->entries.front().value);
}

// Names of fields need no escapes.
void append_name(std::string& text, const std::string& name, std::string_view separator, bool& first) {
  if (!first) text += separator == "\n" ? ",\n" : ",";
  first = false;
  text += '"';
  text += name;
  text += separator == "\n" ? "\": " : "\":";
}

// The members that the value of a field makes: one, two where it has a bar, or none.
void append_members(std::string& text, const Field& field, const FieldValue& value, std::string_view separator,
                    bool& first) {
  const auto named = [&](const std::string& name) { append_name(text, name, separator, first); };
  if (std::holds_alternative<std::monostate>(value) || (field.null && !is_known(value))) {
    if (!field.null) return;
    named(field.name);
    text += "null";
  } else if (const auto* measured = std::get_if<Measured>(&value)) {
    named(field.name);
    append_json_number(text, measured->value);
    named(field.bar);
    append_json_number(text, measured->error);
  } else if (const auto* matrix = std::get_if<Matrix>(&value)) {
    named(field.name);
    append_rows(text, *matrix, &Measured::value);
    if (field.bar.empty()) return;
    named(field.bar);
    append_rows(text, *matrix, &Measured::error);
  } else {
    named(field.name);
    std::visit(
        [&](const auto& any) {
          using Value = std::decay_t<decltype(any)>;
          if constexpr (std::is_same_v<Value, bool>) {
            text += any ? "true" : "false";
          } else if constexpr (requires { append_part(text, any[0]); } && !std::is_same_v<Value, std::string>) {
            append_array(text, any.size(), [&](std::size_t k) { append_part(text, any[k]); });
          } else if constexpr (requires { append_part(text, any); }) {
            append_part(text, any);
          }
        },
        value);
  }
}

// An object by `append`, or what stands for one that is not known.
template <typename Append>
void append_known(std::string& text, const Field& field, const void* whole, std::string_view separator, bool& first,
                  const Append& append) {
  bool known = false;
  field.part(whole, [&](const void* part) {
    known = true;
    append_name(text, field.name, separator, first);
    append(part);
  });
  if (known || !field.null) return;
  append_name(text, field.name, separator, first);
  text += "null";
}

void append_object(std::string& text, std::span<const Field> fields, const void* whole) {
  text += '{';
  bool first = true;
  for (const Field& field : fields) {
    if (!field.in_json) continue;
    if (field.get) {
      append_members(text, field, field.get(whole), "", first);
      continue;
    }
    if (field.part) {
      append_known(text, field, whole, "", first, [&](const void* part) { append_object(text, field.members, part); });
    } else {
      append_name(text, field.name, "", first);
      const Elements all = field.elements(whole);
      if (!all.known) {
        text += "null";
        continue;
      }
      append_array(text, all.size, [&](std::size_t k) {
        all.at(k, [&](const void* element) { append_object(text, field.members, element); });
      });
    }
  }
  text += '}';
}

// Hands on the text written so far, and goes on with lists of any length.
class Stream {
 public:
  explicit Stream(const std::function<void(std::string_view)>& write) : write_(write) {}

  void members(std::span<const Field> fields, const void* whole, std::string_view separator) {
    bool first = true;
    for (const Field& field : fields) {
      if (!field.in_json) continue;
      if (field.get) {
        append_members(text_, field, field.get(whole), separator, first);
      } else if (field.part) {
        append_known(text_, field, whole, separator, first, [&](const void* part) {
          text_ += '{';
          members(field.members, part, "");
          text_ += '}';
        });
      } else {
        append_name(text_, field.name, separator, first);
        list(field, field.elements(whole));
      }
      if (text_.size() > much) flush();
    }
  }
  void flush() {
    write_(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t much = std::size_t{1} << 20;

  void list(const Field& field, const Elements& all) {
    if (!all.known) {
      text_ += "null";
      return;
    }
    constexpr std::size_t block = 2048;
    struct Slot {
      std::size_t begin = 0, end = 0;
      std::string text;
    };
    const auto format = [&](Slot& slot) {
      slot.text.clear();
      for (std::size_t k = slot.begin; k < slot.end; ++k) {
        slot.text += k == 0 ? "\n  " : ",\n  ";
        all.at(k, [&](const void* element) { append_object(slot.text, field.members, element); });
      }
    };
    text_ += '[';
    if (all.size <= block) {
      Slot slot{0, all.size, {}};
      format(slot);
      text_ += slot.text;
    } else {
      flush();
      std::size_t next = 0;
      detail::ordered_pipeline<Slot>(
          [&](Slot& slot) {
            slot.begin = next;
            slot.end = next = std::min(all.size, next + block);
            return slot.begin < slot.end;
          },
          format, [&](const Slot& slot) { write_(slot.text); });
    }
    text_ += all.size == 0 ? "]" : "\n ]";
  }

  const std::function<void(std::string_view)>& write_;
  std::string text_;
};

}  // namespace

std::string json_object(std::span<const Field> fields, const void* whole) {
  std::string text;
  append_object(text, fields, whole);
  return text;
}

void write_json_members(std::span<const Field> fields, const void* whole,
                        const std::function<void(std::string_view)>& write) {
  Stream stream(write);
  stream.members(fields, whole, "\n");
  stream.flush();
}

std::string json_members(std::span<const Field> fields, const void* whole) {
  std::string text;
  write_json_members(fields, whole, [&](std::string_view part) { text += part; });
  return text;
}

}  // namespace lober::operations
