#include "rank_share_out.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>

#include <cover/options.hpp>

#include "messages.hpp"

namespace cover::mpi {
namespace {

/// The regions that nobody has yet: the large ones first, the largest of them at first; the others,
/// of which a part has many, as they come, since neighbours are neighbours in files, too.
class Queue {
 public:
  Queue(const RegionJobs& jobs, std::size_t takers) : costs_(jobs.size()), takers_(takers) {
    for (std::size_t k = 0; k < costs_.size(); ++k) rest_ += costs_[k] = jobs.cost(k);
    order_.resize(costs_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    const auto small = std::stable_partition(
        order_.begin(), order_.end(), [&](std::size_t k) { return costs_[k] >= kLeastPart; });
    std::stable_sort(order_.begin(), small,
                     [&](std::size_t a, std::size_t b) { return costs_[a] > costs_[b]; });
  }

  /// The next regions for one who has `threads`: a quarter of its part of what is left, so that
  /// parts shrink towards the end. Empty: there are none.
  std::vector<std::size_t> take(std::size_t threads) {
    const std::lock_guard lock(mutex_);
    const std::size_t part = std::max(kLeastPart, threads * rest_ / (4 * takers_));
    std::vector<std::size_t> taken;
    for (std::size_t cost = 0; next_ < order_.size() && cost < part; ++next_) {
      taken.push_back(order_[next_]);
      cost += costs_[order_[next_]];
      rest_ -= costs_[order_[next_]];
    }
    return taken;
  }

  /// Takes what is left from everyone.
  void close() {
    const std::lock_guard lock(mutex_);
    next_ = order_.size();
  }

 private:
  /// Some milliseconds of work, beside which a message costs little.
  static constexpr std::size_t kLeastPart = 1000;

  std::vector<std::size_t> costs_, order_;
  std::size_t takers_, rest_ = 0, next_ = 0;
  std::mutex mutex_;
};

/// Threads of this process that mesh until the queue is empty.
class Here {
 public:
  Here(RegionJobs& jobs, Queue& queue, unsigned threads)
      : thread_([this, &jobs, &queue, threads] {
          try {
            jobs.mesh_here(threads, [&queue] { return queue.take(1); });
          } catch (...) {
            thrown_ = std::current_exception();
          }
          at_work_ = false;
        }) {}
  [[nodiscard]] bool at_work() const { return at_work_; }
  /// Throws what was thrown there.
  ///
  /// REQUIRES: !at_work()
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  std::exception_ptr thrown_;
  std::atomic<bool> at_work_ = true;
  std::jthread thread_;
};

}  // namespace

Status share_out_among_ranks(RegionJobs& jobs, const RankCores& cores) {
  const Bytes options = jobs.options();
  const Result<Options> known = options_of_bytes(options);
  if (!known) return known.error();
  const int ranks = rank_count();
  Outbox outbox;
  for (int rank = 1; rank < ranks; ++rank) outbox.send(options, rank, Tag::options);
  const unsigned threads = threads_of_rank(known->threads, cores);

  jobs.offer_to_keep([&](const Bytes& how) {
    for (int rank = 1; rank < ranks; ++rank) outbox.send(how, rank, Tag::keep);
    return all_agree(true);
  });

  Queue queue(jobs, static_cast<std::size_t>(ranks) * threads);
  int at_work = 0;  // other ranks
  const auto employ = [&](int rank) {
    std::vector<Parcel> parcels;
    for (const std::size_t region : queue.take(threads))
      parcels.push_back({region, jobs.boundary(region)});
    if (parcels.empty()) return;
    outbox.send(pack(parcels), rank, Tag::regions);
    ++at_work;
  };
  for (int rank = 1; rank < ranks; ++rank) employ(rank);
  Here here(jobs, queue, threads);
  while (at_work > 0 || here.at_work()) {
    if (jobs.stop().stop_requested()) queue.close();
    outbox.tidy();
    const std::optional<Message> message = receive_if_any();
    if (!message) {
      rest();
      continue;
    }
    if (message->tag == Tag::failed) {
      queue.close();
      return told_error(*message);
    }
    for (const Parcel& parcel : unpack(message->bytes)) jobs.accept(parcel.number, parcel.bytes);
    --at_work;
    employ(message->rank);
  }
  here.rethrow();
  return ok();
}

Status write_among_ranks(const Bytes& plan, const std::function<Status()>& here) {
  const int ranks = rank_count();
  for (int rank = 1; rank < ranks; ++rank) send({}, rank, Tag::write);
  Bytes sent = plan;
  spread(sent);
  Status all = here();
  // Who was interrupted waits for nobody.
  if (!all && all.error().code == ErrorCode::cancelled) return all;
  for (int answers = 1; answers < ranks; ++answers) {
    const Message message = receive();
    if (all && !message.bytes.empty()) all = told_error(message);
  }
  return all;
}

void dismiss_ranks() {
  Outbox outbox;
  for (int rank = 1; rank < rank_count(); ++rank) outbox.send({}, rank, Tag::end);
}

}  // namespace cover::mpi
