// Renders without a window: into a file, or for its timings.
#pragma once

#include "preview/cli/options_unused.h"
#include "preview/frame/settings.h"
#include "preview/graph/execute.h"

#include <string>
#include <vector>

namespace preview {

struct Rendered {
    Size size;
    std::vector<std::uint8_t> rgba; ///< the output, rows from the top
    std::vector<float> values;      ///< the same in floats, where its format has them
    std::vector<float> hdr;         ///< four a pixel, when the settings keep it
    Size hdr_size;
    std::optional<DifferenceFigures> figures; ///< of a difference
    float heat_scale = 0;                     ///< dE2000 at the end of its heat map
    std::vector<std::uint32_t> scope_counts;  ///< of the scope, when the settings keep them
    std::optional<Probe> probe;               ///< of the place that the settings name
    std::string explanation;                  ///< what was kept and left out
    std::vector<Withheld> withheld;           ///< of it what the frame withheld
};

/// One frame. What depends on measurements (bloom) is measured in a first frame and decided in a
/// second.
Rendered render_frame(Executor& executor, const FrameInputs& inputs, const FrameSettings& settings);

struct PassTiming {
    std::string name;
    double median = 0, p95 = 0; ///< milliseconds
};
struct Timings {
    int frames = 0;
    std::vector<PassTiming> passes; ///< in order; several passes of one name are added up
    PassTiming gpu;                 ///< the whole frame by the GPU's clock
    PassTiming wall;                ///< from the declaration of a frame to its end, on the CPU
    std::vector<Withheld> withheld; ///< by the frame
};

/// Why a frame that has withheld these has nothing of this name to show, with the remedy.
std::string why_not_shown(const std::string& name, const std::vector<Withheld>& withheld);

/// A sentence for each part that a person has asked for and the frame has withheld.
std::vector<std::string> left_out(const std::vector<AskedPart>& asked,
                                  const std::vector<Withheld>& withheld);

/// Medians over `frames` frames after a warm-up.
Timings time_frames(Executor& executor, const FrameInputs& inputs, const FrameSettings& settings,
                    int frames);

std::string to_table(const Timings& timings);
std::string to_json(const Timings& timings, const std::string& device, Size size);

/// What one run without a window has to say.
struct Report {
    std::optional<Probe> probe;
    ProbePlace place;
    std::optional<DifferenceFigures> figures;
    std::string explanation; ///< lines
    std::optional<Timings> timings;
    std::string device;
    Size size; ///< of what was timed
};

/// For people: the explanation, the probe, the figures and the timings, one after the other.
std::string to_text(const Report& report);
/// One document: the timings' or else the probe's own keys, and a member for each of the rest.
std::string to_json(const Report& report);

} // namespace preview
