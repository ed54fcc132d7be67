// Many queries in a file.
#pragma once

#include <string>
#include <vector>

#include "cli/plan/places.hpp"

namespace mapwright::cli {

/// Reads a CSV file of queries ("-": standard input): columns start_x, start_y, goal_x, goal_y in
/// metres, or start and goal with names of places, or both: a row whose name is empty takes the
/// numbers. Without heading, rows of four numbers or of two names. Throws Error (kInput).
std::vector<StartAndGoal> read_queries(const std::string& path);

}  // namespace mapwright::cli
