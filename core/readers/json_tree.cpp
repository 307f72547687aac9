// SPDX-License-Identifier: MIT
#include "json_tree.h"

#include "cage/mesh_files.h"

#include <fmt/format.h>
#include <boost/iterator/iterator_adaptor.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <unordered_set>

namespace cageproof::mesh_files {
namespace {

using Json = nlohmann::json;
// Counts the lines that the parser has passed. Only steps count them: of an iterator that could jump, std::advance
// would jump by one in a build without optimisation.
class CountingIterator : public boost::iterators::iterator_adaptor<CountingIterator, const char*, boost::use_default,
                                                                   boost::iterators::forward_traversal_tag> {
 public:
  CountingIterator(const char* at, std::size_t& line) : iterator_adaptor_(at), line_(&line) {}

 private:
  friend class boost::iterators::iterator_core_access;
  void increment() {
    if (*base_reference()++ == '\n') ++*line_;
  }

  std::size_t* line_;
};

class TreeBuilder {
 public:
  explicit TreeBuilder(const std::size_t& line) : line_(line) {}

  bool null() { return put({JsonType::Null, line_}); }
  bool boolean(bool) { return put({JsonType::Boolean, line_}); }
  bool number_integer(Json::number_integer_t value) {
    return put({JsonType::Number, line_, static_cast<double>(value)});
  }
  bool number_unsigned(Json::number_unsigned_t value) {
    return put({JsonType::Number, line_, static_cast<double>(value)});
  }
  bool number_float(Json::number_float_t value, const std::string&) { return put({JsonType::Number, line_, value}); }
  bool string(std::string& value) { return put({JsonType::String, line_, 0, std::move(value)}); }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(JsonType::Object); }
  bool start_array(std::size_t) { return open(JsonType::Array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    if (!keys_.back().insert(name).second) throw JsonFault{line_, fmt::format("the key {} occurs twice", shown(name))};
    open_.back()->keys.push_back(std::move(name));
    return true;
  }
  bool parse_error(std::size_t, const std::string& token, const nlohmann::detail::exception& reason) {
    constexpr int number_overflow = 406;  // nlohmann's number of that error
    throw JsonFault{line_, reason.id == number_overflow
                               ? fmt::format("the number {} is beyond the range of double", shown(token))
                               : fmt::format("malformed JSON at {}", shown(token))};
  }

  JsonValue root;

 private:
  JsonValue* add(JsonValue value) {
    if (open_.empty()) {
      root = std::move(value);
      return &root;
    }
    return &open_.back()->items.emplace_back(std::move(value));
  }
  bool put(JsonValue value) {
    add(std::move(value));
    return true;
  }
  bool open(JsonType type) {
    constexpr std::size_t deepest = 100;
    if (open_.size() == deepest) throw JsonFault{line_, fmt::format("nested more than {} deep", deepest)};
    // An open item is the last one of its parent, so it does not move while it is open.
    open_.push_back(add({type, line_}));
    keys_.emplace_back();
    return true;
  }
  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  const std::size_t& line_;
  std::vector<JsonValue*> open_;
  std::vector<std::unordered_set<std::string>> keys_;  // of each that is open
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  const auto found = std::ranges::find(keys, key);
  return type == JsonType::Object && found != keys.end() ? &items[found - keys.begin()] : nullptr;
}

JsonValue parse_json_tree(std::string_view text) {
  std::size_t line = 1;
  TreeBuilder builder(line);
  Json::sax_parse(CountingIterator(text.data(), line), CountingIterator(text.data() + text.size(), line), &builder);
  return std::move(builder.root);
}

}  // namespace cageproof::mesh_files
