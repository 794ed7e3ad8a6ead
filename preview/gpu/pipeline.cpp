#include "preview/gpu/pipeline.h"

#include "lutlib/named.h"
#include "preview/gpu/memory.h"
#include "preview/gpu/shaders.h"

#include <stdexcept>

namespace preview::gpu {

namespace {

struct SamplerInfo {
    vk::Filter filter;
    vk::SamplerAddressMode address;
    bool compare;
};

/// In the order of the enumeration Sampler.
constexpr SamplerInfo sampler_infos[] = {
    {vk::Filter::eNearest, vk::SamplerAddressMode::eClampToEdge, false},
    {vk::Filter::eLinear, vk::SamplerAddressMode::eClampToEdge, false},
    {vk::Filter::eLinear, vk::SamplerAddressMode::eClampToBorder, false},
    {vk::Filter::eLinear, vk::SamplerAddressMode::eRepeat, false},
    {vk::Filter::eLinear, vk::SamplerAddressMode::eClampToEdge, true},
};
static_assert(std::size(sampler_infos) == sampler_count);

vk::CullModeFlags cull_mode(RasterState::Cull cull) {
    switch (cull) {
    case RasterState::Cull::back:
        return vk::CullModeFlagBits::eBack;
    case RasterState::Cull::front:
        return vk::CullModeFlagBits::eFront;
    case RasterState::Cull::none:
        break;
    }
    return vk::CullModeFlagBits::eNone;
}

} // namespace

vk::DescriptorType descriptor_type(BindingType type) {
    switch (type) {
    case BindingType::sampled_image:
        return vk::DescriptorType::eCombinedImageSampler;
    case BindingType::storage_image:
        return vk::DescriptorType::eStorageImage;
    case BindingType::uniform_buffer:
        return vk::DescriptorType::eUniformBuffer;
    case BindingType::storage_buffer:
    case BindingType::none:
        break;
    }
    return vk::DescriptorType::eStorageBuffer;
}

Pipelines::Pipelines(const Device& device) : device_(device) {
    for (const SamplerInfo& info : sampler_infos) {
        vk::SamplerCreateInfo create({}, info.filter, info.filter, vk::SamplerMipmapMode::eNearest,
                                     info.address, info.address, info.address);
        create.borderColor = vk::BorderColor::eFloatTransparentBlack;
        create.compareEnable = info.compare ? VK_TRUE : VK_FALSE;
        create.compareOp = vk::CompareOp::eLessOrEqual;
        samplers_.emplace_back(device.vk(), create);
    }
}

const vk::raii::ShaderModule& Pipelines::module_of(const std::string& shader) {
    const auto known = modules_.find(shader);
    if (known != modules_.end()) {
        return known->second;
    }
    const ShaderCode* const found = lutlib::find_named(shaders(), shader);
    if (found == nullptr) {
        throw std::logic_error("internal error: no shader is named '" + shader + "'");
    }
    const vk::ShaderModuleCreateInfo info({}, found->words.size_bytes(), found->words.data());
    return modules_.emplace(shader, vk::raii::ShaderModule(device_.vk(), info)).first->second;
}

const Pipeline& Pipelines::get(const PipelineKey& key) {
    const auto known = pipelines_.find(key);
    if (known != pipelines_.end()) {
        return known->second;
    }
    return pipelines_.emplace(key, make(key)).first->second;
}

/// The stages that run, and what they see.
Pipeline Pipelines::with_layout(const PipelineKey& key) const {
    Pipeline made;
    made.stages = vk::ShaderStageFlagBits::eCompute;
    if (key.raster) {
        made.stages = vk::ShaderStageFlagBits::eVertex;
        if (!key.fragment_shader.empty()) {
            made.stages |= vk::ShaderStageFlagBits::eFragment;
        }
    }

    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::size_t index = 0; index < key.bindings.size(); ++index) {
        bindings.emplace_back(static_cast<std::uint32_t>(index),
                              descriptor_type(key.bindings[index]), 1, made.stages);
    }
    made.set_layout = {device_.vk(), vk::DescriptorSetLayoutCreateInfo({}, bindings)};
    const vk::PushConstantRange range(made.stages, 0, key.push_bytes);
    vk::PipelineLayoutCreateInfo layout_info({}, *made.set_layout);
    if (key.push_bytes > 0) {
        layout_info.setPushConstantRanges(range);
    }
    made.layout = {device_.vk(), layout_info};
    return made;
}

