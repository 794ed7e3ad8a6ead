// Pipelines made on first use and kept, with the samplers that all of them share.
#pragma once

#include "preview/gpu/device.h"
#include "preview/gpu/types.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace preview::gpu {

/// All that a pipeline depends on. A compute pipeline has neither fragment shader nor targets.
struct PipelineKey {
    std::string shader;
    std::string fragment_shader;
    bool raster = false;
    std::vector<BindingType> bindings;
    std::vector<std::uint32_t> constants; ///< specialisation constants 0, 1, 2...
    std::uint32_t push_bytes = 0;
    RasterState state;
    std::vector<std::optional<Format>> colors; ///< none: the shader's output is thrown away
    std::optional<Format> depth;

    friend auto operator<=>(const PipelineKey&, const PipelineKey&) = default;
};

struct Pipeline {
    vk::raii::DescriptorSetLayout set_layout = nullptr;
    vk::raii::PipelineLayout layout = nullptr;
    vk::raii::Pipeline pipeline = nullptr;
    vk::ShaderStageFlags stages;
};

vk::DescriptorType descriptor_type(BindingType type);

class Pipelines {
  public:
    explicit Pipelines(const Device& device);

    /// The pipeline of that key; the reference stays good. Throws std::logic_error for a shader
    /// that is not embedded.
    const Pipeline& get(const PipelineKey& key);
    vk::Sampler sampler(Sampler kind) const { return *samplers_[static_cast<std::size_t>(kind)]; }
    std::size_t size() const { return pipelines_.size(); }

  private:
    const vk::raii::ShaderModule& module_of(const std::string& shader);
    Pipeline with_layout(const PipelineKey& key) const;
    vk::raii::Pipeline graphics(const PipelineKey& key, vk::PipelineLayout layout,
                                const std::vector<vk::PipelineShaderStageCreateInfo>& stages);
    Pipeline make(const PipelineKey& key);

    const Device& device_;
    std::vector<vk::raii::Sampler> samplers_;
    std::map<std::string, vk::raii::ShaderModule> modules_;
    std::map<PipelineKey, Pipeline> pipelines_;
};

} // namespace preview::gpu
