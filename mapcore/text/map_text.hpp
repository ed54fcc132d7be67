// The text of a map, wherever its bytes lie.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace mapwright {

/// Whoever keeps the bytes of a text, for instance a file mapped into memory.
class TextKeeper {
 public:
  TextKeeper() = default;
  TextKeeper(const TextKeeper&) = delete;
  TextKeeper& operator=(const TextKeeper&) = delete;
  virtual ~TextKeeper() = default;

  /// The bytes from `begin` up to `end` have been read and may never be asked for again: memory
  /// that only holds a copy of them can go. They must still be there for who asks nevertheless.
  virtual void release(std::size_t /*begin*/, std::size_t /*end*/) {}
};

/// A text that does not change. A value: copies share its bytes.
class MapText {
 public:
  MapText() = default;

  MapText(std::string text) {  // NOLINT(google-explicit-constructor): a string is a text
    auto owned = std::make_shared<Owned>(std::move(text));
    bytes_ = owned->text;
    keeper_ = std::move(owned);
  }
  MapText(const char* text) : MapText(std::string(text)) {}  // NOLINT

  /// `bytes` must last as long as the keeper, and a NUL must stand behind them.
  MapText(std::string_view bytes, std::shared_ptr<TextKeeper> keeper)
      : bytes_(bytes), keeper_(std::move(keeper)) {}

  std::string_view view() const { return bytes_; }
  operator std::string_view() const { return bytes_; }  // NOLINT(google-explicit-constructor)
  std::string str() const { return std::string(bytes_); }
  std::size_t size() const { return bytes_.size(); }
  bool empty() const { return bytes_.empty(); }

  void release(std::size_t begin, std::size_t end) const {
    if (keeper_) keeper_->release(begin, end);
  }

 private:
  struct Owned : TextKeeper {
    explicit Owned(std::string all) : text(std::move(all)) {}
    std::string text;
  };

  std::string_view bytes_ = "";
  std::shared_ptr<TextKeeper> keeper_;
};

}  // namespace mapwright
