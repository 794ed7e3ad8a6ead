// What lutconv verify finds out about one picture, and how it says it.
#pragma once

#include "converter/subject.h"
#include "lutlib/bake/fitted.h"
#include "lutlib/recipe/placement.h"
#include "lutlib/verify/verify.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace converter {

struct Verdict {
    std::string picture, against; ///< as they were named
    std::string config;           ///< what OpenColorIO converts before the look; empty: nothing
    std::string oracle,
        refusal; ///< who said what is right; why it was not asked of the file itself
    lutlib::LookPlace place{};
    lutlib::Viewing viewing{};
    std::string claimed{}; ///< which of the look's encodings are the picture's word alone
    std::string scale;     ///< how its reading of the file differs by a factor, and why ours counts
    std::optional<lutlib::Verification> result{}; ///< unless the picture has no lattice
    std::optional<lutlib::FittedCheck> fitted{};
    bool lattice = false; ///< the look is read between nodes
    bool passed = false;
};

/// That a bake left the look's conversion out, and what to do.
std::string ignored_text(const lutlib::LookPlace& place, const lutlib::Engine& engine);

/// "passed as Unreal Engine (unreal)". Names the engine, for a picture that is right for one is
/// wrong for most others; so it is with the encoding that the look is taken to be made for.
std::string verdict_text(const Subject& subject, const Verdict& verdict);
/// How the engine came to be named: in JSON, and in a sentence.
struct NamedByWords {
    NamedBy by;
    std::string_view name, words;
};
const NamedByWords& words_of(NamedBy by);
/// Whether everything but the file's chunks is as the engine wants it.
bool is_a_matter_of_tags(const Subject& subject, const Verdict& verdict);

std::string to_text(const Subject& subject, const Verdict& verdict);
nlohmann::ordered_json to_json(const Subject& subject, const Verdict& verdict);

} // namespace converter
