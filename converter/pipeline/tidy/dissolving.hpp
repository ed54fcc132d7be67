// Touching buildings made one outline, on request (--dissolve).
#pragma once

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Unites solids that overlap or share a piece of wall, and have the same height and side (indoor
/// or outdoor): what lies within is no wall that a robot can meet. The union keeps the labels that
/// all of them have. Solids that meet at single points stay apart. The ledger says which features
/// went together (C252).
void dissolve_solids(Workspace& workspace);

}  // namespace mapwright::converter
