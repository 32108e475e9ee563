#include "engine/batch/record.hpp"

#include "engine/batch/bytes.hpp"

namespace lober {

std::string encode(const Record& record) {
  ByteWriter writer;
  writer.put_all(record.values);
  writer.put(static_cast<std::uint64_t>(record.lists.size()));
  for (const std::vector<double>& list : record.lists) writer.put_all(list);
  return writer.take();
}

Record decode(std::string_view bytes) {
  ByteReader reader(bytes);
  Record record;
  record.values = reader.get_all<double>();
  for (std::size_t lists = reader.get_count(); lists > 0; --lists) record.lists.push_back(reader.get_all<double>());
  if (!reader.at_end()) throw DataError("the stored bytes go on behind their end");
  return record;
}

}  // namespace lober
