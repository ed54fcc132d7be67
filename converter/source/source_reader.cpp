#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

Result<std::size_t> SourceReader::read_into(std::size_t layer, const ReadOptions& options,
                                            FeatureSink& sink) {
  return read(layer, options, [&](SourceFeature& feature) { sink.add(feature); });
}

}  // namespace mapwright::converter
