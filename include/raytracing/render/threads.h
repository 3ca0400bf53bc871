#pragma once

#include <functional>

namespace raytracing {

/// While it lives, denormal numbers count as 0 in this thread: Embree asks for it, and slow numbers
/// have no place in a picture.
class FlushedDenormals {
 public:
  FlushedDenormals();
  ~FlushedDenormals();
  FlushedDenormals(const FlushedDenormals&) = delete;
  FlushedDenormals& operator=(const FlushedDenormals&) = delete;

 private:
  unsigned before_;
};

/// Processor time of this thread in seconds: other programs count only by what they do to the
/// caches.
double thread_cpu_seconds();

/// Runs `work` at once in `threads` threads, or in as many as can be started, with denormal numbers
/// counting as 0. For one thread, and where none can be started, this one does the work. Returns
/// their number when all are done. Throws the first exception that `work` throws in any of them,
/// when all are done.
int run_in_threads(int threads, const std::function<void()>& work);

}  // namespace raytracing
