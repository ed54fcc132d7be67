// Pages say what `mapwright fix` does, where it does something.
#include <gtest/gtest.h>

#include <algorithm>

#include "validators/check_pages.hpp"
#include "validators/fix/fix_map.hpp"

namespace mapwright::validators {
namespace {

TEST(FixPages, TellOfRepairsWhereThereAreSome) {
  const auto& fixable = fixable_codes();
  EXPECT_TRUE(std::is_sorted(fixable.begin(), fixable.end()));
  EXPECT_EQ(fixable.size(), 22U);
  for (const auto& type : finding_catalogue()) {
    const bool is_told = check_page(type.code).find("`mapwright fix`") != std::string_view::npos;
    EXPECT_EQ(is_told, std::binary_search(fixable.begin(), fixable.end(), type.code)) << type.id;
  }
}

}  // namespace
}  // namespace mapwright::validators
