// A keeper of a text that tells what was let go.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>

#include "mapcore/text/map_text.hpp"

namespace mapwright::test {

class Keeper : public TextKeeper {
 public:
  void release(std::size_t begin, std::size_t end) override {
    EXPECT_EQ(begin, released);
    released = end;
  }
  std::size_t released = 0;
};

}  // namespace mapwright::test
