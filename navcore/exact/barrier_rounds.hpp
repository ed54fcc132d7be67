// Private to this folder: a barrier among given rounds of sites.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "navcore/exact/barrier.hpp"
#include "navcore/exact/medial_rounds.hpp"

namespace mapwright::navcore::exact {

/// find_barrier (barrier.hpp) among rounds of sites, each of which is near to the next.
std::optional<Barrier> find_barrier(const Tessellation& base, const std::vector<SiteRound>& rounds,
                                    const BarrierEnd& start, const BarrierEnd& goal,
                                    std::int64_t radius_nm);

}  // namespace mapwright::navcore::exact
