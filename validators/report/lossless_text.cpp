#include "validators/report/lossless_text.hpp"

#include <string_view>

namespace mapwright::validators {
namespace {

using Json = nlohmann::ordered_json;

std::string hex(std::string_view bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

std::string from_hex(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(text.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

}  // namespace

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void put_text(Json& json, const std::string& key, const std::string& text) {
  const auto readable = Json::parse(dumped(text)).get<std::string>();
  json[key] = readable;
  if (readable != text) json[key + "_bytes"] = hex(text);
}

std::string get_text(const Json& json, const std::string& key) {
  const auto bytes = json.find(key + "_bytes");
  return bytes != json.end() ? from_hex(bytes->get<std::string>())
                             : json.at(key).get<std::string>();
}

}  // namespace mapwright::validators
