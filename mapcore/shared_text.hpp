// Bytes that many values share.
#pragma once

#include <array>
#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <string_view>
#include <utility>

#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>
#endif

namespace mapwright {

/// A text that copies share and that ends with the last of them: like shared_ptr<const string>, but
/// seven bytes long, since a map of millions of segments holds millions of them, and each has one
/// byte beside it (decisions/0096). Copies may be made and destroyed in any thread.
class SharedText {
 public:
  SharedText() = default;
  explicit SharedText(std::string_view text) : address_(text.empty() ? nullptr : block_of(text)) {}
  SharedText(const SharedText& other) noexcept : address_(other.address_) {
    if (Block* const block = address_.block()) add_holder(*block);
  }
  SharedText(SharedText&& other) noexcept : address_(std::exchange(other.address_, Address())) {}
  SharedText& operator=(SharedText other) noexcept {
    std::swap(address_, other.address_);
    return *this;
  }
  ~SharedText() {
    Block* const block = address_.block();
    if (block != nullptr && is_last_holder(*block)) destroy(block);
  }

  /// The same bytes at the same place for all copies; empty, from nowhere, for an empty text.
  std::string_view view() const {
    const Block* const block = address_.block();
    return block == nullptr ? std::string_view() : std::string_view(bytes(block), block->size);
  }
  bool empty() const { return address_.block() == nullptr; }

  /// True if both are copies of one text, or empty; equal texts need not be.
  bool is_shared_with(const SharedText& other) const {
    return address_.block() == other.address_.block();
  }

 private:
  /// The bytes lie behind it.
  struct Block {
    std::atomic<std::size_t> holders{1};
    std::size_t size = 0;
  };

  /// Where a block lies, without the highest byte of the address: no process has memory so high.
  class Address {
   public:
    Address() = default;
    explicit Address(Block* block) {
      const auto address = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(block));
      assert(address >> 56U == 0);
      const auto low = static_cast<std::uint32_t>(address);
      const auto middle = static_cast<std::uint16_t>(address >> 32U);
      std::memcpy(bytes_.data(), &low, sizeof low);
      std::memcpy(bytes_.data() + 4, &middle, sizeof middle);
      bytes_[6] = static_cast<unsigned char>(address >> 48U);
    }

    Block* block() const {
      std::uint32_t low = 0;
      std::uint16_t middle = 0;
      std::memcpy(&low, bytes_.data(), sizeof low);
      std::memcpy(&middle, bytes_.data() + 4, sizeof middle);
      const std::uint64_t address =
          low | std::uint64_t{middle} << 32U | std::uint64_t{bytes_[6]} << 48U;
      return reinterpret_cast<Block*>(static_cast<std::uintptr_t>(address));
    }

   private:
    std::array<unsigned char, 7> bytes_{};
  };

  static const char* bytes(const Block* block) { return reinterpret_cast<const char*>(block + 1); }

  static Block* block_of(std::string_view text) {
    auto* const block = new (::operator new(sizeof(Block) + text.size())) Block;
    block->size = text.size();
    std::memcpy(reinterpret_cast<char*>(block + 1), text.data(), text.size());
    return block;
  }

  static void destroy(Block* block) {
    block->~Block();
    ::operator delete(block);
  }

  // Counting without a locked instruction is several times as fast; the C library knows when that
  // is safe (shared_ptr asks it too).
  static bool is_single_threaded() {
#if __has_include(<sys/single_threaded.h>)
    return __libc_single_threaded != 0;
#else
    return false;
#endif
  }

  static void add_holder(Block& block) noexcept {
    constexpr auto kRelaxed = std::memory_order_relaxed;
    if (is_single_threaded()) {
      block.holders.store(block.holders.load(kRelaxed) + 1, kRelaxed);
    } else {
      block.holders.fetch_add(1, kRelaxed);
    }
  }

  static bool is_last_holder(Block& block) noexcept {
    constexpr auto kRelaxed = std::memory_order_relaxed;
    if (!is_single_threaded()) return block.holders.fetch_sub(1, std::memory_order_acq_rel) == 1;
    const std::size_t left = block.holders.load(kRelaxed) - 1;
    block.holders.store(left, kRelaxed);
    return left == 0;
  }

  Address address_;
};

}  // namespace mapwright
