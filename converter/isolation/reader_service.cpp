#include "converter/isolation/reader_service.hpp"

#include <new>
#include <utility>

#include "converter/isolation/wire.hpp"

namespace mapwright::converter {
namespace {

// A batch is sent when there is no more room for an ordinary feature in a slot.
constexpr std::size_t kBatchBytes = SharedBatches::kSlotBytes - (std::size_t{1} << 14U);

class Service {
 public:
  Service(const Line& line, const SharedBatches* batches) : line_(line), batches_(batches) {}

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
  // Puts features of a layer into batches.
  class Sink : public FeatureSink {
   public:
    Sink(Service& service, std::size_t fields, std::vector<std::uint32_t> values)
        : service_(service), fields_(fields), values_(std::move(values)) {}

    void add(SourceFeature& feature) override {
      feature.values.resize(fields_);
      put(service_.features_, feature, values_);
      service_.send_full_batch();
    }
    void add(const FeatureRow& row) override {
      put(service_.features_, row, values_);
      service_.send_full_batch();
    }

   private:
    Service& service_;
    std::size_t fields_;                 // of the layer
    std::vector<std::uint32_t> values_;  // that are sent
  };

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
    filled_ = 0;
    read_ = 0;
    begin_batch();
    const auto& info = reader_->layers()[layer];
    Sink sink(*this, info.fields.size(), sent_values(info, options));
    const auto count = reader_->read_into(layer, options, sink);
    if (features_.size() > 0) send_batch();
    wait_until_read(filled_);
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

  // Features are written where the parent reads them, as long as there is room.
  void begin_batch() {
    features_.clear();
    if (batches_ == nullptr) return;
    if (filled_ >= SharedBatches::kSlots) wait_until_read(filled_ - SharedBatches::kSlots + 1);
    features_.write_to(batches_->slot(filled_));
  }

  void send_full_batch() {
    if (features_.size() >= kBatchBytes) send_batch();
  }

  void send_batch() {
    const auto bytes = features_.bytes();
    if (batches_ != nullptr && bytes.data() == batches_->slot(filled_).data()) {
      wire_.clear();
      wire_.put(FilledSlot{filled_++, bytes.size()});
      flush(Word::kSlot);
    } else {
      line_.send(static_cast<std::uint8_t>(Word::kFeatures), bytes);
    }
    begin_batch();
  }

  // Until the parent has read so many slots; it reads them in turn.
  void wait_until_read(std::uint64_t slots) {
    Frame frame;
    while (read_ < slots && line_.receive(frame)) ++read_;
  }

  const Line& line_;
  const SharedBatches* batches_;
  std::uint64_t filled_ = 0;  // slots of the layer that is read now
  std::uint64_t read_ = 0;    // of them, by the parent
  WireWriter wire_, features_;
  std::unique_ptr<SourceReader> reader_;
};

}  // namespace

void serve_reader(const Line& line, const SharedBatches* batches, const ReaderOpener& open) {
  Service service(line, batches);
  try {
    service.run(open);
  } catch (const std::bad_alloc&) {
    service.fail(
        {FailureKind::kInput, "reading it takes more memory than a file of this size may"});
  }
}

}  // namespace mapwright::converter
