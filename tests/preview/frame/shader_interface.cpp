#include "tests/preview/frame/shader_interface.h"

#include <memory>
#include <span>
#include <spirv_cross/spirv_cross_c.h>
#include <stdexcept>
#include <string>

namespace preview {

namespace {

void expect(spvc_result result, const gpu::ShaderCode& shader) {
    if (result != SPVC_SUCCESS) {
        throw std::runtime_error("SPIRV-Cross cannot read " + std::string(shader.name));
    }
}

class Reflection {
  public:
    explicit Reflection(const gpu::ShaderCode& shader) : shader_(shader) {
        spvc_context context = nullptr;
        expect(spvc_context_create(&context), shader);
        context_.reset(context);
        spvc_parsed_ir ir = nullptr;
        expect(spvc_context_parse_spirv(context, shader.words.data(), shader.words.size(), &ir),
               shader);
        expect(spvc_context_create_compiler(context, SPVC_BACKEND_NONE, ir,
                                            SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler_),
               shader);
        expect(spvc_compiler_create_shader_resources(compiler_, &resources_), shader);
    }

    ShaderInterface read() const {
        ShaderInterface out;
        add(out, SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, BindingType::sampled_image);
        add(out, SPVC_RESOURCE_TYPE_STORAGE_IMAGE, BindingType::storage_image);
        add(out, SPVC_RESOURCE_TYPE_STORAGE_BUFFER, BindingType::storage_buffer);
        add(out, SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, BindingType::uniform_buffer);
        for (const spvc_reflected_resource& block : list(SPVC_RESOURCE_TYPE_PUSH_CONSTANT)) {
            std::size_t bytes = 0;
            expect(spvc_compiler_get_declared_struct_size(
                       compiler_, spvc_compiler_get_type_handle(compiler_, block.base_type_id),
                       &bytes),
                   shader_);
            out.push_bytes = static_cast<std::uint32_t>(bytes);
        }
        const spvc_specialization_constant* constants = nullptr;
        std::size_t count = 0;
        expect(spvc_compiler_get_specialization_constants(compiler_, &constants, &count), shader_);
        for (const spvc_specialization_constant& constant : std::span(constants, count)) {
            out.constants.insert(constant.constant_id);
        }
        return out;
    }

  private:
    struct Destroy {
        void operator()(spvc_context context) const { spvc_context_destroy(context); }
    };

    std::span<const spvc_reflected_resource> list(spvc_resource_type type) const {
        const spvc_reflected_resource* first = nullptr;
        std::size_t count = 0;
        expect(spvc_resources_get_resource_list_for_type(resources_, type, &first, &count),
               shader_);
        return {first, count};
    }

    void add(ShaderInterface& out, spvc_resource_type kind, BindingType type) const {
        for (const spvc_reflected_resource& resource : list(kind)) {
            const auto decoration = [&](SpvDecoration name) {
                return spvc_compiler_get_decoration(compiler_, resource.id, name);
            };
            ShaderBinding binding;
            binding.type = type;
            if (type == BindingType::sampled_image || type == BindingType::storage_image) {
                const spvc_type image = spvc_compiler_get_type_handle(compiler_, resource.type_id);
                binding.volume = spvc_type_get_image_dimension(image) == SpvDim3D;
                binding.array = spvc_type_get_image_arrayed(image);
                binding.integer =
                    spvc_type_get_basetype(spvc_compiler_get_type_handle(
                        compiler_, spvc_type_get_image_sampled_type(image))) != SPVC_BASETYPE_FP32;
            }
            const std::uint32_t number = decoration(SpvDecorationBinding);
            if (decoration(SpvDecorationDescriptorSet) != 0 ||
                !out.bindings.emplace(number, binding).second) {
                throw std::runtime_error(std::string(shader_.name) + ": " + resource.name +
                                         " is outside of set 0 or shares its number");
            }
        }
    }

    const gpu::ShaderCode& shader_;
    std::unique_ptr<spvc_context_s, Destroy> context_;
    spvc_compiler compiler_ = nullptr;
    spvc_resources resources_ = nullptr;
};

} // namespace

ShaderInterface interface_of(const gpu::ShaderCode& shader) {
    return Reflection(shader).read();
}

} // namespace preview
