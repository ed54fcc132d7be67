// Lists that are nearly always short, of which there are millions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace mapwright::converter {

/// A list that is mostly empty, and takes one pointer then.
template <class T>
class NoneOrMore {
 public:
  void push_back(T value) {
    if (!values_) values_ = std::make_unique<std::vector<T>>();
    values_->push_back(std::move(value));
  }
  void clear() { values_.reset(); }
  bool empty() const { return !values_; }
  std::size_t size() const { return values_ ? values_->size() : 0; }
  const T* begin() const { return values_ ? values_->data() : nullptr; }
  const T* end() const { return begin() + size(); }
  const T& front() const { return values_->front(); }

 private:
  std::unique_ptr<std::vector<T>> values_;
};

/// A list of whole numbers that mostly holds one, which then lies in the list itself. It takes
/// eight bytes: twice the number and one, or the address of a vector.
class OneOrMore {
 public:
  using Number = std::int64_t;

  OneOrMore() = default;
  OneOrMore(OneOrMore&& other) noexcept : bits_(std::exchange(other.bits_, 0)) {}
  OneOrMore& operator=(OneOrMore&& other) noexcept {
    std::swap(bits_, other.bits_);
    return *this;
  }
  ~OneOrMore() { delete vector(); }

  void push_back(Number number) {
    const auto doubled = static_cast<std::uint64_t>(number) << 1U;
    if (empty() && static_cast<Number>(doubled) / 2 == number) {
      bits_ = doubled | 1U;
      return;
    }
    if (!is_vector()) {
      auto* const numbers = new std::vector<Number>();
      if (!empty()) numbers->push_back(one());
      bits_ = reinterpret_cast<std::uintptr_t>(numbers);
    }
    vector()->push_back(number);
  }
  void sort() {
    if (is_vector()) std::sort(vector()->begin(), vector()->end());
  }

  bool empty() const { return bits_ == 0; }
  std::size_t size() const { return is_vector() ? vector()->size() : (empty() ? 0 : 1); }
  Number operator[](std::size_t i) const { return is_vector() ? (*vector())[i] : one(); }
  Number front() const { return (*this)[0]; }

  class Iterator {
   public:
    Iterator(const OneOrMore& list, std::size_t i) : list_(&list), i_(i) {}
    Number operator*() const { return (*list_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return i_ != other.i_; }

   private:
    const OneOrMore* list_;
    std::size_t i_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  static_assert(sizeof(std::uintptr_t) == sizeof(std::uint64_t) && alignof(std::vector<Number>) > 1,
                "the lowest bit tells numbers from addresses");

  bool is_vector() const { return bits_ != 0 && (bits_ & 1U) == 0; }
  std::vector<Number>* vector() const {
    return is_vector() ? reinterpret_cast<std::vector<Number>*>(bits_) : nullptr;
  }
  Number one() const { return static_cast<Number>(bits_) >> 1U; }

  std::uint64_t bits_ = 0;
};

}  // namespace mapwright::converter
