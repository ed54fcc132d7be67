// Lists that are nearly always short, of which there are millions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
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

/// A list of whole numbers that mostly holds one, which then lies in the list itself.
template <class T>
class OneOrMore {
 public:
  void push_back(T value) {
    if (empty() && value != kNone) {
      one_ = value;
      return;
    }
    if (!values_) {
      values_ = std::make_unique<std::vector<T>>();
      if (one_ != kNone) values_->push_back(one_);
      one_ = kNone;
    }
    values_->push_back(value);
  }
  void sort() {
    if (values_) std::sort(values_->begin(), values_->end());
  }
  bool empty() const { return one_ == kNone && !values_; }
  std::size_t size() const { return values_ ? values_->size() : (one_ == kNone ? 0 : 1); }
  const T* begin() const { return values_ ? values_->data() : &one_; }
  const T* end() const { return begin() + size(); }
  const T& front() const { return *begin(); }

 private:
  static constexpr T kNone = std::numeric_limits<T>::min();  // as a value it goes to the vector

  T one_ = kNone;
  std::unique_ptr<std::vector<T>> values_;
};

}  // namespace mapwright::converter
