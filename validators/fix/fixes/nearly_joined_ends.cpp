#include <algorithm>
#include <iterator>

#include "validators/fix/fixer.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

/// Moves ends of one obstacle onto others, digit by digit.
class Joiner {
 public:
  Joiner(const FixContext& context, std::size_t position)
      : snap_m_(context.snap_m), obstacle_(context.document.map.obstacles[position]) {
    proposal_.obstacle = position;
    if (auto texts = segment_texts(context.document, position)) texts_ = std::move(*texts);
  }

  bool is_readable() const { return !texts_.empty(); }

  /// The beginning of segment k goes to the end of the one before it.
  void join(std::size_t k) {
    const Segment& before = obstacle_.segments[k - 1];
    const Segment& segment = obstacle_.segments[k];
    if (before.b == segment.b) return;  // nothing would be left of it
    move(segment.a, before.b, texts_[k], 0, texts_[k - 1], 2);
  }

  /// The end of the last segment goes to the beginning of the first one.
  void close() {
    const Segment& first = obstacle_.segments.front();
    const Segment& last = obstacle_.segments.back();
    if (last.a == first.a) return;
    move(last.b, first.a, texts_.back(), 2, texts_.front(), 0);
  }

  Proposals take(FindingCode code) {
    if (proposal_.edits.empty()) return {};
    proposal_.code = code;
    const std::size_t ends = proposal_.edits.size() / 2;
    proposal_.message = name_of(obstacle_) + ": " + std::to_string(ends) +
                        (ends == 1 ? " end joined, moved by " : " ends joined, moved by at most ") +
                        metres(proposal_.moved_m) + " m";
    return {std::move(proposal_)};
  }

 private:
  void move(Point from, Point to, const SegmentText& at, std::size_t at_field,
            const SegmentText& like, std::size_t like_field) {
    const double moved_m = distance(from, to);
    if (moved_m > snap_m_) return;
    for (std::size_t i = 0; i < 2; ++i) {
      proposal_.edits.push_back(
          field_edit(at.fields[at_field + i], std::string(like.fields[like_field + i].text)));
    }
    proposal_.moved_m = std::max(proposal_.moved_m, moved_m);
  }

  double snap_m_;
  const Obstacle& obstacle_;
  std::vector<SegmentText> texts_;
  Proposal proposal_;
};

void append(Proposals& all, Proposals more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

Proposals fix_nearly_joined_ends(const FixContext& context) {
  Proposals proposals;
  for (const std::size_t position : blamed(context, FindingCode::G106)) {
    Joiner joiner(context, position);
    if (!joiner.is_readable()) continue;
    for (const auto k : blamed_segments(context, FindingCode::G106, position)) joiner.join(k);
    append(proposals, joiner.take(FindingCode::G106));
  }
  for (const std::size_t position : blamed(context, FindingCode::G105)) {
    Joiner joiner(context, position);
    if (!joiner.is_readable()) continue;
    joiner.close();
    append(proposals, joiner.take(FindingCode::G105));
  }
  return proposals;
}

}  // namespace mapwright::validators