vk::raii::Pipeline
Pipelines::graphics(const PipelineKey& key, vk::PipelineLayout layout,
                    const std::vector<vk::PipelineShaderStageCreateInfo>& stages) {
    // Vertices are pulled from storage buffers by gl_VertexIndex.
    const vk::PipelineVertexInputStateCreateInfo vertex_input;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({},
                                                            vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.polygonMode = key.state.draws_lines ? vk::PolygonMode::eLine : vk::PolygonMode::eFill;
    raster.cullMode = cull_mode(key.state.cull);
    raster.frontFace = vk::FrontFace::eCounterClockwise;
    raster.lineWidth = 1;
    raster.depthBiasEnable =
        key.state.depth_bias_constant != 0 || key.state.depth_bias_slope != 0 ? VK_TRUE : VK_FALSE;
    raster.depthBiasConstantFactor = key.state.depth_bias_constant;
    raster.depthBiasSlopeFactor = key.state.depth_bias_slope;
    const vk::PipelineMultisampleStateCreateInfo multisample;
    const vk::PipelineDepthStencilStateCreateInfo depth(
        {}, key.state.depth_test ? VK_TRUE : VK_FALSE, key.state.depth_write ? VK_TRUE : VK_FALSE,
        vk::CompareOp::eLessOrEqual);
    const vk::PipelineColorBlendAttachmentState over(
        key.state.blends ? VK_TRUE : VK_FALSE, vk::BlendFactor::eOne,
        vk::BlendFactor::eOneMinusSrcAlpha, vk::BlendOp::eAdd, vk::BlendFactor::eOne,
        vk::BlendFactor::eOneMinusSrcAlpha, vk::BlendOp::eAdd,
        vk::FlagTraits<vk::ColorComponentFlagBits>::allFlags);
    const std::vector<vk::PipelineColorBlendAttachmentState> blends(key.colors.size(), over);
    const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, {}, blends);
    const vk::DynamicState dynamics[] = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamics);
    std::vector<vk::Format> color_formats;
    for (const std::optional<Format>& format : key.colors) {
        color_formats.push_back(format ? vk_format(*format) : vk::Format::eUndefined);
    }
    const vk::PipelineRenderingCreateInfo rendering(
        0, color_formats, key.depth ? vk_format(*key.depth) : vk::Format::eUndefined);
    const vk::GraphicsPipelineCreateInfo info(
        {}, stages, &vertex_input, &assembly, nullptr, &viewport, &raster, &multisample, &depth,
        &blend, &dynamic, layout, nullptr, 0, nullptr, -1, &rendering);
    return {device_.vk(), nullptr, info};
}

Pipeline Pipelines::make(const PipelineKey& key) {
    Pipeline made = with_layout(key);

    std::vector<vk::SpecializationMapEntry> entries;
    for (std::uint32_t id = 0; id < key.constants.size(); ++id) {
        entries.emplace_back(id, id * 4, 4);
    }
    const vk::SpecializationInfo constants(static_cast<std::uint32_t>(entries.size()),
                                           entries.data(), key.constants.size() * 4,
                                           key.constants.data());
    const auto stage = [&](vk::ShaderStageFlagBits bit, const std::string& shader) {
        return vk::PipelineShaderStageCreateInfo({}, bit, *module_of(shader), "main", &constants);
    };

    if (!key.raster) {
        const vk::ComputePipelineCreateInfo info(
            {}, stage(vk::ShaderStageFlagBits::eCompute, key.shader), *made.layout);
        made.pipeline = {device_.vk(), nullptr, info};
        return made;
    }

    std::vector<vk::PipelineShaderStageCreateInfo> stages{
        stage(vk::ShaderStageFlagBits::eVertex, key.shader)};
    if (!key.fragment_shader.empty()) {
        stages.push_back(stage(vk::ShaderStageFlagBits::eFragment, key.fragment_shader));
    }
    made.pipeline = graphics(key, *made.layout, stages);
    return made;
}

} // namespace preview::gpu
