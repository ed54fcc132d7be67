// The scan engine on every instruction set of the machine.
#pragma once

#include <string>

#include "navcore/engine/scan_engine.hpp"

namespace mapwright::test {

/// Calls `check(engine)` with an engine of the map for each instruction set.
template <class Check>
void on_each_instruction_set(const Map& map, Check&& check,
                             navcore::ScanEngineOptions options = {}) {
  for (const auto name : navcore::ScanEngine::instruction_sets()) {
    SCOPED_TRACE(std::string(name));
    options.instruction_set = std::string(name);
    check(navcore::ScanEngine(map, options));
  }
}

}  // namespace mapwright::test
