// The Vulkan instance, device and queue: everything else of gpu/ is made from a Device.
#pragma once

#include <vulkan/vulkan_raii.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace preview::gpu {

struct DeviceOptions {
    /// A number of `--list`, or part of a device's name in any case; empty: the best there is.
    std::string wanted;
    /// Load the Khronos validation layer with synchronisation validation.
    bool validation = false;
    std::vector<const char*> instance_extensions;
    std::vector<const char*> device_extensions;
};

struct DeviceInfo {
    std::string name;
    std::string kind; ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"
    bool usable = false;
    std::string missing; ///< why not, when it is not
};

/// Every device of this machine, in the order in which an unnamed one is chosen: discrete,
/// integrated, virtual, CPU. Throws lutlib::Error when there is no Vulkan driver.
std::vector<DeviceInfo> list_devices();

class Pipelines;

class Device {
  public:
    /// Throws lutlib::Error when there is no driver, or no device of that name that has what we
    /// need (Vulkan 1.3 with dynamic rendering and synchronization2).
    explicit Device(const DeviceOptions& options = {});
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device();

    const vk::raii::Instance& instance() const { return instance_; }
    const vk::raii::PhysicalDevice& physical() const { return physical_; }
    const vk::raii::Device& vk() const { return device_; }
    const vk::raii::Queue& queue() const { return queue_; }
    std::uint32_t queue_family() const { return queue_family_; }
    const std::string& name() const { return name_; }
    /// 64-bit integers in shaders, with atomics on buffers of them.
    bool has_int64_atomics() const { return has_int64_atomics_; }
    /// Half-float arithmetic in shaders.
    bool has_half() const { return has_half_; }
    /// The same where it is faster than float: not on CPUs.
    bool has_fast_half() const;
    /// How many workgroups of 1024 run at the same time; a guess where the driver does not tell.
    std::uint32_t compute_units() const { return compute_units_; }
    const vk::PhysicalDeviceLimits& limits() const { return limits_; }

    /// The index of a memory type among `type_bits` with `wanted`, preferably also `preferred`.
    std::uint32_t memory_type(std::uint32_t type_bits, vk::MemoryPropertyFlags wanted,
                              vk::MemoryPropertyFlags preferred = {}) const;
    /// Allocations made so far through allocate(); a steady frame does not move it.
    std::uint64_t allocation_count() const { return allocation_count_; }
    vk::raii::DeviceMemory allocate(const vk::MemoryAllocateInfo& info) const;

    /// Records commands, submits them and waits for their end. For set-up, not for frames.
    void run_once(const std::function<void(const vk::raii::CommandBuffer&)>& record) const;

    /// What everything that runs on it shares, so that no pipeline is made twice.
    Pipelines& pipelines() const { return *pipelines_; }

    /// Warnings and errors of the validation layers since the device was made.
    std::vector<std::string> validation_messages() const;

  private:
    struct Messages;

    vk::raii::Context context_;
    std::unique_ptr<Messages> messages_;
    vk::raii::Instance instance_ = nullptr;
    vk::raii::DebugUtilsMessengerEXT messenger_ = nullptr;
    vk::raii::PhysicalDevice physical_ = nullptr;
    vk::raii::Device device_ = nullptr;
    vk::raii::Queue queue_ = nullptr;
    std::uint32_t queue_family_ = 0;
    std::string name_;
    bool has_int64_atomics_ = false;
    bool has_half_ = false;
    std::uint32_t compute_units_ = 64;
    vk::PhysicalDeviceLimits limits_;
    vk::PhysicalDeviceMemoryProperties memory_;
    mutable std::uint64_t allocation_count_ = 0;
    std::unique_ptr<Pipelines> pipelines_;
};

} // namespace preview::gpu
