// The line under the picture. In a narrow window it has less, and its tip the rest.
#pragma once

#include "preview/finish/probe.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace preview::panels {

enum class ToldDifferences : std::uint8_t { none, of_b, all };

/// What of a place the line has beside side B's codes.
struct StatusForm {
    bool place = false, values = false, before = false, a = false;
    ToldDifferences differences = ToldDifferences::none;
    bool is_without_a = false; ///< only where A has no look: it would say "before" again
};

/// From all that there is to the least.
std::span<const StatusForm> status_forms();

/// The first that fits, else the last.
const StatusForm& status_form(float width, bool has_a,
                              const std::function<float(const StatusForm& form)>& width_of);

struct StatusPart {
    std::string name, text;
    bool is_dim = false;
    const lutlib::RgbD* color = nullptr; ///< shown before the text; null: none is
    std::string values{};                ///< behind the text
};

/// What the line has in that form; colours are the probe's.
std::vector<StatusPart> status_parts(const StatusForm& form, ProbePlace at, const Probe& probe);

} // namespace preview::panels
