// Private to this folder: Texts of any bytes in JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mapwright::validators {

/// On one line; bytes that are not UTF-8 become U+FFFD.
std::string dumped(const nlohmann::ordered_json& json);

/// Sets `json[key]`. JSON holds UTF-8 only: beside a text that is none the same stands in
/// hexadecimal digits, under the key with "_bytes" behind it.
void put_text(nlohmann::ordered_json& json, const std::string& key, const std::string& text);

/// The text that was put. Throws an exception of nlohmann::json where there is none.
std::string get_text(const nlohmann::ordered_json& json, const std::string& key);

}  // namespace mapwright::validators
