#include "converter/isolation/reader_service.hpp"

#include <new>

#include "converter/isolation/wire.hpp"

namespace mapwright::converter {
namespace {

constexpr std::size_t kBatchBytes = 1 << 16U;

class Service {
 public:
  explicit Service(const Line& line) : line_(line) {}

  void run(const ReaderOpener& open) {
    auto reader = open([this](const std::string& driver) { say(Word::kDriver, driver); });
    if (!reader) return say(Word::kFailure, reader.error());
    reader_ = *std::move(reader);
    say(Word::kWarnings, reader_->take_warnings());
    wire_.clear();
    wire_.put(reader_->driver());
    put(wire_, reader_->layers());
    flush(Word::kOpened);
    Frame request;
    while (line_.receive(request)) answer(request);
  }

  void fail(const Failure& failure) { say(Word::kFailure, failure); }

 private:
  void answer(const Frame& request) {
    WireReader wire(request.bytes.data(), request.bytes.size());
    std::uint64_t layer = 0;
    wire.get(layer);
    if (static_cast<Word>(request.kind) == Word::kExtent) return answer_extent(layer);
    ReadOptions options;
    get(wire, options);
    answer_read(layer, options);
  }

  void answer_extent(std::uint64_t layer) {
    const auto box = reader_->extent(layer);
    if (!box) return say(Word::kFailure, box.error());
    wire_.clear();
    wire_.put(box->has_value());
    wire_.put(box->value_or(Box{}));
    flush(Word::kExtent);
  }

  void answer_read(std::uint64_t layer, const ReadOptions& options) {
    wire_.clear();
    const auto count = reader_->read(layer, options, [this](SourceFeature& feature) {
      put(wire_, feature);
      if (wire_.bytes().size() >= kBatchBytes) flush(Word::kFeatures);
    });
    if (!wire_.bytes().empty()) flush(Word::kFeatures);
    say(Word::kWarnings, reader_->take_warnings());
    if (!count) return say(Word::kFailure, count.error());
    wire_.clear();
    wire_.put(static_cast<std::uint64_t>(*count));
    flush(Word::kDone);
  }

  template <class T>
  void say(Word word, const T& value) {
    wire_.clear();
    put_any(value);
    flush(word);
  }
  void put_any(const Failure& failure) { put(wire_, failure); }
  template <class T>
  void put_any(const T& value) {
    wire_.put(value);
  }

  void flush(Word word) {
    line_.send(static_cast<std::uint8_t>(word), wire_.bytes());
    wire_.clear();
  }

  const Line& line_;
  WireWriter wire_;
  std::unique_ptr<SourceReader> reader_;
};

}  // namespace

void serve_reader(const Line& line, const ReaderOpener& open) {
  Service service(line);
  try {
    service.run(open);
  } catch (const std::bad_alloc&) {
    service.fail(
        {FailureKind::kInput, "reading it takes more memory than a file of this size may"});
  }
}

}  // namespace mapwright::converter
