// Parts of a map put together again, and maps side by side.
#pragma once

#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/result.hpp"

namespace mapwright {

/// Which of two versions of an obstacle counts.
enum class MergePreference { kNone, kFirst, kLast };

struct MergePart {
  std::string name;  ///< what messages call it
  Map map;
};

struct Merged {
  Map map;
  std::vector<std::string> notes;  ///< ids that had to change, versions that were passed over
};

/// One map of all parts. The border is the smallest box around theirs.
///
/// An obstacle that several parts have, the same to the last bit, is taken once. Two with the same
/// id that share a segment's place are versions of one obstacle: without preference that fails
/// (kUsage), naming both. Two with the same id and no place in common are strangers: the later
/// part's gets the next free id, and `inner_of` of its holes follows.
///
/// Pieces of obstacles that `crop` cut become the whole obstacle again. Pieces that were changed
/// since, or whose part has another border than it was cut at, are no pieces of it any more: that
/// fails (kUsage) and names them.
///
/// Order: as in the parts, obstacles that no part orders by their ids. So the parts of a map whose
/// ids ascend, as those that `convert` makes, give that map again: whole obstacles or cut ones,
/// together covering it.
Result<Merged> merge(std::vector<MergePart> parts,
                     MergePreference preference = MergePreference::kNone);

}  // namespace mapwright
