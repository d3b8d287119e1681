// A run that its caller follows, see <cover/progress.hpp>.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string_view>
#include <thread>
#include <type_traits>

#include <cover/progress.hpp>

#include "tasks/errors_as_values.hpp"

namespace cover {

/// Stands between a run and the functions that its caller follows it by, which are called one at a
/// time; what they throw stops the run and is kept. While nothing else is told, the last step is
/// told again now and then, so that the caller can stop what takes long. Time decides nothing else.
class FollowedRun {
 public:
  /// REQUIRES: `asked` and `thrown`, which takes what the caller's functions throw, outlive this
  FollowedRun(const Callbacks& asked, std::exception_ptr& thrown);

  /// For the run: `progress` and `packing` throw nothing. The stages that it tells are names that
  /// last.
  [[nodiscard]] const Callbacks& callbacks() const { return callbacks_; }

 private:
  /// Calls one of the caller's functions, unless one has thrown.
  ///
  /// REQUIRES: mutex_ is held
  template <class Function>
  void call(const Function& function);
  void tell(const Progress& step);
  void tell_again(const std::stop_token& end);

  const Callbacks& asked_;
  Callbacks callbacks_;
  std::stop_source stop_;
  std::stop_callback<std::function<void()>> on_stop_;  ///< the caller stops the run as well
  std::mutex mutex_;                                   ///< of all that follows
  std::exception_ptr& thrown_;
  std::optional<Progress> last_;
  bool was_told_ = false;  ///< since last_ was to be told again
  std::condition_variable_any wakes_;
  std::jthread again_;  ///< the last: it ends before what it uses
};

/// Calls `body`, whose result is a Result, with the callbacks of a FollowedRun.
///
/// Errors: those of errors_as_values()
/// Throws: what the caller's functions have thrown, when the run has ended
template <class Body>
std::invoke_result_t<Body, const Callbacks&> followed(std::string_view doing,
                                                      const Callbacks& asked, const Body& body) {
  std::exception_ptr thrown;
  auto result = errors_as_values(doing, [&] {
    FollowedRun run(asked, thrown);
    return body(run.callbacks());
  });
  if (thrown) std::rethrow_exception(thrown);
  return result;
}

}  // namespace cover
