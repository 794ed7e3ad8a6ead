#include "lutlib/engine/engine_names.h"

#include "lutlib/named.h"

#include <string>

namespace lutlib {
namespace {

constexpr EngineAlias aliases[] = {
    {"ue", "unreal"},
    {"ue4", "unreal"},
    {"ue5", "unreal"},
    {"unrealengine4", "unreal"},
    {"unrealengine5", "unreal"},
    {"unity3d", "unity"},
    {"unityurp", "unity"},
    {"urp", "unity"},
    {"unityhdrp", "unity"},
    {"hdrp", "unity"},
    {"godot4", "godot"},
    {"godotengine", "godot"},
    {"three", "threejs"},
    {"obsstudio", "obs"},
    {"openthreedengine", "o3de"},
    {"open3dengine", "o3de"},
    {"opencolorio", "ocio"},
    {"haldclut", "hald"},
};

std::string plain(std::string_view words) {
    std::string out;
    for (const char c : words) {
        const bool is_capital = c >= 'A' && c <= 'Z';
        if (is_capital || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
            out += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
        }
    }
    return out;
}

} // namespace

std::span<const EngineAlias> engine_aliases() {
    return aliases;
}

const Engine* engine_called(std::string_view words) {
    const std::string asked = plain(words);
    for (const Engine& engine : engines()) {
        if (!asked.empty() && (plain(engine.name) == asked || plain(engine.label) == asked)) {
            return &engine;
        }
    }
    const EngineAlias* const alias = find_named(aliases, asked);
    return alias ? engine_named(alias->engine) : nullptr;
}

const Engine& require_engine(std::string_view words) {
    if (const Engine* const engine = engine_called(words)) {
        return *engine;
    }
    refuse_name("engine", words, name_list(engines()));
}

} // namespace lutlib
