// Private to this folder: the short way for the solids that most drawings consist of.
#pragma once

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Adds a feature that is one sound outline without holes, straight to Workspace::plain. False,
/// with nothing done, for everything else: what `add_solid` makes of it, it makes with words.
bool add_simple_solid(const FeatureTask& task, Workspace& workspace);

}  // namespace mapwright::converter
