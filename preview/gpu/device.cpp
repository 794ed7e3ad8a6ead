#include "preview/gpu/device.h"

#include "lutlib/error.h"
#include "preview/gpu/commands.h"
#include "preview/gpu/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <mutex>
#include <optional>
#include <string_view>

namespace preview::gpu {

struct Device::Messages {
    std::mutex mutex;
    std::vector<std::string> texts;
    std::function<void(const char*)> add;
};

namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

struct KindInfo {
    vk::PhysicalDeviceType type;
    const char* name;
};

/// In order of preference.
constexpr KindInfo kinds[] = {
    {vk::PhysicalDeviceType::eDiscreteGpu, "discrete GPU"},
    {vk::PhysicalDeviceType::eIntegratedGpu, "integrated GPU"},
    {vk::PhysicalDeviceType::eVirtualGpu, "virtual GPU"},
    {vk::PhysicalDeviceType::eCpu, "CPU"},
    {vk::PhysicalDeviceType::eOther, "other"},
};

std::size_t rank(vk::PhysicalDeviceType type) {
    const auto* found = std::find_if(std::begin(kinds), std::end(kinds),
                                     [&](const KindInfo& kind) { return kind.type == type; });
    return static_cast<std::size_t>(found - std::begin(kinds));
}

VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                       VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data,
                                       void* user) {
    // What a shader writes to an attachment without a format is discarded; that is how targets that
    // nobody reads are left out. The layer warns of every such output.
    const std::string_view id = data->pMessageIdName != nullptr ? data->pMessageIdName : "";
    const std::string_view text = data->pMessage;
    if (id == "UNASSIGNED-CoreValidation-Shader-InterfaceTypeMismatch" &&
        text.find("of type `VK_FORMAT_UNDEFINED` does not match") != std::string_view::npos) {
        return VK_FALSE;
    }
    (*static_cast<std::function<void(const char*)>*>(user))(data->pMessage);
    return VK_FALSE;
}

[[noreturn]] void no_driver() {
    throw lutlib::Error("no Vulkan driver was found: install the GPU's driver, or Mesa's lavapipe "
                        "(Debian: mesa-vulkan-drivers) to render on the CPU");
}

