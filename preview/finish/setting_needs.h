// What settings may need of a run so as to change something in it, by name: a small closed set, of
// which rows of any table name some. Whether a run has them and what is said where it has not are
// rows too, of preview/cli/option_needs.cpp. Plain: any folder may have such rows.
#pragma once

#include "preview/finish/setting_rows.h"

namespace preview {

/// In the order in which they are looked at: the first that is missing is the one that is said.
enum class Need : std::uint8_t {
    // Of every run.
    frame,  ///< not only a list, or a look's cube
    side_a, ///< something is made of side A, or of side B
    side_b,
    picture,   ///< not only what is found out about one
    file,      ///< a picture or a page is written
    listing,   ///< --list is what is answered
    report,    ///< a page of figures is made
    window,    ///< one opens
    cube_view, ///< a look's cube is drawn, or a window may draw it
    // Of a frame, by the command line. What a window can be asked for later is never missing there.
    metered_file, ///< the exposure is set for a picture, not by hand in a window
    terminal,     ///< figures and files are told
    look_a,
    look_b,
    look,
    codes, ///< somebody reads the picture's codes
    still,
    scope,
    scope_levels,     ///< of codes, not of a vectorscope's chroma
    scope_brightness, ///< counts are drawn, not written as numbers
    scope_encoding,
    frame_count,
    sequence,
    output,
    light_output,  ///< a file that holds light
    whole_picture, ///< no instrument and no intermediate instead of it
    no_scope,
    no_intermediate,
    no_heat_map,
    split,
    box,
    heat_map,
    zebra,
    zoom,
    // Parts that are not switched off.
    lights,
    shadows,
    occlusion,
    bloom_part,
    tonemap,
    depth_of_field,
    fxaa,
    dither,
    // Of a frame, by its input.
    scene,
    surroundings_kind, ///< that has this number
    motion,            ///< something moves
    casting_light,
    light, ///< what is shown is no codes already
    light_to_write,
    bloom,
    count, ///< no need: how many there are
};

} // namespace preview
