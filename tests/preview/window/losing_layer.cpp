// A Vulkan layer that loses the device: while the file that LUT_LOSES_DEVICE names is there, the
// next submission loses it, as a driver does when a GPU hangs or is pulled out. From then on all
// that waits for the device, or hands it work, answers VK_ERROR_DEVICE_LOST, until the program
// makes another. What the file says: "once", and it is removed, or "always".
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

namespace {

// One instance and, after another, one device at a time: what lutpreview makes.
PFN_vkGetInstanceProcAddr next_of_instance = nullptr;
PFN_vkGetDeviceProcAddr next_of_device = nullptr;
VkInstance instance_now = VK_NULL_HANDLE;
VkDevice device_now = VK_NULL_HANDLE;
std::atomic<bool> is_lost{false};

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(next_of_device(device_now, name));
}

template <class Link, class Info>
Link* link_of(const Info* info, VkStructureType type) {
    auto* it = static_cast<const Link*>(info->pNext);
    while (it != nullptr && (it->sType != type || it->function != VK_LAYER_LINK_INFO)) {
        it = static_cast<const Link*>(it->pNext);
    }
    return const_cast<Link*>(it); // layers step it on, as the loader asks
}

bool loses_now() {
    const char* const path = std::getenv("LUT_LOSES_DEVICE");
    std::string word;
    if (path == nullptr || !(std::ifstream(path) >> word)) {
        return false;
    }
    if (word == "once") {
        std::remove(path);
    }
    return true;
}

VkResult as_lost(VkResult result) {
    return is_lost ? VK_ERROR_DEVICE_LOST : result;
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* info,
                                               const VkAllocationCallbacks* allocator,
                                               VkInstance* instance) {
    auto* const link =
        link_of<VkLayerInstanceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    next_of_instance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create =
        reinterpret_cast<PFN_vkCreateInstance>(next_of_instance(nullptr, "vkCreateInstance"));
    const VkResult out = create(info, allocator, instance);
    instance_now = *instance;
    return out;
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical,
                                             const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* allocator,
                                             VkDevice* device) {
    auto* const link =
        link_of<VkLayerDeviceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(
        link->u.pLayerInfo->pfnNextGetInstanceProcAddr(instance_now, "vkCreateDevice"));
    next_of_device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const VkResult out = create(physical, info, allocator, device);
    device_now = *device;
    is_lost = false;
    return out;
}

VKAPI_ATTR VkResult VKAPI_CALL submit(VkQueue queue, std::uint32_t count,
                                      const VkSubmitInfo2* infos, VkFence fence) {
    is_lost = is_lost || loses_now();
    return is_lost ? VK_ERROR_DEVICE_LOST
                   : next<PFN_vkQueueSubmit2>("vkQueueSubmit2")(queue, count, infos, fence);
}

// What is still under way ends, so that all can be freed; then the answer is that of a lost device.
VKAPI_ATTR VkResult VKAPI_CALL wait_for_device(VkDevice device) {
    return as_lost(next<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(device));
}

VKAPI_ATTR VkResult VKAPI_CALL wait_for_fences(VkDevice device, std::uint32_t count,
                                               const VkFence* fences, VkBool32 all,
                                               std::uint64_t timeout) {
    return is_lost
               ? VK_ERROR_DEVICE_LOST
               : next<PFN_vkWaitForFences>("vkWaitForFences")(device, count, fences, all, timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL present(VkQueue queue, const VkPresentInfoKHR* info) {
    return is_lost ? VK_ERROR_DEVICE_LOST
                   : next<PFN_vkQueuePresentKHR>("vkQueuePresentKHR")(queue, info);
}

VKAPI_ATTR VkResult VKAPI_CALL acquire(VkDevice device, VkSwapchainKHR swapchain,
                                       std::uint64_t timeout, VkSemaphore semaphore, VkFence fence,
                                       std::uint32_t* image) {
    return is_lost ? VK_ERROR_DEVICE_LOST
                   : next<PFN_vkAcquireNextImageKHR>("vkAcquireNextImageKHR")(
                         device, swapchain, timeout, semaphore, fence, image);
}

PFN_vkVoidFunction own(const char* name);

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL of_device(VkDevice device, const char* name) {
    const PFN_vkVoidFunction theirs = next_of_device(device, name);
    const PFN_vkVoidFunction ours = theirs != nullptr ? own(name) : nullptr;
    return ours != nullptr ? ours : theirs;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL of_instance(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction ours = own(name);
    return ours != nullptr               ? ours
           : next_of_instance != nullptr ? next_of_instance(instance, name)
                                         : nullptr;
}

struct Row {
    const char* name;
    PFN_vkVoidFunction function;
};

PFN_vkVoidFunction own(const char* name) {
    const auto any = [](auto function) { return reinterpret_cast<PFN_vkVoidFunction>(function); };
    const Row rows[] = {
        {"vkGetInstanceProcAddr", any(&of_instance)},
        {"vkGetDeviceProcAddr", any(&of_device)},
        {"vkCreateInstance", any(&create_instance)},
        {"vkCreateDevice", any(&create_device)},
        {"vkQueueSubmit2", any(&submit)},
        {"vkDeviceWaitIdle", any(&wait_for_device)},
        {"vkWaitForFences", any(&wait_for_fences)},
        {"vkQueuePresentKHR", any(&present)},
        {"vkAcquireNextImageKHR", any(&acquire)},
    };
    for (const Row& row : rows) {
        if (std::strcmp(row.name, name) == 0) {
            return row.function;
        }
    }
    return nullptr;
}

} // namespace

extern "C" __attribute__((visibility("default"))) VkResult
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = &of_instance;
    version->pfnGetDeviceProcAddr = &of_device;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
