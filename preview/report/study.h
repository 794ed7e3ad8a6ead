// What a report asks about one pass: its settings, and what each of them costs in error and time.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/transform.h"
#include "preview/report/errors.h"
#include "preview/report/renderer.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace preview::report {

/// The look that lookups read, and what it is exactly.
struct StudiedLook {
    std::string name;
    std::shared_ptr<const lutlib::Lut> table;
    lutlib::Transform exact;
};
/// More saturated and with more contrast, as a lattice of 33 nodes and by its formula.
StudiedLook usual_studied_look();

/// What studies are made with.
struct StudyTools {
    Renderer& renderer;
    StudiedLook look;
    /// Sides of what stands for converged; smaller on a software device.
    std::uint32_t converged_shadow_size() const { return renderer.is_cpu() ? 4096 : 8192; }
    Size converged_surroundings() const {
        return renderer.is_cpu() ? Size{128, 64} : Size{256, 128};
    }
};

/// One way to run the pass.
struct Variant {
    std::string name;
    std::function<void(Situation&)> set;
    bool is_usual = false; ///< as the program runs it unless it is told otherwise
    /// It aims at the same picture as the usual one, so that a budget may choose it.
    bool is_choice = true;
};

/// What a variant should have given.
struct Truth {
    reference::Image finished, result;
};

struct TruthRequest {
    const StudyTools& tools;
    const Situation& base; ///< without any variant's changes, as prepared
    const Variant& variant;
    const Situation& varied;
    /// What the variant has given; its light is what its pass has read.
    const Frame& frame;
};

struct Study {
    std::string_view name, title;
    std::string_view help;      ///< what is varied and what is compared
    std::string_view reference; ///< what it is held against, a sentence
    /// Why the input has nothing of it; empty: it has.
    std::string_view (*none_because)(const Situation& situation);
    std::vector<Variant> (*variants)(const Situation& situation, const StudyTools& tools);
    /// Null: what converge() gives, rendered.
    Truth (*truth)(const TruthRequest& request) = nullptr;
    Counts counts = nullptr;
    Looked looked{};
    /// Leaves out of the frame what would hide the pass or is not part of its reference.
    void (*prepare)(Situation& situation) = nullptr;
    /// Variants with the same text have the same truth; null: all have.
    std::string (*truth_key)(const Situation& varied, const Variant& variant) = nullptr;
    bool is_truth_slow = false;       ///< that of many pixels; a turn is then made of few alone
    bool takes_test_pictures = false; ///< else the input alone
    /// Whether a budget's choice may vary it; null: it may.
    bool (*is_budgeted)(const Situation& situation) = nullptr;
    /// Sets what stands for converged, of one that has settings for it.
    void (*converge)(Situation& situation, const StudyTools& tools) = nullptr;
};

/// In the order of the frame.
std::vector<const Study*> studies();

/// The rows, each in a file of its own.
extern const Study bloom_study, occlusion_study, shadow_study, area_light_study, surroundings_study,
    depth_of_field_study, surface_study, lookup_study, antialiasing_study, effect_study;

/// The finished picture of the situation, rendered `times` as large and averaged in double.
reference::Image supersampled(Renderer& renderer, const Situation& situation, int times);
/// How many times as large a reference is that stands for every place within a pixel.
inline constexpr int supersamples = 4;

} // namespace preview::report
