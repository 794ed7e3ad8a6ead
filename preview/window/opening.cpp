#include "preview/window/opening.h"

#include "preview/editor/commands.h"

namespace preview {

namespace {

void open_looks(ui::State& state, const Options& options) {
    const std::string& on_recipe = options.look_b.empty() ? options.look_a : options.look_b;
    if (on_recipe != "none")
        ui::open_look(state, lutlib::io::Look::open(on_recipe));
    if (!options.look_b.empty() && options.look_a != "none")
        ui::open_side(state.sides[0], lutlib::io::Look::open(options.look_a));
}

} // namespace

void take_shown(ui::State& state, std::shared_ptr<const Shown> shown) {
    state.without.set(Effect::fxaa, !shown->scene);
    state.lights.clear();
    if (shown->scene) {
        state.orbit = shown->scene->orbit;
        state.lights = shown->scene->lights;
    }
    state.shown = std::move(shown);
}

ui::State opening_state(const Options& options) {
    const auto shown = std::make_shared<const Shown>(load_shown(options.input, options.seconds));
    const FrameSettings given = settings_of(options, shown->picture_size());
    ui::State state = ui::initial_state();
    state.tonemap = given.tonemap;
    state.bloom = given.bloom;
    state.bloom_settings = given.bloom_settings;
    state.exposure = given.exposure;
    state.split = given.split;
    state.heat_scale = given.heat_scale;
    if (!options.compare.empty())
        state.compare = given.compare;
    if (given.scope != nullptr)
        state.scopes_seen.seen[static_cast<std::size_t>(given.scope - scopes.data())] = true;
    state.scopes_seen.side = given.scope_side;
    state.scopes_seen.logarithmic = given.scope_logarithmic;
    take_shown(state, shown);
    state.without = given.without;
    state.lights = lights_of(options, shown->scene);
    if (shown->scene)
        state.orbit = orbit_of(options, *shown->scene);
    for (const GpuLookup* row : ui::engine_lookups())
        if (row->name == options.engine)
            for (ui::Side& side : state.sides)
                side.engine = row;
    open_looks(state, options);
    return state;
}

} // namespace preview
