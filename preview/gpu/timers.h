// GPU timestamps around the steps of a frame.
#pragma once

#include "preview/gpu/device.h"

#include <cstdint>
#include <vector>

namespace preview::gpu {

class Timers {
  public:
    Timers(const Device& device, std::uint32_t capacity);

    void reset(const vk::raii::CommandBuffer& commands);
    /// The moment when all earlier commands are finished.
    void stamp(const vk::raii::CommandBuffer& commands);
    /// Milliseconds between consecutive stamps. Only after the commands have finished.
    std::vector<double> intervals() const;
    std::uint32_t capacity() const { return capacity_; }

  private:
    vk::raii::QueryPool pool_ = nullptr;
    std::uint32_t capacity_ = 0;
    std::uint32_t used_ = 0;
    double milliseconds_per_tick_ = 0;
    std::uint64_t valid_bits_ = 0; ///< a mask
};

} // namespace preview::gpu
