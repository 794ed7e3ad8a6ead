// The panels of the window, drawn with Dear ImGui. They change the model and ask for commands; they
// know no GPU object.
#pragma once

#include "lutlib/io/look.h"
#include "preview/editor/keys.h"
#include "preview/editor/model.h"
#include "preview/finish/picked_color.h"
#include "preview/finish/probe.h"
#include "preview/panels/camera_list.h"
#include "preview/panels/errors.h"
#include "preview/panels/exporting.h"
#include "preview/panels/file_dialog.h"
#include "preview/panels/look_strip.h"
#include "preview/panels/look_use.h"
#include "preview/panels/rect.h"
#include "preview/panels/scopes_shown.h"
#include "preview/panels/thumbnail.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace preview::panels {

using namespace editor;

struct PassTime {
    std::string name;
    double milliseconds = 0;
};

/// What a finished frame has told; empty where it was not asked.
struct Measured {
    std::optional<DifferenceFigures> figures;
    std::optional<Probe> probe;             ///< of the texel that was pointed at
    std::vector<std::uint32_t> axis_counts; ///< before the looks (preview/finish/curve_counts.h)
    friend bool operator==(const Measured&, const Measured&) = default;
};

/// What the panels show and do not change.
struct Facts {
    std::string device, input;
    std::vector<std::string> left_out;          ///< of the input, by its import
    std::vector<std::string> told;              ///< what was made of its pictures' colours
    std::vector<std::string> surroundings_told; ///< of those, the surroundings'
    std::vector<NamedCamera> cameras;           ///< of a model's file
    std::vector<Option> debug_views;            ///< intermediates that can be shown
    bool is_scene = true;                       ///< there is a camera to move
    Orbit usual_orbit;                          ///< as the scene has it
    std::vector<PointLight> usual_lights;       ///< likewise
    bool has_surroundings_picture = false;
    Size picture_size;            ///< of a picture
    bool display_encoded = false; ///< there is nothing to tone map
    double bake_milliseconds = 0;
    Measured measured;
    std::array<std::string, 2> look_notes;     ///< how exactly each side stands for the recipe
    std::array<std::string, 2> look_standings; ///< where each stands and what it is fed
    std::array<std::shared_ptr<const lutlib::Lut>, 2> tables; ///< of the sides; null: no look
    /// What the codes are that are shown of the sides.
    std::array<lutlib::Encoding, 2> shown_codes{lutlib::srgb(), lutlib::srgb()};
    std::vector<PassTime> passes;
    std::optional<ScopeLevels> frozen_levels; ///< of the scopes while they are frozen
    std::string no_scopes;   ///< why those that are asked for count nothing; empty: they do
    std::string explanation; ///< a line for each pass, kept or left out, and why
};

/// A key that went down.
struct KeyPress {
    Key key = Key::none;
    bool ctrl = false, shift = false;
};

/// A colour of the picture that is to be clicked, see eyedropper.h.
struct Pick {
    std::string words; ///< what it is for
    std::function<void(struct Ui& ui, const Probe& probe)> use;
    std::optional<ProbePlace> place{}; ///< where it was clicked; empty: not yet
    int frames = 0;                    ///< since then
};

/// Of a place of the picture's part of the window; without one of the picture's mean.
struct Metering {
    std::optional<ProbePlace> place{};
};

struct Ui {
    explicit Ui(State first) : history(std::move(first)) {}

    History history;
    Facts facts;
    Errors errors;                    ///< shown until they are closed
    std::string report;               ///< of the last export
    std::vector<std::string> notices; ///< why what is shown is not what files have now
    /// The recipe's file as it has changed beside unsaved changes; null: there is nothing to
    /// choose.
    std::shared_ptr<const lutlib::io::Look> offered;
    /// Files of looks that windows ended with, which nobody has taken or dropped yet.
    std::vector<std::string> left_behind;
    std::string take_left, drop_left; ///< chosen among them, for the program; empty: none
    std::string engine_folder; ///< where strips go at the press of a key; empty: nobody named one
    std::string exported;      ///< what went there and what that lost, till it is closed
    bool wants_new_screen = false; ///< everything on the GPU shall be made anew
    /// What the exposure shall be metered of, for the program; empty: nothing.
    std::optional<Metering> metering;
    /// How large text and controls are, times the desktop's; the program keeps it in its range.
    float text_scale = 1;
    float panels_width = 0; ///< in heights of the text; 0: nobody has chosen one
    std::size_t panel = 0;  ///< which one is seen
    bool shows_help = false;
    bool shows_palette = false;
    std::string palette_text;      ///< what is typed in it
    std::size_t palette_at = 0;    ///< the row that Enter does
    bool asks_to_quit = false;     ///< there is work that no file has
    bool quits_when_saved = false; ///< as soon as a file has it
    bool quits = false;
    bool shows_passes = false; ///< set by the passes panel while it is seen: timings are wanted
    bool shows_curves = false; ///< set by curve editors: counts along their axes are wanted
    LookUse look;
    LookStrip look_strip;
    Thumbnails thumbnails;
    std::optional<Pick> pick;
    std::optional<ProbePlace> pointer; ///< the pixel of the picture's place under the mouse
    std::string status_told;           ///< all of what was pointed at last; empty: nothing was
    Rect picture_place;                ///< in the last frame
    std::string debug_view;            ///< the intermediate that is shown; empty: the picture
    double seconds = 0;                ///< the moment of the scene
    bool plays = false;                ///< time goes on by itself
    CameraList cameras;
    std::vector<PickedColor> picked;           ///< the newest first
    float display_white = usual_display_white; ///< cd/m2, for which luminances are told
    ScopesShown scopes_shown;
    const Compare* held = nullptr; ///< shown instead while a key is held
    /// Since the last frame: no press is lost, however short.
    std::vector<KeyPress> pressed;
    std::array<bool, key_count> down{}; ///< which keys are held
    /// Files to open as look or picture, for the program to take.
    std::vector<std::string> to_open;
    std::string surround_with;   ///< a picture to put about the scene; empty: none
    std::string save_picture_to; ///< where the program shall save the picture; empty: nowhere
    int picture_width = 0; ///< of a picture that is saved; 0: its own, of a scene as it is seen
    /// With picture_width, in the proportions that are seen.
    Size picture_size() const;
    /// Waits for "replace?"; empty: nothing does.
    std::string to_replace;
    std::function<void()> replace;
    /// Where controls are, by name: for scripts that press them.
    std::map<std::string, Rect> places;

