#include "preview/cli/look_options.h"

#include "lutlib/engine/engine_names.h"
#include "lutlib/error.h"
#include "lutlib/named.h"

namespace preview {

namespace {

std::optional<lutlib::Encoding> if_named(const std::string& name, const std::string& flag) {
    return name.empty() ? std::nullopt : std::optional(encoding_of(name, flag));
}

LookUse use_of(const Options& options, bool has_light, const std::string& engine,
               const std::string& input, const std::string& output) {
    return {.lookup = lookup_of(engine),
            .encodings = {if_named(input, "--look-input"), if_named(output, "--look-output")},
            .picture = picture_codes(options, has_light)};
}

bool is_look(const std::string& path) {
    return !path.empty() && path != "none";
}

} // namespace

const GpuLookup* lookup_of(const std::string& name) {
    if (name.empty()) {
        return nullptr;
    }
    if (const lutlib::Engine* const engine = lutlib::engine_called(name)) {
        return gpu_lookup_named(engine->name);
    }
    return &lutlib::require_named(gpu_lookups(), "lookup", name, lutlib::Letters::any_case);
}

PictureCodes picture_codes(const Options& options, bool has_light) {
    return {encoding_of(options.picture_encoding, "--picture-encoding"), !options.no_convert,
            has_light, options.look_at};
}

LookUse use_a(const Options& options, bool has_light) {
    if (!options.engine_a.empty() && !is_look(options.look_a) && is_look(options.look_b)) {
        throw lutlib::UsageError("side A, which --engine-a is for, has no look: use --engine-b for "
                                 "side B");
    }
    return use_of(options, has_light, options.engine_a, options.look_input_a,
                  options.look_output_a);
}

LookUse use_b(const Options& options, bool has_light) {
    if (!options.engine_b.empty() && !is_look(options.look_b) && is_look(options.look_a)) {
        throw lutlib::UsageError("side B, which --engine is for, has no look: use --engine-a for "
                                 "side A");
    }
    return use_of(options, has_light, options.engine_b, options.look_input_b,
                  options.look_output_b);
}

std::array<std::shared_ptr<const Still>, 2> stills_of(const Options& options) {
    std::array<std::shared_ptr<const Still>, 2> out;
    const std::optional<lutlib::Encoding> said =
        if_named(options.still_encoding, "--still-encoding");
    const auto load = [&](const std::string& path, const std::string& look, const char* side) {
        if (path.empty()) {
            return std::shared_ptr<const Still>();
        }
        if (is_look(look)) {
            throw lutlib::UsageError(std::string("a side shows a look or a still: drop --") + side +
                                     " or --still-" + side);
        }
        return load_still(path, said);
    };
    out[0] = load(options.still_a, options.look_a, "a");
    out[1] = load(options.still_b, options.look_b, "b");
    return out;
}

Shown shown_of(const Options& options) {
    Shown shown = load_shown(options.input, options.seconds);
    if (const std::string file = surroundings_file(options); !file.empty()) {
        load_surroundings(shown, file);
    }
    return shown;
}

} // namespace preview
