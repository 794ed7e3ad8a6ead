#include "lutlib/io/ocio/transform.h"

#include "lutlib/io/condensed.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lutlib::io {
namespace {

OCIO::Interpolation ocio_interpolation(Interpolation how) {
    switch (how) {
    case Interpolation::trilinear:
        return OCIO::INTERP_LINEAR;
    case Interpolation::tetrahedral:
        return OCIO::INTERP_TETRAHEDRAL;
    case Interpolation::nearest:
        break; // OpenColorIO 2 takes the name and interpolates linearly
    }
    throw UsageError("OpenColorIO cannot evaluate with " + std::string(name_of(how)) +
                     " interpolation; use trilinear or tetrahedral");
}

// Maps the domain to 0..1, where OpenColorIO's tables begin and end.
OCIO::TransformRcPtr domain_matrix(const Domain& domain) {
    std::array<double, 16> matrix{};
    std::array<double, 4> offset{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double min = domain.min[c];
        const double width = static_cast<double>(domain.max[c]) - min;
        matrix[c * 5] = 1 / width;
        offset[c] = -min / width;
    }
    matrix[15] = 1;
    const OCIO::MatrixTransformRcPtr out = OCIO::MatrixTransform::Create();
    out->setMatrix(matrix.data());
    out->setOffset(offset.data());
    return out;
}

} // namespace

OCIO::ConstConfigRcPtr plain_config() {
    // Without a cache of processors, which would answer for a file that has changed since.
    static const OCIO::ConstConfigRcPtr config = [] {
        const OCIO::ConfigRcPtr out = OCIO::Config::CreateRaw()->createEditableCopy();
        out->setProcessorCacheFlags(OCIO::PROCESSOR_CACHE_OFF);
        return out;
    }();
    return config;
}

OCIO::ConstProcessorRcPtr processor_of_transform(const OCIO::ConstTransformRcPtr& transform) {
    return plain_config()->getProcessor(transform);
}

OCIO::ConstProcessorRcPtr processor_at(const std::string& path, const std::string& file,
                                       std::optional<Interpolation> interpolation) {
    const OCIO::FileTransformRcPtr transform = OCIO::FileTransform::Create();
    transform->setSrc(path.c_str());
    transform->setCCCId("0"); // collections hold several corrections; other formats ignore it
    transform->setInterpolation(interpolation ? ocio_interpolation(*interpolation)
                                              : OCIO::INTERP_DEFAULT);
    try {
        OCIO::ConstProcessorRcPtr processor = processor_of_transform(transform);
        OCIO::ClearAllCaches();
        return processor;
    } catch (const OCIO::Exception& e) {
        OCIO::ClearAllCaches();
        throw Error("OpenColorIO cannot read it: " +
                        condensed(reason_of_opencolorio(e.what()), path, file),
                    {file, 0, {}});
    }
}

OCIO::GroupTransformRcPtr group_of_lut(const Lut& lut, Interpolation interpolation) {
    validate(lut);
    const OCIO::GroupTransformRcPtr group = OCIO::GroupTransform::Create();
    if (lut.shaper) {
        if (!lut.shaper->domain.is_unit()) {
            group->appendTransform(domain_matrix(lut.shaper->domain));
        }
        const auto length = static_cast<unsigned long>(lut.shaper->size());
        const OCIO::Lut1DTransformRcPtr curve = OCIO::Lut1DTransform::Create(length, false);
        curve->setInterpolation(OCIO::INTERP_LINEAR);
        curve->setFileOutputBitDepth(OCIO::BIT_DEPTH_F32);
        for (unsigned long i = 0; i < length; ++i) {
            const Rgb& entry = lut.shaper->entries[i];
            curve->setValue(i, entry.r, entry.g, entry.b);
        }
        group->appendTransform(curve);
    }
    if (lut.cube) {
        if (!lut.cube->domain.is_unit()) {
            group->appendTransform(domain_matrix(lut.cube->domain));
        }
        const auto size = static_cast<unsigned long>(lut.cube->size);
        const OCIO::Lut3DTransformRcPtr cube = OCIO::Lut3DTransform::Create(size);
        cube->setInterpolation(ocio_interpolation(interpolation));
        cube->setFileOutputBitDepth(OCIO::BIT_DEPTH_F32);
        for (unsigned long b = 0; b < size; ++b) {
            for (unsigned long g = 0; g < size; ++g) {
                for (unsigned long r = 0; r < size; ++r) {
                    const Rgb& node = lut.cube->nodes[r + size * (g + size * b)];
                    cube->setValue(r, g, b, node.r, node.g, node.b);
                }
            }
        }
        group->appendTransform(cube);
    }
    return group;
}

OCIO::ConstCPUProcessorRcPtr cpu_processor(const OCIO::ConstProcessorRcPtr& processor,
                                           Optimization optimization) {
    return processor->getOptimizedCPUProcessor(
        optimization == Optimization::none ? OCIO::OPTIMIZATION_NONE : OCIO::OPTIMIZATION_LOSSLESS);
}

void transform_in_place(const OCIO::ConstCPUProcessorRcPtr& processor, std::span<Rgb> colors) {
    static_assert(sizeof(Rgb) == 3 * sizeof(float));
    if (colors.empty()) {
        return;
    }
    guarded({}, [&] {
        if (colors.size() == 1) { // an image would be allocated for
            processor->applyRGB(&colors.front().r);
            return;
        }
        OCIO::PackedImageDesc image(colors.data(), static_cast<long>(colors.size()), 1, 3);
        processor->apply(image);
    });
}

Transform transform_of(OCIO::ConstCPUProcessorRcPtr processor) {
    return Transform::batch(
        [processor = std::move(processor)](std::span<RgbD> colors) {
            std::array<Rgb, 1024> part;
            for (std::size_t at = 0; at < colors.size(); at += part.size()) {
                const auto here = colors.subspan(at, std::min(part.size(), colors.size() - at));
                std::transform(here.begin(), here.end(), part.begin(), to_float);
                transform_in_place(processor, std::span(part).first(here.size()));
                std::transform(part.begin(),
                               part.begin() + static_cast<std::ptrdiff_t>(here.size()),
                               here.begin(), to_double);
            }
        },
        Precision::float32);
}

} // namespace lutlib::io