    std::string recipe_file, lut_file, strip_file, open_file, picture_file;
    Exporting exporting;
    std::function<void()> wake; ///< the window for a frame, from any thread
    FileDialog file_dialog;
    std::string last_folder;         ///< in which a file was chosen; empty: none was
    std::vector<std::string> recent; ///< files opened or saved last, the newest first
    std::string search;              ///< typed into the list that is open
    std::size_t export_engine = 0;   ///< of engine_lookups()
};

/// Does `action`; what it throws becomes an error in the window, and the state is as before.
void attempt(Ui& ui, const std::function<void()>& action);
/// Asks before `action` writes over a file.
void attempt_writing(Ui& ui, const std::string& path, std::function<void()> action);

/// The look's strip, for the engine of the panel Files, into the engine's folder.
void export_to_engine(Ui& ui);

/// Saves the recipe to its file; asks first where that has none, or changed since.
void save(Ui& ui);
/// Whether a question waits that a command has led to.
bool asks_anything(const Ui& ui);
/// Ends the window, or asks while there is work that no file has.
void ask_to_quit(Ui& ui);

/// Everything over the picture; returns the part of the window that is left for the picture.
Rect draw(Ui& ui);

// The parts.
void look_panel(Ui& ui);
void view_panel(Ui& ui);
void scene_panel(Ui& ui);
void file_panel(Ui& ui);
void passes_panel(Ui& ui);
void scopes_panel(Ui& ui);
void cube_panel(Ui& ui);
void versions_panel(Ui& ui);
void colors_panel(Ui& ui);
/// The next click on the picture is for what shall be 18 % grey.
void start_metering(Ui& ui);
/// A picture to put about the scene.
void ask_for_surroundings(Ui& ui);
/// Keeps the colour under the mouse.
void pick_color(Ui& ui);
void dialogs(Ui& ui);
void closing_dialog(Ui& ui);
/// The list of keys, while it is asked for.
void help_window(Ui& ui);
/// What a person must know of files and of what is shown, above the panels.
void notices(Ui& ui);
void handle_shortcuts(Ui& ui);
/// What the levels of the scopes stand for.
ScopeLevels scope_levels(const Ui& ui);
/// The scopes that are seen, side by side.
void scope_strip(Ui& ui, const Rect& area);
/// The colour under the mouse.
void status_line(Ui& ui, const Rect& area);
/// Mouse on the picture: the split line, the camera, what is seen of it, the colour under it.
void picture_area(Ui& ui, const Rect& area);
/// The largest part of `area`, in its middle, that shows all of the picture as it is; all of it for
/// a scene and for a part of a picture.
Rect fitted(const Ui& ui, const Rect& area);
/// So many pixels to one of the picture about the mouse, else about the middle; 0: all of it.
void zoom_to(Ui& ui, float scale);

/// Texts one below the other, wrapped.
void lines(const std::vector<std::string>& texts);
/// The same of what reading has told, each with a place of its own, by number.
void told_lines(Ui& ui, const std::vector<std::string>& texts, const std::string& place);

/// What the tabs are called, in their order.
std::vector<std::string> panel_names();

/// So many heights of the text, in the window's pixels.
float em(float heights);

/// Remembers where the last item is; the name without blanks.
void mark(Ui& ui, std::string name);
/// Remembers where the window is that is being drawn.
void mark_window(Ui& ui, const std::string& name);

} // namespace preview::panels
