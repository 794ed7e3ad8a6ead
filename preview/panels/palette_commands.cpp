#include "preview/panels/palette.h"

#include "lutlib/text.h"
#include "preview/editor/search.h"
#include "preview/editor/stills.h"
#include "preview/effects/effect.h"
#include "preview/look/look_standing.h"
#include "preview/panels/file_actions.h"
#include "preview/panels/file_dialog.h"
#include "preview/panels/look_parts.h"
#include "preview/panels/still_controls.h"
#include "preview/scene/scene.h"

#include <algorithm>

namespace preview::panels {

namespace {

using Commands = std::vector<Action>;

void add(Commands& out, std::string text, std::function<void(Ui&)> act) {
    out.push_back({.help = std::move(text), .act = std::move(act)});
}

std::string text(std::string_view kind, std::string_view name, std::string_view help = {}) {
    std::string out = std::string(kind) + ": " + std::string(name);
    return help.empty() ? out : out + ", " + std::string(help);
}

void add_panels(Commands& out, const Ui&) {
    const std::vector<std::string> names = panel_names();
    for (std::size_t i = 0; i < names.size(); ++i) {
        add(out, text("panel", names[i]), [i](Ui& ui) { ui.panel = i; });
    }
    for (std::size_t i = 0; i < look_pages().size(); ++i) {
        const LookPage& page = look_pages()[i];
        add(out, text("page of the look", page.name, page.help), [i](Ui& ui) {
            ui.panel = 0;
            ui.look.page = i;
        });
    }
}

void add_files(Commands& out, const Ui& ui) {
    add(out, "export the look as a LUT file", &ask_to_export_lut);
    for (std::size_t i = 0; i < engine_lookups().size(); ++i) {
        add(out, text("export a strip for", engine_lookups()[i]->label),
            [i](Ui& to) { ask_to_export_strip(to, i); });
    }
    add(out, "save the picture", &ask_to_save_picture);
    add(out, "open an ASC CDL (.cc, .ccc, .cdl) into the look", &ask_for_correction);
    add(out, "save the look's ASC CDL (.cc, .ccc, .cdl)", &ask_to_save_correction);
    for (const std::string& path : ui.recent) {
        add(out, text("open again", path), [path](Ui& to) { to.to_open.push_back(path); });
    }
}

void add_scenes(Commands& out, const Ui& ui) {
    for (const SceneInfo& row : scenes()) {
        add(out, text("scene", row.name, row.help),
            [&row](Ui& to) { to.to_open.emplace_back(row.name); });
    }
    add(out, "meter: the picture's mean becomes 18 % grey",
        [](Ui& to) { to.metering = Metering{}; });
    add(out, "meter a place, which becomes 18 % grey", &start_metering);
    add(out, "surround the scene with a picture", &ask_for_surroundings);
    add(out, "play the scene, or stop it", [](Ui& to) { to.plays = !to.plays; });
    add(out, "keep this camera", [](Ui& to) { to.cameras.keep = {{}, to.history.draft().orbit}; });
    add(out, "camera: as at first",
        [](Ui& to) { to.history.draft().orbit = to.facts.usual_orbit; });
    for (const auto* const list : {&ui.facts.cameras, &ui.cameras.kept}) {
        for (const NamedCamera& camera : *list) {
            add(out,
                text("camera", camera.name,
                     list == &ui.cameras.kept ? "kept" : "of the model's file"),
                [orbit = camera.orbit](Ui& to) { to.history.draft().orbit = orbit; });
        }
    }
    for (const SurroundingsInfo& row : surroundings_kinds()) {
        if (row.kind != SurroundingsKind::picture || ui.facts.has_surroundings_picture) {
            add(out, text("surroundings", row.name, row.help),
                [&row](Ui& to) { to.history.draft().surroundings.kind = row.kind; });
        }
    }
}

void add_intermediates(Commands& out, const Ui& ui) {
    for (const Option& row : ui.facts.debug_views) {
        add(out, text("show the intermediate", row.name, row.text),
            [name = std::string(row.name)](Ui& to) { to.debug_view = name; });
    }
    add(out, "show no intermediate, but the picture", [](Ui& to) { to.debug_view.clear(); });
}

void add_choices(Commands& out, const Ui&) {
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        const std::vector<Option> options = row.options();
        for (std::size_t i = 0; i < options.size(); ++i) {
            add(out, text(row.label, options[i].name, options[i].text),
                [&row, i](Ui& ui) { row.choose(ui.history.draft(), i); });
        }
    }
    for (const ZoomStep& step : zoom_steps) {
        add(out, text("zoom", step.label), [&step](Ui& ui) { zoom_to(ui, step.scale); });
    }
}

/// What a side has nothing of is no choice.
void show_on(Ui& ui, std::size_t at, const SideSourceInfo& row) {
    Side& side = ui.history.draft().sides[at];
    if (row.source == SideSource::file && !side.lut) {
        ui.errors.add("open a file on that side first, in the panel Files");
    } else if (row.source == SideSource::version && !side.version) {
        ui.errors.add("put a version on that side first: Shift with its number");
    } else if (row.source == SideSource::still && !side.still) {
        ask_for_still(ui, at);
    } else {
        side.source = row.source;
    }
}

void add_sides(Commands& out, const Ui&) {
    for (std::size_t at = 0; at < 2; ++at) {
        const std::string side = at == 0 ? "side A" : "side B";
        for (const SideSourceInfo& row : side_sources) {
            add(out, text(side + " shows", row.name, row.help),
                [at, &row](Ui& ui) { show_on(ui, at, row); });
        }
        for (const GpuLookup* const engine : engine_lookups()) {
            add(out, text(side + " shows the strip as read by", engine->label),
                [at, engine](Ui& ui) {
                    Side& shown = ui.history.draft().sides[at];
                    shown.source = SideSource::baked;
                    shown.engine = engine;
                    shown.size = shown.bits = 0;
                });
        }
        add(out, "open a reference still on " + side, [at](Ui& ui) { ask_for_still(ui, at); });
        add(out, "take the still off " + side,
            [at](Ui& ui) { take_still_off(ui.history.draft(), at); });
    }
}

struct EncodingPlace {
    const char* name;
    lutlib::Encoding (*get)(const State& state);
    void (*set)(State& state, const lutlib::Encoding& encoding);
};
constexpr EncodingPlace encoding_places[] = {
    {"picture", [](const State& s) { return s.picture.encoding; },
     [](State& s, const lutlib::Encoding& e) { s.picture.encoding = e; }},
    {"look's input", [](const State& s) { return s.recipe.input; },
     [](State& s, const lutlib::Encoding& e) { s.recipe.input = e; }},
    {"look's output", [](const State& s) { return s.recipe.output_encoding(); },
     [](State& s, const lutlib::Encoding& e) { s.recipe.output = e; }},
};

void add_encodings(Commands& out, const Ui&) {
    for (const EncodingPlace& place : encoding_places) {
        const std::string kind = "encoding of the " + std::string(place.name);
        for (const lutlib::TransferCurve* const row : lutlib::transfer_curves()) {
            add(out, text(kind + ", curve", row->label, row->name), [&place, row](Ui& ui) {
                place.set(ui.history.draft(), {row, row->gamut});
            });
        }
        for (const lutlib::Gamut* const row : lutlib::gamuts()) {
            add(out, text(kind + ", gamut", row->label, row->name), [&place, row](Ui& ui) {
                place.set(ui.history.draft(), {place.get(ui.history.draft()).curve, row});
            });
        }
    }
    add(out, "convert between the picture's encoding and the look's, or not", [](Ui& ui) {
        bool& converts = ui.history.draft().picture.convert;
        converts = !converts;
    });
    for (const LookAt& row : look_ats) {
        add(out, text("looks stand", row.name, row.help),
            [&row](Ui& ui) { ui.history.draft().picture.at = &row; });
    }
}

void add_operators(Commands& out, const Ui&) {
    for (const lutlib::Op* const op : lutlib::ops()) {
        const std::string name = std::string(op->label) + " (" + std::string(op->name) + ")";
        add(out, text("add the operator", name, op->help), [op](Ui& ui) {
            lutlib::Recipe& recipe = ui.history.draft().recipe;
            add_operation(recipe, *op);
            ui.panel = ui.look.page = 0;
            ui.look.open.resize(recipe.operations.size());
            ui.look.open.back() = true;
            ui.look.chosen = recipe.operations.size() - 1;
        });
    }
}

void add_switches(Commands& out, const Ui&) {
    for (const PostEffect* const effect : post_effects()) {
        add(out, text("effect on or off", effect->label), [effect](Ui& ui) {
            EffectUses& uses = ui.history.draft().effects;
            use_of(uses, *effect) == nullptr ? put_use(uses, usual_use(*effect))
                                             : take_out(uses, *effect);
        });
    }
    for (const EffectInfo& row : effects) {
        add(out, text("part of the frame on or off", row.label), [&row](Ui& ui) {
            EffectSet& without = ui.history.draft().without;
            without.set(row.effect, !without.has(row.effect));
        });
    }
}

void add_scopes(Commands& out, const Ui&) {
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        add(out, text("scope seen or not", scopes[i].label), [i](Ui& ui) {
            bool& is_seen = ui.history.draft().scopes_seen.seen[i];
            is_seen = !is_seen;
        });
    }
    for (const ScopeSide& row : scope_sides) {
        add(out, text("scopes measure", row.label),
            [&row](Ui& ui) { ui.history.draft().scopes_seen.side = &row; });
    }
    for (const ScopeGain& row : scope_gains) {
        add(out, text("scope gain", row.label),
            [&row](Ui& ui) { ui.history.draft().scopes_seen.gain = &row; });
    }
    add(out, "scope levels: the codes as they are shown",
        [](Ui& ui) { ui.history.draft().scopes_seen.encoding.reset(); });
    for (const lutlib::Encoding& row : lutlib::encodings()) {
        add(out, text("scope levels", row.label() + " (" + row.name() + ")"),
            [&row](Ui& ui) { ui.history.draft().scopes_seen.encoding = row; });
    }
    add(out, "scopes: drag the region that they count",
        [](Ui& ui) { ui.scopes_shown.region_drag.emplace(); });
    add(out, "scopes: count all of the picture",
        [](Ui& ui) { ui.history.draft().scopes_seen.region = {}; });
}

