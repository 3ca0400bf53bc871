#include "raytracing/render/threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

namespace raytracing {
namespace {

TEST(Threads, EachDoesTheWorkOnce) {
  std::mutex mutex;
  std::set<std::thread::id> ids;
  EXPECT_EQ(run_in_threads(5,
                           [&] {
                             const std::lock_guard lock(mutex);
                             EXPECT_TRUE(ids.insert(std::this_thread::get_id()).second);
                           }),
            5);
  EXPECT_EQ(ids.size(), 5u);
  EXPECT_FALSE(ids.contains(std::this_thread::get_id()));
}

TEST(Threads, NoneAndOneMeanThisOne) {
  for (const int threads : {0, 1}) {
    std::thread::id id;
    EXPECT_EQ(run_in_threads(threads, [&] { id = std::this_thread::get_id(); }), 1);
    EXPECT_EQ(id, std::this_thread::get_id());
  }
}

// An exception reaches the caller when all threads are done, from the caller's own thread too.
TEST(Threads, ExceptionsReachTheCaller) {
  for (const int threads : {0, 3}) {
    std::atomic<int> done = 0;
    EXPECT_THROW(run_in_threads(threads,
                                [&] {
                                  ++done;
                                  throw std::runtime_error("one of them");
                                }),
                 std::runtime_error);
    EXPECT_EQ(done, std::max(1, threads));
  }
}

#if defined(__SSE__)
TEST(Threads, DenormalNumbersAreZeroOnlyInTheWork) {
  const volatile float least = std::numeric_limits<float>::min();
  for (const int threads : {0, 2}) run_in_threads(threads, [&] { EXPECT_EQ(least / 2, 0.0f); });
  EXPECT_GT(least / 2, 0.0f);
}
#endif

}  // namespace
}  // namespace raytracing
