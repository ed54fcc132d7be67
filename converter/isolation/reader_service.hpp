// Private to this folder: what parent and child say to each other about a source.
#pragma once

#include "converter/isolation/child_process.hpp"
#include "converter/isolation/isolated_reader.hpp"
#include "converter/isolation/shared_batches.hpp"

namespace mapwright::converter {

/// Kinds of frames. The parent asks for extents and layers; the child answers.
enum class Word : std::uint8_t {
  kDriver,    ///< child: the name of the driver that opens the source now
  kOpened,    ///< child: driver, layers
  kFailure,   ///< child: a Failure, in place of any answer
  kExtent,    ///< parent: layer; child: whether there is one, and the box
  kRead,      ///< parent: layer, ReadOptions
  kFeatures,  ///< child: features, one after the other, until the bytes end
  kSlot,      ///< child: a FilledSlot with features; parent: its number, once it is read
  kDone,      ///< child: number of features read
  kWarnings,  ///< child: texts, before kOpened and kDone
};

/// The child's side: opens the source and answers until the parent hangs up. `batches` may be null.
void serve_reader(const Line& line, const SharedBatches* batches, const ReaderOpener& open);

}  // namespace mapwright::converter
