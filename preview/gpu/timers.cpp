#include "preview/gpu/timers.h"

#include <stdexcept>

namespace preview::gpu {

Timers::Timers(const Device& device, std::uint32_t capacity)
    : pool_(device.vk(), vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, capacity)),
      capacity_(capacity),
      milliseconds_per_tick_(static_cast<double>(device.limits().timestampPeriod) * 1e-6) {
    const std::uint32_t bits =
        device.physical().getQueueFamilyProperties()[device.queue_family()].timestampValidBits;
    valid_bits_ = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

void Timers::reset(const vk::raii::CommandBuffer& commands) {
    commands.resetQueryPool(*pool_, 0, capacity_);
    used_ = 0;
}

void Timers::stamp(const vk::raii::CommandBuffer& commands) {
    if (used_ == capacity_) {
        throw std::logic_error("more timestamps than the frame has steps");
    }
    commands.writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *pool_, used_++);
}

std::vector<double> Timers::intervals() const {
    if (used_ < 2 || valid_bits_ == 0) {
        return {};
    }
    const auto [result, ticks] = pool_.getResults<std::uint64_t>(
        0, used_, used_ * sizeof(std::uint64_t), sizeof(std::uint64_t),
        vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
    std::vector<double> intervals;
    for (std::size_t index = 1; index < ticks.size(); ++index) {
        intervals.push_back(static_cast<double>((ticks[index] - ticks[index - 1]) & valid_bits_) *
                            milliseconds_per_tick_);
    }
    return intervals;
}

} // namespace preview::gpu
