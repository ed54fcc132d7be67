// Many maps through the gate.
#pragma once

#include <functional>
#include <vector>

#include "cli/check/journal.hpp"
#include "cli/support/console.hpp"
#include "cli/support/map_list.hpp"
#include "cli/support/worker_pool.hpp"
#include "validators/report/map_record.hpp"

namespace mapwright::cli {

struct Batch {
  std::vector<MapInput> maps;
  /// Checks one map with up to so many threads; called in a process of its own.
  std::function<validators::MapRecord(const MapInput&, unsigned threads)> check;
  WorkerLimits limits;
  unsigned jobs = 1;  ///< maps at once; 0: one a core
};

/// Checks each map in a process of its own and hands the records on in the order of the maps. Maps
/// that the journal (may be null) knows are not checked again; the others are added to it.
void check_batch(const Batch& batch, Journal* journal, Console& console,
                 const std::function<void(const validators::MapRecord&)>& take);

}  // namespace mapwright::cli
