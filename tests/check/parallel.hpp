// A loop over independent things, as many at a time as there are processors.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace fos {

/// Calls make_worker() once a thread, and what it gives with every index below `count`, each once.
/// What one throws ends the loop and is thrown here.
template <typename MakeWorker>
void in_parallel(std::size_t count, const MakeWorker& make_worker) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  const auto run = [&] {
    try {
      auto work = make_worker();
      for (std::size_t i = next++; i < count && !failed; i = next++) work(i);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
    while (others.size() + 1 < std::min(processors, count)) others.emplace_back(run);
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace fos
