// What options need of a run so as to change something in it: a row for each Need.
#pragma once

#include "preview/cli/option_rows.h"
#include "preview/finish/setting_needs.h"

namespace preview {

/// What is known once the input has been read.
struct KnownInput {
    const Scene* scene = nullptr; ///< null: a picture is shown
    bool has_codes = false;       ///< its numbers are for a display already
};

/// An option of a run, whether or not it was given there.
struct OptionInRun {
    const Options& options;
    std::string_view name = {}; ///< as "--split"
    /// Null as long as only the command line is known; both or neither.
    const KnownInput* input = nullptr;
    const FrameSettings* settings = nullptr;
};

struct NeedRow {
    enum class When : std::uint8_t {
        always,
        frame, ///< where one is rendered or a window opens
        input, ///< where the input is known
    };

    Need need;
    When when = When::frame;
    /// Null: always, but for what --without switches off.
    bool (*is_met)(const OptionInRun& option) = nullptr;
    std::string_view why_not = {};
    /// In place of `why_not`, where that differs from run to run.
    std::string (*tell)(const OptionInRun& option) = nullptr;
    std::string_view without = {}; ///< what of --without switches it off
    /// What a frame calls what it then withholds, for a reason of its own.
    std::string_view part = {};
    /// Whether the option asks for that part. Null: always.
    bool (*asks)(const OptionInRun& option) = nullptr;
};

/// In the order of the enumeration.
std::span<const NeedRow> need_rows();

bool is_met(const NeedRow& row, const OptionInRun& option);
/// Why it is not: "no --scope is shown".
std::string why_not_met(const NeedRow& row, const OptionInRun& option);

/// The first that the option needs and this run has not; null: it has all, as far as is known.
const NeedRow* first_missing(Needs needs, const OptionInRun& option);

/// Whether --without names it.
bool is_without(const Options& options, std::string_view name);

/// Whether a side's look is one.
bool names_look(const std::string& path);

/// Whether the output is of a type that holds light and never codes: OpenEXR, Radiance.
bool output_holds_light(const Options& options);

/// Whether the output is the counts of the scope that is shown, as CSV.
bool writes_counts(const Options& options);

/// "a", "a and b", "a, b and c".
std::string enumerated(const std::vector<std::string>& items, std::string_view last);

} // namespace preview