vk::raii::Instance make_instance(const vk::raii::Context& context, const DeviceOptions& options) {
    vk::ApplicationInfo application("lutpreview", 1, "lutpreview", 1, VK_API_VERSION_1_3);
    std::vector<const char*> layers;
    std::vector<const char*> extensions = options.instance_extensions;
    const vk::ValidationFeatureEnableEXT enabled[] = {
        vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
    const vk::ValidationFeaturesEXT features(enabled);
    vk::InstanceCreateInfo info({}, &application);
    if (options.validation) {
        layers.push_back(validation_layer);
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
        info.pNext = &features;
    }
    info.setPEnabledLayerNames(layers);
    info.setPEnabledExtensionNames(extensions);
    try {
        return {context, info};
    } catch (const vk::IncompatibleDriverError&) {
        no_driver();
    } catch (const vk::LayerNotPresentError&) {
        throw lutlib::Error("the Vulkan validation layer is not installed (Debian: "
                            "vulkan-validationlayers)");
    }
}

struct NeededFeature {
    const char* name;
    bool present;
};

/// The first thing that `device` lacks and we cannot do without; empty: it has all.
std::string missing_of(const vk::raii::PhysicalDevice& device) {
    if (device.getProperties().apiVersion < VK_API_VERSION_1_3) {
        return "Vulkan 1.3";
    }
    const auto chain =
        device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan13Features>();
    const auto& base = chain.get<vk::PhysicalDeviceFeatures2>().features;
    const auto& v13 = chain.get<vk::PhysicalDeviceVulkan13Features>();
    const vk::PhysicalDeviceLimits limits = device.getProperties().limits;
    const NeededFeature needed[] = {
        {"dynamicRendering", v13.dynamicRendering == VK_TRUE},
        {"maintenance4", v13.maintenance4 == VK_TRUE},
        {"synchronization2", v13.synchronization2 == VK_TRUE},
        {"fillModeNonSolid", base.fillModeNonSolid == VK_TRUE},
        {"shaderStorageImageWriteWithoutFormat",
         base.shaderStorageImageWriteWithoutFormat == VK_TRUE},
        // What shaders/common/lattice16.glsl and its workgroups take.
        {"workgroups of 1024", limits.maxComputeWorkGroupInvocations >= 1024},
        {"32 KiB of shared memory", limits.maxComputeSharedMemorySize >= 32768},
    };
    for (const NeededFeature& feature : needed) {
        if (!feature.present) {
            return feature.name;
        }
    }
    return {};
}

bool supports_int64_atomics(const vk::raii::PhysicalDevice& device) {
    const auto chain =
        device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features>();
    return chain.get<vk::PhysicalDeviceFeatures2>().features.shaderInt64 == VK_TRUE &&
           chain.get<vk::PhysicalDeviceVulkan12Features>().shaderBufferInt64Atomics == VK_TRUE;
}

bool supports_half(const vk::raii::PhysicalDevice& device) {
    const auto chain =
        device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features>();
    return chain.get<vk::PhysicalDeviceVulkan12Features>().shaderFloat16 == VK_TRUE;
}

/// The number of NVIDIA's streaming multiprocessors; empty for others.
std::optional<std::uint32_t> multiprocessors(const vk::raii::PhysicalDevice& device) {
    const auto extensions = device.enumerateDeviceExtensionProperties();
    if (std::none_of(extensions.begin(), extensions.end(), [](const auto& extension) {
            return std::string_view(extension.extensionName) ==
                   VK_NV_SHADER_SM_BUILTINS_EXTENSION_NAME;
        })) {
        return std::nullopt;
    }
    return device
        .getProperties2<vk::PhysicalDeviceProperties2,
                        vk::PhysicalDeviceShaderSMBuiltinsPropertiesNV>()
        .get<vk::PhysicalDeviceShaderSMBuiltinsPropertiesNV>()
        .shaderSMCount;
}

std::optional<std::uint32_t> graphics_family(const vk::raii::PhysicalDevice& device) {
    const auto families = device.getQueueFamilyProperties();
    constexpr auto both = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    for (std::uint32_t index = 0; index < families.size(); ++index) {
        if ((families[index].queueFlags & both) == both) {
            return index;
        }
    }
    return std::nullopt;
}

std::vector<vk::raii::PhysicalDevice> ranked(const vk::raii::Instance& instance) {
    std::vector<vk::raii::PhysicalDevice> devices;
    try {
        for (vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(instance)) {
            devices.push_back(std::move(device));
        }
    } catch (const vk::SystemError&) {
        no_driver();
    }
    if (devices.empty()) {
        no_driver();
    }
    std::stable_sort(devices.begin(), devices.end(), [](const auto& a, const auto& b) {
        return rank(a.getProperties().deviceType) < rank(b.getProperties().deviceType);
    });
    return devices;
}

DeviceInfo describe(const vk::raii::PhysicalDevice& device) {
    const auto properties = device.getProperties();
    DeviceInfo info;
    info.name = properties.deviceName.data();
    info.kind = kinds[std::min(rank(properties.deviceType), std::size(kinds) - 1)].name;
    info.missing = missing_of(device);
    if (info.missing.empty() && !graphics_family(device)) {
        info.missing = "a queue for graphics and compute";
    }
    info.usable = info.missing.empty();
    return info;
}

std::string lower(std::string text) {
    for (char& c : text) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return text;
}

std::size_t choose(const std::vector<DeviceInfo>& devices, const std::string& wanted) {
    std::string names;
    for (std::size_t index = 0; index < devices.size(); ++index) {
        const DeviceInfo& device = devices[index];
        const bool named = wanted == std::to_string(index) ||
                           lower(device.name).find(lower(wanted)) != std::string::npos;
        if (named && device.usable) {
            return index;
        }
        names += fmt::format("{}{} {}{}", index == 0 ? "" : ", ", index, device.name,
                             device.usable ? "" : " (lacks " + device.missing + ")");
    }
    throw lutlib::Error(wanted.empty() ? "no Vulkan device can be used; there are: " + names
                                       : "no usable Vulkan device is named '" + wanted +
                                             "'; there are: " + names);
}

} // namespace

std::vector<DeviceInfo> list_devices() {
    const vk::raii::Context context;
    const vk::raii::Instance instance = make_instance(context, {});
    std::vector<DeviceInfo> infos;
    for (const vk::raii::PhysicalDevice& device : ranked(instance)) {
        infos.push_back(describe(device));
    }
    return infos;
}

