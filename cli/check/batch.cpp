#include "cli/check/batch.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "cli/check/checked_map.hpp"
#include "cli/support/findings_text.hpp"
#include "navcore/parallel.hpp"

namespace mapwright::cli {
namespace {

using validators::MapRecord;

/// Hands records on in their order, whatever order they come in.
class InOrder {
 public:
  explicit InOrder(const std::function<void(const MapRecord&)>& take) : take_(take) {}

  void add(std::size_t number, MapRecord record) {
    waiting_.emplace(number, std::move(record));
    while (!waiting_.empty() && waiting_.begin()->first == next_) {
      const MapRecord first = std::move(waiting_.extract(waiting_.begin()).mapped());
      ++next_;
      take_(first);
    }
  }

 private:
  const std::function<void(const MapRecord&)>& take_;
  std::map<std::size_t, MapRecord> waiting_;
  std::size_t next_ = 0;
};

std::optional<MapRecord> known(const Journal* journal, const std::string& path) {
  if (journal == nullptr || path == "-") return std::nullopt;
  const auto digest = digest_on_disk(path);
  return digest ? journal->find(path, *digest) : std::nullopt;
}

// Takes over what the journal knows; returns the numbers of the other maps.
std::vector<std::size_t> still_to_check(const Batch& batch, const Journal* journal,
                                        InOrder& in_order) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < batch.maps.size(); ++i) {
    if (auto record = known(journal, batch.maps[i].path)) {
      in_order.add(i, *std::move(record));
    } else {
      numbers.push_back(i);
    }
  }
  return numbers;
}

}  // namespace

void check_batch(const Batch& batch, Journal* journal, Console& console,
                 const std::function<void(const MapRecord&)>& take) {
  InOrder in_order(take);
  const auto numbers = still_to_check(batch, journal, in_order);
  const std::size_t total = batch.maps.size();
  if (numbers.size() < total) {
    console.note("journal: " + std::to_string(total - numbers.size()) + " of " +
                 std::to_string(total) + " maps are done already");
  }
  const unsigned jobs = navcore::thread_count(batch.jobs);
  // Where there are fewer maps than jobs, each gets several threads for its localization runs.
  const unsigned threads =
      jobs / static_cast<unsigned>(std::clamp<std::size_t>(numbers.size(), 1, jobs));

  const auto progress = console.progress("checking");
  std::size_t done = 0;
  run_in_workers(
      numbers.size(), jobs, batch.limits,
      [&](std::size_t i) { return record_json(batch.check(batch.maps[numbers[i]], threads)); },
      [&](std::size_t i, const WorkerOutcome& outcome) {
        MapRecord record = record_of(outcome, batch.maps[numbers[i]].path, batch.limits);
        if (journal != nullptr) journal->add(record);
        in_order.add(numbers[i], std::move(record));
        if (numbers.size() > 1) progress(++done, numbers.size());
      });
}

}  // namespace mapwright::cli
