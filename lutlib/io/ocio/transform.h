// Between lutlib's types and OpenColorIO's, inside the module.
#pragma once

#include "lutlib/io/ocio.h"

#include "lutlib/error.h"

#include <OpenColorIO/OpenColorIO.h>

#include <optional>
#include <span>
#include <string>

namespace lutlib::io {

namespace OCIO = OCIO_NAMESPACE;

/// Runs `action`; an exception of OpenColorIO becomes an Error of `file`.
template <class Action>
auto guarded(const std::string& file, Action&& action) {
    try {
        return action();
    } catch (const OCIO::Exception& e) {
        throw Error(std::string("OpenColorIO: ") + e.what(), {file, 0, {}});
    }
}

/// What OpenColorIO reads at a path, as a processor of everything in it, not yet optimised. `file`
/// names it in errors. `interpolation` is of cubes for which the file names none; unset: they say
/// that none is named. Throws Error.
OCIO::ConstProcessorRcPtr processor_at(const std::string& path, const std::string& file,
                                       std::optional<Interpolation> interpolation);

/// Matrix, curve, matrix, cube, as far as the look needs them.
OCIO::GroupTransformRcPtr group_of_lut(const Lut& lut, Interpolation interpolation);

OCIO::ConstProcessorRcPtr processor_of_transform(const OCIO::ConstTransformRcPtr& transform);

OCIO::ConstCPUProcessorRcPtr cpu_processor(const OCIO::ConstProcessorRcPtr& processor,
                                           Optimization optimization);
/// Replaces every colour by its image.
void transform_in_place(const OCIO::ConstCPUProcessorRcPtr& processor, std::span<Rgb> colors);
/// The same for colours of any origin.
Transform transform_of(OCIO::ConstCPUProcessorRcPtr processor);

/// The config in which every transform is evaluated: nothing in it but OpenColorIO's defaults.
OCIO::ConstConfigRcPtr plain_config();

} // namespace lutlib::io