Device::Device(const DeviceOptions& options) : messages_(std::make_unique<Messages>()) {
    instance_ = make_instance(context_, options);
    if (options.validation) {
        messages_->add = [messages = messages_.get()](const char* text) {
            const std::lock_guard lock(messages->mutex);
            messages->texts.emplace_back(text);
        };
        using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
        using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
        messenger_ = {instance_, vk::DebugUtilsMessengerCreateInfoEXT(
                                     {}, Severity::eWarning | Severity::eError,
                                     Type::eGeneral | Type::eValidation | Type::ePerformance,
                                     &collect, &messages_->add)};
    }

    std::vector<vk::raii::PhysicalDevice> devices = ranked(instance_);
    std::vector<DeviceInfo> infos;
    for (const vk::raii::PhysicalDevice& device : devices) {
        infos.push_back(describe(device));
    }
    const std::size_t chosen = choose(infos, options.wanted);
    physical_ = std::move(devices[chosen]);
    name_ = infos[chosen].name;
    limits_ = physical_.getProperties().limits;
    memory_ = physical_.getMemoryProperties();
    queue_family_ = *graphics_family(physical_);

    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue_info({}, queue_family_, 1, &priority);
    vk::PhysicalDeviceVulkan13Features v13;
    v13.dynamicRendering = VK_TRUE;
    v13.synchronization2 = VK_TRUE;
    v13.maintenance4 = VK_TRUE; // glslang writes LocalSizeId for Vulkan 1.3
    vk::PhysicalDeviceFeatures2 features;
    features.features.fillModeNonSolid = VK_TRUE;
    features.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
    features.pNext = &v13;
    vk::PhysicalDeviceVulkan12Features v12;
    has_int64_atomics_ = supports_int64_atomics(physical_);
    v12.shaderBufferInt64Atomics = has_int64_atomics_ ? VK_TRUE : VK_FALSE;
    features.features.shaderInt64 = has_int64_atomics_ ? VK_TRUE : VK_FALSE;
    has_half_ = supports_half(physical_);
    v12.shaderFloat16 = has_half_ ? VK_TRUE : VK_FALSE;
    compute_units_ = multiprocessors(physical_).value_or(compute_units_);
    v13.pNext = &v12;
    vk::DeviceCreateInfo info({}, queue_info, {}, options.device_extensions, nullptr, &features);
    device_ = {physical_, info};
    queue_ = {device_, queue_family_, 0};
    pipelines_ = std::make_unique<Pipelines>(*this);
}

Device::~Device() {
    if (*device_) {
        // The answer of a lost device is no matter here, and vk::Device would throw it.
        device_.getDispatcher()->vkDeviceWaitIdle(*device_);
    }
}

bool Device::has_fast_half() const {
    return has_half_ && physical_.getProperties().deviceType != vk::PhysicalDeviceType::eCpu;
}

std::uint32_t Device::memory_type(std::uint32_t type_bits, vk::MemoryPropertyFlags wanted,
                                  vk::MemoryPropertyFlags preferred) const {
    for (const vk::MemoryPropertyFlags flags : {wanted | preferred, wanted}) {
        for (std::uint32_t index = 0; index < memory_.memoryTypeCount; ++index) {
            if ((type_bits >> index & 1U) != 0 &&
                (memory_.memoryTypes[index].propertyFlags & flags) == flags) {
                return index;
            }
        }
    }
    throw lutlib::Error("the Vulkan device has no memory of the kind " + vk::to_string(wanted));
}

vk::raii::DeviceMemory Device::allocate(const vk::MemoryAllocateInfo& info) const {
    ++allocation_count_;
    try {
        return {device_, info};
    } catch (const vk::OutOfDeviceMemoryError&) {
        throw lutlib::Error(fmt::format("the GPU has no {} MiB left: choose a smaller --size",
                                        info.allocationSize >> 20U));
    }
}

void Device::run_once(const std::function<void(const vk::raii::CommandBuffer&)>& record) const {
    Commands commands(*this);
    record(commands.begin());
    commands.submit();
    commands.wait();
}

std::vector<std::string> Device::validation_messages() const {
    const std::lock_guard lock(messages_->mutex);
    return messages_->texts;
}

} // namespace preview::gpu
