#include "preview/panels/actions.h"

#include "preview/editor/commands.h"
#include "preview/editor/reload.h"
#include "preview/editor/solo.h"
#include "preview/editor/versions.h"

#include <algorithm>
#include <cmath>

namespace preview::panels {

namespace {

void compare_by(Ui& ui, const Compare& row) {
    ui.history.draft().compare = &row;
}

template <int steps>
void scale_text(Ui& ui) {
    constexpr float step = 1.1F;
    ui.text_scale = steps == 0 ? 1 : steps > 0 ? ui.text_scale * step : ui.text_scale / step;
}

/// Of the table, around it.
void next_view(Ui& ui) {
    const auto views = picture_views();
    const PictureView*& view = ui.history.draft().picture_view;
    view = &views[(static_cast<std::size_t>(index_of(*view)) + 1) % views.size()];
}

void close_all(Ui& ui) {
    ui.shows_help = ui.shows_palette = false;
    ui.errors.clear();
    ui.exported.clear();
    ui.to_replace.clear();
    ui.pick.reset();
    ui.scopes_shown.region_drag.reset();
    ui.asks_to_quit = false;
    ui.file_dialog = {};
    ui.exporting.ready.reset();
}

void store(Ui& ui, std::size_t place) {
    store_version(ui.history.draft(), place);
}

void say_if_none(Ui& ui, bool is_there, std::size_t place) {
    if (!is_there) {
        const std::string number = std::to_string(place + 1);
        ui.errors.add("store a version there first: Ctrl+" + number);
    }
}

void recall(Ui& ui, std::size_t place) {
    say_if_none(ui, recall_version(ui.history.draft(), place), place);
}

void put_on_a(Ui& ui, std::size_t place) {
    say_if_none(ui, show_version(ui.history.draft(), place, 0), place);
}

/// The operator that keys are for, or an error that says how one is chosen.
template <auto change>
void with_chosen(Ui& ui) {
    State& state = ui.history.draft();
    if (ui.look.chosen && *ui.look.chosen < state.recipe.operations.size()) {
        change(state, *ui.look.chosen);
    } else {
        ui.errors.add("click the heading of an operator in the panel Look first");
    }
}

constexpr Key digits[] = {Key::digit_1, Key::digit_2, Key::digit_3, Key::digit_4, Key::digit_5,
                          Key::digit_6, Key::digit_7, Key::digit_8, Key::digit_9};
static_assert(std::size(digits) == version_count);

struct NumberedAction {
    const char* help;
    bool ctrl = false, shift = false;
    void (*act)(Ui& ui, std::size_t place) = nullptr;
};
constexpr NumberedAction numbered[] = {
    {.help = "store the look as version ", .ctrl = true, .act = &store},
    {.help = "bring back version ", .act = &recall},
    {.help = "show on side A version ", .shift = true, .act = &put_on_a},
};

/// For each place; F1 lists them as one.
void add_numbered(std::vector<Action>& out) {
    for (const NumberedAction& row : numbered) {
        for (std::size_t place = 0; place < std::size(digits); ++place) {
            Action action{.help = row.help + std::to_string(place + 1),
                          .key = digits[place],
                          .ctrl = row.ctrl,
                          .shift = row.shift,
                          .act = [act = row.act, place](Ui& ui) { act(ui, place); }};
            action.listed = place == 0 ? keys_of(action) + " to 9" : "";
            out.push_back(std::move(action));
        }
    }
}

std::vector<Action> own_actions() {
    std::vector<Action> out{
        {.help = "keep the colour under the mouse, in the panel Colours",
         .key = Key::c,
         .act = &pick_color},
        {.help =
             "freeze the scopes: they keep what they show while the picture changes; or let them "
             "follow it again",
         .key = Key::f,
         .act = [](Ui& ui) { ui.scopes_shown.are_frozen = !ui.scopes_shown.are_frozen; }},
        {.help = "list of keys",
         .key = Key::f1,
         .act = [](Ui& ui) { ui.shows_help = !ui.shows_help; }},
        {.help = "close what lies over the panels: lists, errors, questions, what was exported; "
                 "pick no colour and drag no region",
         .key = Key::escape,
         .act = &close_all},
        {.help = "find anything that can be done by typing",
         .key = Key::p,
         .ctrl = true,
         .act = [](Ui& ui) { ui.shows_palette = !ui.shows_palette; }},
        {.help = "undo", .key = Key::z, .ctrl = true, .act = [](Ui& ui) { ui.history.undo(); }},
        {.help = "redo",
         .key = Key::z,
         .ctrl = true,
         .shift = true,
         .act = [](Ui& ui) { ui.history.redo(); }},
        {.help = "redo", .key = Key::y, .ctrl = true, .act = [](Ui& ui) { ui.history.redo(); }},
        {.help = "open a look, picture or model", .key = Key::o, .ctrl = true, .act = &ask_to_open},
        {.help = "save the recipe to its file", .key = Key::s, .ctrl = true, .act = &save},
        {.help = "leave out the operator that was clicked last, or take it in again",
         .key = Key::d,
         .act = &with_chosen<&toggle_bypass>},
        {.help = "show the operator that was clicked last alone, or all again",
         .key = Key::s,
         .act = &with_chosen<&toggle_solo>},
        {.help = "the looks of the folder as a strip of pictures, or none",
         .key = Key::l,
         .act = &toggle_look_strip},
        {.help = "the next look of the folder",
         .key = Key::page_down,
         .act = [](Ui& ui) { open_look_beside(ui, 1); }},
        {.help = "the look before it in the folder",
         .key = Key::page_up,
         .act = [](Ui& ui) { open_look_beside(ui, -1); }},
        {.help = "save the recipe to another file",
         .key = Key::s,
         .ctrl = true,
         .shift = true,
         .act = &ask_to_save},
        {.help = "export the strip into the engine's folder (--watch-engine-folder)",
         .key = Key::e,
         .ctrl = true,
         .act = &export_to_engine},
        {.help = "larger text and controls", .key = Key::plus, .ctrl = true, .act = &scale_text<1>},
        {.help = "smaller text and controls",
         .key = Key::minus,
         .ctrl = true,
         .act = &scale_text<-1>},
        {.help = "text and controls as large as the desktop has them",
         .key = Key::digit_0,
         .ctrl = true,
         .act = &scale_text<0>},
        {.help = "make everything on the GPU anew",
         .key = Key::r,
         .ctrl = true,
         .shift = true,
         .act = [](Ui& ui) { ui.wants_new_screen = true; }},
        {.help = "quit", .key = Key::q, .ctrl = true, .act = &ask_to_quit},
        {.help = "side A alone", .key = Key::f2, .act = [](Ui& ui) { compare_by(ui, compare_a); }},
        {.help = "side B alone", .key = Key::f3, .act = [](Ui& ui) { compare_by(ui, compare_b); }},
        {.help = "split by a line",
         .key = Key::f4,
         .act = [](Ui& ui) { compare_by(ui, compare_split); }},
        {.help = "turn the split by a quarter",
         .key = Key::f4,
         .shift = true,
         .act =
             [](Ui& ui) {
                 State& state = ui.history.draft();
                 state.compare = &compare_split;
                 state.split_angle = std::fmod(state.split_angle + 90, 360.0F);
             }},
        {.help = "side A in a box",
         .key = Key::f7,
         .act = [](Ui& ui) { compare_by(ui, compare_box); }},
        {.help = "side by side",
         .key = Key::f5,
         .act = [](Ui& ui) { compare_by(ui, compare_side); }},
        {.help = "difference",
         .key = Key::f6,
         .act = [](Ui& ui) { compare_by(ui, compare_difference); }},
        {.help = "look at the picture's levels, clipping, gamut or a channel: the next view",
         .key = Key::v,
         .act = &next_view},
        {.help = "all of the picture, or each of its pixels as one of the screen (1:1)",
         .key = Key::z,
         .act = [](Ui& ui) { zoom_to(ui, ui.history.draft().zoom.scale > 0 ? 0.0F : 1.0F); }},
        {.help = "the picture itself",
         .key = Key::v,
         .shift = true,
         .act = [](Ui& ui) { ui.history.draft().picture_view = &picture_views().front(); }},
    };
    add_numbered(out);
    return out;
}

} // namespace

void save(Ui& ui) {
    const State& state = ui.history.draft();
    const std::string path = state.recipe_path;
    if (path.empty()) {
        ask_to_save(ui);
        return;
    }
    const auto write = [&ui, path] {
        save_recipe(ui.history, path);
        ui.report = "saved " + path + "\n";
    };
    if (ui.offered || !is_file_as_saved(state)) {
        attempt_writing(ui, path, write);
    } else {
        attempt(ui, write);
    }
}

const std::vector<Action>& actions() {
    static const std::vector<Action> table = own_actions();
    return table;
}

std::string keys_of(const Action& action) {
    return std::string(action.ctrl ? "Ctrl+" : "") + (action.shift ? "Shift+" : "") +
           std::string(text_of(action.key));
}

bool is_asked_by(const Action& action, const KeyPress& press) {
    // Where + is typed with Shift, that belongs to it.
    const bool is_shift_right = press.shift == action.shift || press.key == Key::plus;
    return press.key == action.key && press.ctrl == action.ctrl && is_shift_right;
}

} // namespace preview::panels