/// 0: the text begins as typed; 1: it has that in it; 2: its words stand elsewhere.
int words_apart(std::string_view text, std::string_view typed) {
    const auto same = [](char a, char b) { return lutlib::upper(a) == lutlib::upper(b); };
    const std::string_view phrase = lutlib::trimmed(typed);
    const auto* const found =
        std::search(text.begin(), text.end(), phrase.begin(), phrase.end(), same);
    return found == text.begin() ? 0 : found != text.end() ? 1 : 2;
}

/// What there is, in the order of the list.
constexpr void (*adders[])(Commands& out, const Ui& ui) = {
    &add_panels,        &add_files,    &add_choices, &add_sides,     &add_scenes,
    &add_intermediates, &add_switches, &add_scopes,  &add_operators, &add_encodings,
};

} // namespace

std::vector<Action> commands(const Ui& ui) {
    Commands out = actions();
    for (const auto add_rows : adders) {
        add_rows(out, ui);
    }
    return out;
}

std::vector<std::size_t> found_commands(const std::vector<Action>& all, const std::string& typed) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (is_found(all[i].help + " " + keys_of(all[i]), typed)) {
            out.push_back(i);
        }
    }
    std::stable_sort(out.begin(), out.end(), [&](std::size_t a, std::size_t b) {
        return words_apart(all[a].help, typed) < words_apart(all[b].help, typed);
    });
    return out;
}

} // namespace preview::panels
