#include "raytracing/render/threads.h"

#include <algorithm>
#include <ctime>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace raytracing {

#if defined(__SSE__)
FlushedDenormals::FlushedDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
FlushedDenormals::~FlushedDenormals() { _mm_setcsr(before_); }
#else
FlushedDenormals::FlushedDenormals() : before_(0) {}
FlushedDenormals::~FlushedDenormals() = default;
#endif

double thread_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

int run_in_threads(int threads, const std::function<void()>& work) {
  std::mutex mutex;
  std::exception_ptr first_exception;
  const auto share = [&] {
    const FlushedDenormals flushed;
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!first_exception) first_exception = std::current_exception();
    }
  };
  std::vector<std::jthread> started;
  try {
    for (int i = 0; threads > 1 && i < threads; ++i) started.emplace_back(share);
  } catch (const std::system_error&) {  // the system allows no more: fewer do as well
  }
  if (started.empty()) share();
  const int count = std::max(1, static_cast<int>(started.size()));
  started.clear();  // joins them
  if (first_exception) std::rethrow_exception(first_exception);
  return count;
}

}  // namespace raytracing
