// Walls that lie on outlines or on the border: which side of theirs is free.
#pragma once

#include "validators/check.hpp"

namespace mapwright::validators {

/// Reports (G107, as a warning) each segment of an open wall that lies wholly on an outline or on
/// the border and has its free side where they have none. Where outlines meet along a wall, neither
/// side is free and its direction says nothing.
void check_leaning_walls(const CheckContext& context, FindingSink& sink);

}  // namespace mapwright::validators
