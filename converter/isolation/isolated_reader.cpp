#include "converter/isolation/isolated_reader.hpp"

#include <filesystem>

#include "converter/isolation/reader_service.hpp"
#include "converter/isolation/wire.hpp"

namespace mapwright::converter {
namespace {

constexpr double kSlowestReading_bytes_per_s = 1e6;
constexpr std::uint64_t kLeastMemory_bytes = std::uint64_t{2} << 30U;
constexpr std::uint64_t kMemoryPerByte = 32;

ChildLimits limits_for(std::uint64_t source_bytes) {
  const double reading_s = static_cast<double>(source_bytes) / kSlowestReading_bytes_per_s;
  ChildLimits limits;
  limits.silent_cpu_s += reading_s;
  limits.silent_wall_s += 10.0 * reading_s;
  limits.memory_bytes = kLeastMemory_bytes + kMemoryPerByte * source_bytes;
  return limits;
}

// The parent's side.
class IsolatedReader : public SourceReader {
 public:
  IsolatedReader(std::string path, std::unique_ptr<SharedBatches> batches,
                 std::unique_ptr<ChildProcess> child)
      : path_(std::move(path)), batches_(std::move(batches)), child_(std::move(child)) {}

  Result<void> finish_opening() {
    while (next()) {
      auto wire = content();
      if (is(Word::kDriver)) wire.get(driver_);
      if (is(Word::kWarnings)) append_warnings();
      if (is(Word::kFailure)) return tl::unexpected(failure());
      if (!is(Word::kOpened)) continue;
      wire.get(driver_);
      get(wire, layers_);
      return {};
    }
    return tl::unexpected(gone("opening it"));
  }

  const std::string& driver() const override { return driver_; }
  const std::vector<LayerInfo>& layers() const override { return layers_; }
  std::vector<std::string> take_warnings() override { return std::exchange(warnings_, {}); }

  Result<std::optional<Box>> extent(std::size_t layer) override {
    WireWriter request;
    request.put(static_cast<std::uint64_t>(layer));
    bool exists = false;
    Box box{};
    if (!ask(Word::kExtent, request)) {
      return tl::unexpected(gone("measuring layer " + layers_[layer].name));
    }
    if (is(Word::kFailure)) return tl::unexpected(failure());
    auto wire = content();
    wire.get(exists);
    wire.get(box);
    return exists ? std::optional(box) : std::nullopt;
  }

  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    WireWriter request;
    request.put(static_cast<std::uint64_t>(layer));
    put(request, options);
    sent_values_ = sent_values(layers_[layer], options);
    feature_.values.assign(layers_[layer].fields.size(), FieldValue());
    std::size_t received = 0;
    bool alive = ask(Word::kRead, request);
    for (; alive && !is(Word::kDone); alive = next()) {
      if (is(Word::kWarnings)) append_warnings();
      if (is(Word::kFailure)) return tl::unexpected(failure());
      if (is(Word::kFeatures)) received += visit_features(content(), visit);
      if (is(Word::kSlot)) received += visit_slot(visit);
    }
    if (alive && is_told(received)) return received;
    if (alive) {
      return input_failure(path_ + ": layer " + layers_[layer].name +
                           ": not all that was read of it arrived: the process that reads it is "
                           "out of order");
    }
    return tl::unexpected(gone("reading layer " + layers_[layer].name + " (after " +
                               std::to_string(received) + " features)"));
  }

 private:
  bool next() { return child_->receive(frame_); }
  bool ask(Word word, const WireWriter& request) {
    child_->send(static_cast<std::uint8_t>(word), request.bytes());  // next() tells if it failed
    return next();
  }
  bool is(Word word) const { return frame_.kind == static_cast<std::uint8_t>(word); }
  WireReader content() const { return {frame_.bytes.data(), frame_.bytes.size()}; }

  // Whether the child says it sent so many features.
  bool is_told(std::size_t received) const {
    std::uint64_t sent = 0;
    content().get(sent);
    return sent == received;
  }

  void append_warnings() {
    std::vector<std::string> warnings;
    content().get(warnings);
    for (auto& warning : warnings) warnings_.push_back(std::move(warning));
  }

  // Whatever the child says of a slot, nothing beyond it is read.
  std::size_t visit_slot(const FeatureVisitor& visit) {
    FilledSlot slot;
    content().get(slot);
    if (!batches_ || slot.bytes > SharedBatches::kSlotBytes) return 0;
    const auto count = visit_features({batches_->slot(slot.number).data(), slot.bytes}, visit);
    WireWriter answer;
    answer.put(slot.number);
    child_->send(static_cast<std::uint8_t>(Word::kSlot), answer.bytes());
    return count;
  }

  std::size_t visit_features(WireReader wire, const FeatureVisitor& visit) {
    std::size_t count = 0;
    while (!wire.at_end()) {
      get(wire, feature_, sent_values_);
      if (!wire.good()) break;
      visit(feature_);
      ++count;
    }
    return count;
  }

  Failure failure() const {
    Failure failure;
    auto wire = content();
    get(wire, failure);
    // Parts of a data set beside it are named by their own paths.
    const auto stem = std::filesystem::path(path_).replace_extension().string();
    if (!failure.message.starts_with(stem) && failure.kind == FailureKind::kInput) {
      failure.message = path_ + ": " + failure.message;
    }
    return failure;
  }

  Failure gone(const std::string& what) const {
    const std::string who = driver_.empty() ? "the reader" : "the driver " + driver_;
    return {FailureKind::kInput, path_ + ": " + who + " " + child_->end() + " while " + what +
                                     ": the file is damaged or not what it seems; get a sound "
                                     "copy, or save it in another format"};
  }

  std::string path_;
  std::unique_ptr<SharedBatches> batches_;
  std::unique_ptr<ChildProcess> child_;
  std::string driver_;
  std::vector<LayerInfo> layers_;
  std::vector<std::string> warnings_;
  Frame frame_;
  SourceFeature feature_;
  std::vector<std::uint32_t> sent_values_;  // of the layer that is read now
};

}  // namespace

OpenedReader open_isolated(const std::string& path, std::uint64_t source_bytes,
                           const ReaderOpener& open) {
  auto batches = SharedBatches::create();
  auto child = ChildProcess::start(
      limits_for(source_bytes), [&](const Line& line) { serve_reader(line, batches.get(), open); });
  if (!child) return input_failure(path + ": " + child.error().message);
  auto reader = std::make_unique<IsolatedReader>(path, std::move(batches), *std::move(child));
  if (auto opened = reader->finish_opening(); !opened) return tl::unexpected(opened.error());
  return reader;
}

}  // namespace mapwright::converter
