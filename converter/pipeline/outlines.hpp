// Solids: polygons, closed lines and round things as outlines.
#pragma once

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Rings of one polygon ready to be written: simple, the outer one counter-clockwise, holes
/// clockwise.
struct Outline {
  SimplePolygon polygon;
  bool curved = false;
};

/// The outlines of a feature's polygons and closed lines, points with a radius included. Repairs
/// what is not simple (or leaves it, without Workspace::repair) and keeps the ledger.
std::vector<Outline> outlines_of(const FeatureTask& task, Workspace& workspace);

/// Writes a feature of kind solid: each outer ring an obstacle, each hole another with `inner_of`;
/// or of kind room, which is free within: the outline clockwise, holes as solids.
void add_solid(const FeatureTask& task, Workspace& workspace);

/// The same for outlines at hand.
void add_outlines(const FeatureTask& task, const std::vector<Outline>& outlines, double height_m,
                  Workspace& workspace);

}  // namespace mapwright::converter
