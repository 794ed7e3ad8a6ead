#include "preview/editor/look_baker.h"

#include "lutlib/bake/bake.h"
#include "preview/look/look_file.h"
#include "preview/look/recipe_table.h"

#include <algorithm>
#include <chrono>
#include <tuple>

namespace preview::editor {

namespace {

auto operators_of(const lutlib::Recipe& r) {
    return std::tie(r.input, r.output, r.adaptation, r.base_lut, r.bake, r.operations, r.opacity);
}

// A gesture's changes follow each other faster.
constexpr auto pause_between_gestures = std::chrono::milliseconds(200);

bool shows_recipe(const Side& side) {
    return side.source == SideSource::recipe;
}

const GpuLookup& float_table() {
    static const GpuLookup& row = *gpu_lookup_named("tetrahedral");
    return row;
}

LoadedLook standing(LoadedLook look, const LookStanding& where) {
    set_standing(look, where);
    look.encodings = where.sentence;
    return look;
}

LoadedLook table_look(const std::shared_ptr<const lutlib::Lut>& lut, const PictureCodes& picture) {
    const LookStanding where = standing_of(lutlib::encodings_of(lut->encodings), nullptr, picture);
    return standing(look_for(lut, table_lookup(*lut)), where);
}

} // namespace

bool same(const LookRequest& a, const LookRequest& b) {
    return operators_of(a.recipe) == operators_of(b.recipe) && a.sides == b.sides &&
           a.picture == b.picture;
}

LoadedLook look_of(const lutlib::Recipe& recipe, const Side& side, const PictureCodes& picture) {
    switch (side.source) {
    case SideSource::none:
    case SideSource::still:
        break;
    case SideSource::source:
        if (recipe.base_lut) {
            return table_look(recipe.base_lut, picture);
        }
        break;
    case SideSource::file:
        if (side.lut) {
            return table_look(side.lut, picture);
        }
        break;
    case SideSource::version:
        if (side.version) {
            Side whole = side;
            whole.source = SideSource::recipe;
            return look_of(side.version->recipe, whole, picture);
        }
        break;
    case SideSource::recipe: {
        const LookStanding where = standing_of(encodings_of(recipe), nullptr, picture);
        return standing(look_for(quick_table(recipe), float_table()), where);
    }
    case SideSource::baked: {
        const lutlib::Engine& engine = *side.engine->engine;
        const LookStanding where = standing_of(encodings_of(recipe), side.engine, picture);
        const lutlib::Bake baked =
            lutlib::bake(where.place.applied().around(lutlib::Transform::of(recipe)), engine,
                         side.size > 0 ? side.size : engine.default_size,
                         side.bits > 0 ? side.bits : engine.default_bits);
        return standing(
            {look_data(baked.picture, baked.size, *side.engine), {}, {}, table_of(baked)}, where);
    }
    }
    return no_look_of(picture);
}

LookBaker::LookBaker(std::function<void()> on_ready)
    : on_ready_(std::move(on_ready)), thread_([this] { run(); }) {}

LookBaker::~LookBaker() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void LookBaker::request(LookRequest request) {
    {
        const std::lock_guard lock(mutex_);
        waiting_ = std::move(request);
    }
    changed_.notify_one();
}

std::optional<BakedLooks> LookBaker::take() {
    const std::lock_guard lock(mutex_);
    std::optional<BakedLooks> out = std::move(finished_);
    finished_.reset();
    return out;
}

bool LookBaker::is_busy() {
    const std::lock_guard lock(mutex_);
    return waiting_ || bakes_ || finished_;
}

bool LookBaker::is_outdated() {
    const std::lock_guard lock(mutex_);
    return ends_ || waiting_;
}

void LookBaker::publish(BakedLooks baked, bool is_last) {
    {
        const std::lock_guard lock(mutex_);
        finished_ = std::move(baked);
        bakes_ = !is_last;
    }
    on_ready_();
}

void LookBaker::refine(const LookRequest& request, BakedLooks baked) {
    const auto stop = [this] { return is_outdated(); };
    const LookStanding where = standing_of(encodings_of(request.recipe), nullptr, request.picture);
    const std::optional<RecipeTable> table = measured_table(request.recipe, stop);
    if (!table) {
        return;
    }
    for (std::size_t i = 0; i < baked.sides.size(); ++i) {
        if (shows_recipe(request.sides[i])) {
            baked.sides[i] = standing(measured_look(*table, float_table()), where);
        }
    }
    publish(std::move(baked), true);
}

void LookBaker::run() {
    for (;;) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return ends_ || waiting_; });
        if (ends_) {
            return;
        }
        const LookRequest request = std::move(*waiting_);
        waiting_.reset();
        bakes_ = true;
        lock.unlock();
        BakedLooks baked;
        const auto start = std::chrono::steady_clock::now();
        try {
            for (std::size_t i = 0; i < 2; ++i) {
                baked.sides[i] = look_of(request.recipe, request.sides[i], request.picture);
            }
        } catch (const std::exception& error) {
            baked.error = error.what();
        }
        baked.milliseconds =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count();
        const bool refines =
            baked.error.empty() && std::any_of(request.sides.begin(), request.sides.end(),
                                               [](const Side& side) { return shows_recipe(side); });
        publish(baked, !refines);
        if (!refines) {
            continue;
        }
        lock.lock();
        const bool is_followed =
            changed_.wait_for(lock, pause_between_gestures, [this] { return ends_ || waiting_; });
        lock.unlock();
        if (!is_followed) {
            refine(request, std::move(baked));
        }
    }
}

} // namespace preview::editor
