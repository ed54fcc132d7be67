// What other verbs' JSON answers look like on a map.
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "converter/exporters/picture.hpp"

namespace mapwright::cli {

/// A JSON answer read from a file.
class Answer {
 public:
  /// Reads and parses. Throws Error (kInput): unreadable, not JSON, no "schema" that can be drawn.
  explicit Answer(std::string path);
  Answer(Answer&&) noexcept;
  ~Answer();

  /// Number of localization iterations it holds particles of; 0 for other answers.
  std::size_t iterations() const;

  /// Adds what it shows. `iteration` (from 1) chooses among localization iterations; nothing: the
  /// last. Throws Error (kInput) where the answer does not hold what its schema promises.
  void draw(converter::Overlay& overlay, std::optional<std::size_t> iteration) const;

 private:
  std::string path_;
  std::unique_ptr<nlohmann::ordered_json> json_;
};

}  // namespace mapwright::cli
