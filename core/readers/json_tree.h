// SPDX-License-Identifier: MIT
// A JSON document whose values know their lines, which nlohmann-json's own do not.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::mesh_files {

enum class JsonType { Null, Boolean, Number, String, Array, Object };

struct JsonValue {
  JsonType type = JsonType::Null;
  std::size_t line = 0;  ///< that it begins in; of numbers and words that end a line it may be the next one
  double number = 0;
  std::string string = {};
  std::vector<JsonValue> items = {};   ///< of arrays and objects
  std::vector<std::string> keys = {};  ///< one an item, of objects

  /// The item of that key; null where there is none.
  const JsonValue* find(std::string_view key) const;
};

/// Why a text is no JSON, or none that is taken: `line` counts from 1.
struct JsonFault {
  std::size_t line;
  std::string reason;
};

/// \throws JsonFault for malformed JSON, numbers beyond the range of double, a key that occurs twice in an object, and
/// values nested more than 100 deep
JsonValue parse_json_tree(std::string_view text);

}  // namespace cageproof::mesh_files
