#include "converter/side_by_side.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace converter {

void do_side_by_side(std::size_t count, std::size_t at_once,
                     const std::function<void(std::size_t)>& work) {
    std::vector<std::exception_ptr> failures(count);
    const auto try_one = [&](std::size_t i) {
        try {
            // A thread that waits within one piece must not begin another on top of it.
            tbb::this_task_arena::isolate([&] { work(i); });
        } catch (...) {
            failures[i] = std::current_exception();
        }
    };
    std::size_t next = 0;
    tbb::parallel_pipeline(
        std::max<std::size_t>(at_once, 1),
        tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                            [&](tbb::flow_control& control) {
                                                if (next == count) {
                                                    control.stop();
                                                    return std::size_t{0};
                                                }
                                                return next++;
                                            }) &
            tbb::make_filter<std::size_t, void>(tbb::filter_mode::parallel, try_one));
    for (const std::exception_ptr& failure : failures) {
        if (failure) {
            std::rethrow_exception(failure);
        }
    }
}

std::size_t pieces_at_once(std::size_t bytes_each) {
    constexpr std::size_t room = std::size_t{1} << 30;
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    return std::clamp<std::size_t>(room / std::max<std::size_t>(bytes_each, 1), 1, cores);
}

} // namespace converter
