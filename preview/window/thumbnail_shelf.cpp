#include "preview/window/thumbnail_shelf.h"

#include "lutlib/error.h"
#include "preview/editor/look_baker.h"
#include "preview/frame/frame.h"
#include "preview/passes/resolve.h"
#include "preview/window/opening.h"
#include "preview/window/window_frame.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

namespace preview {

using panels::ThumbnailFact;
using panels::ThumbnailKey;
using panels::ThumbnailKind;

namespace {

/// As the recipe of a window that opened it shows it.
std::shared_ptr<const LoadedLook> as_opened(const lutlib::Recipe& recipe,
                                            const PictureCodes& codes) {
    editor::Side side;
    side.source = editor::SideSource::recipe;
    LoadedLook look = editor::look_of(recipe, side, codes);
    look.table.reset(); // as large as what is read, and nobody looks at it
    return std::make_shared<const LoadedLook>(std::move(look));
}

/// Whether it is better read again than held while its picture is seen: beyond 65 nodes a side.
bool is_large(const LoadedLook& look) {
    constexpr std::size_t most_held = std::size_t{8} << 20;
    const LookData& data = look.data;
    return data.picture.bytes.size() + data.volume.bytes.size() + data.shaper.bytes.size() >
           most_held;
}

const std::shared_ptr<const editor::Version>& version_of(const panels::Ui& ui,
                                                         const ThumbnailKey& key) {
    return ui.history.draft().versions.at(static_cast<std::size_t>(std::stoul(key.name)));
}

/// In pixels.
Size box_size() {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const auto pixels = [](float length, float per_unit) {
        return std::max(static_cast<std::uint32_t>(std::floor(length) * per_unit), 1U);
    };
    return {pixels(panels::em(panels::thumbnail_width), scale.x),
            pixels(panels::em(panels::thumbnail_height), scale.y)};
}

/// Of a scene that is not shown, as a screen is.
Size scene_size() {
    return fitted({1920, 1080}, box_size());
}

/// The largest of the proportions in which all of one side is seen now.
Size thumbnail_size(const panels::Ui& ui) {
    if (!ui.facts.is_scene) {
        return fitted(ui.facts.picture_size, box_size());
    }
    const float width =
        ui.picture_place.width / (ui.history.draft().compare == &compare_side ? 2.0F : 1.0F);
    return fitted({std::max(static_cast<std::uint32_t>(width), 1U),
                   std::max(static_cast<std::uint32_t>(ui.picture_place.height), 1U)},
                  box_size());
}

/// The picture under a look and nothing over it, all of it.
FrameSettings of_thumbnail(FrameSettings settings, Size size) {
    const PictureSettings usual;
    static_cast<Wipe&>(settings) = usual;
    settings.output = size;
    settings.compare = &compare_b;
    settings.heat_scale = usual.heat_scale;
    settings.picture_view = usual.picture_view;
    settings.zebra_level = usual.zebra_level;
    settings.zoom = usual.zoom;
    settings.view = nullptr;
    settings.axes = nullptr;
    settings.probe.reset();
    settings.scope_sizes = {};
    settings.scope_figures.reset();
    return settings;
}

/// As it opens, in the finish that it is made for.
void draw_scene(ThumbnailCells& cells, std::size_t cell, std::shared_ptr<const Shown> shown,
                FrameSettings settings) {
    editor::State state = editor::initial_state();
    take_shown(state, shown);
    const Size size = settings.output;
    static_cast<PictureSettings&>(settings) = state;
    settings.orbit = state.orbit;
    settings.seconds = 0;
    settings.keeps_light = false;
    cells.draw(cell, std::move(shown), of_thumbnail(std::move(settings), size));
}

} // namespace

void ThumbnailShelf::forget_look(panels::Ui& ui, const ThumbnailKey& key, Entry& entry) {
    entry.look.reset();
    entry.ticket = 0;
    entry.drawn = 0;
    if (const auto fact = ui.thumbnails.facts.find(key); fact != ui.thumbnails.facts.end()) {
        fact->second.reason.clear();
        fact->second.is_no_look = false;
    }
}

void ThumbnailShelf::take_news(panels::Ui& ui) {
    const editor::LookReader::News news = reader_->take();
    if (!news.failure.empty()) {
        ui.errors.add("what changes in the folder of the strip is not seen: " + news.failure);
    }
    for (const std::string& path : news.changed) {
        ui.look_strip.is_outdated = true;
        ui.look_strip.no_looks.clear();
        for (auto& [key, entry] : entries_) {
            const bool is_in_it =
                key.name == path || std::filesystem::path(key.name).parent_path() == path;
            if (key.kind == ThumbnailKind::file && is_in_it) {
                forget_look(ui, key, entry);
            }
        }
    }
    for (const editor::ReadLook& read : news.looks) {
        const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& it) {
            return it.second.ticket == read.ticket;
        });
        if (found == entries_.end()) {
            continue;
        }
        found->second.look = read.look;
        found->second.scene = read.scene;
        const bool is_none = read.look == nullptr && read.scene == nullptr;
        ThumbnailFact& fact = ui.thumbnails.facts[found->first];
        fact.reason = read.reason;
        fact.is_no_look = is_none && read.reason.empty();
        if (is_none) {
            fact.cell.reset();
        }
    }
    if (!news.looks.empty() || !news.changed.empty()) {
        wake_(); // what the panels have drawn is as it was before
    }
}

editor::LookJob ThumbnailShelf::job_for(const ThumbnailKey& key, const Entry& entry) const {
    if (key.kind == ThumbnailKind::version) {
        return {entry.ticket, [version = entry.version, codes = codes_] {
                    return as_opened(version->recipe, codes);
                }};
    }
    if (key.kind == ThumbnailKind::scene) {
        return {entry.ticket, {}, [name = key.name] {
                    return std::make_shared<const Shown>(load_shown(name, 0));
                }};
    }
    return {entry.ticket, [path = key.name, codes = codes_]() -> std::shared_ptr<const LoadedLook> {
                const auto look = lutlib::io::Look::open_if_look(path);
                return look ? as_opened(look->as_recipe(), codes) : nullptr;
            }};
}

/// Whether its picture is of what there is now.
bool ThumbnailShelf::is_current(const panels::Ui& ui, const ThumbnailKey& key,
                                const Entry& entry) const {
    if (key.kind != ThumbnailKind::scene) {
        return entry.drawn == drawing_;
    }
    const auto fact = ui.thumbnails.facts.find(key);
    return entry.drawn != 0 && fact != ui.thumbnails.facts.end() &&
           fact->second.size == scene_size();
}

/// Looks of pictures that are drawn are needed again only where what is shown changes: then too
/// they are held while they are seen, no longer.
void ThumbnailShelf::ask(panels::Ui& ui) {
    ++frame_;
    std::vector<editor::LookJob> jobs;
    constexpr int most_scenes = 2; // of textures and meshes at once: one is drawn, one is built
    int scenes = 0;
    for (const ThumbnailKey& key : ui.thumbnails.wanted) {
        if (key.kind == ThumbnailKind::version && !version_of(ui, key)) {
            continue; // it was taken away since the panel was drawn
        }
        Entry& entry = entries_[key];
        entry.seen = frame_;
        if (key.kind == ThumbnailKind::version && entry.version != version_of(ui, key)) {
            forget_look(ui, key, entry);
            entry.version = version_of(ui, key);
        }
        const bool is_told =
            ui.thumbnails.facts[key].is_no_look || !ui.thumbnails.facts[key].reason.empty();
        const bool is_ready = entry.look != nullptr || entry.scene != nullptr;
        scenes += entry.scene != nullptr ? 1 : 0;
        if (key.kind == ThumbnailKind::scene && scenes >= most_scenes) {
            continue;
        }
        if (!is_current(ui, key, entry) && !is_ready && !is_told) {
            scenes += key.kind == ThumbnailKind::scene ? 1 : 0;
            entry.ticket = entry.ticket == 0 ? ++tickets_ : entry.ticket;
            jobs.push_back(job_for(key, entry));
        }
    }
    for (auto entry = entries_.begin(); entry != entries_.end();) {
        const bool is_seen = entry->second.seen == frame_;
        if (!is_seen) {
            entry->second.look.reset();
            entry->second.scene.reset();
            entry->second.ticket = 0;
        }
        const auto fact = ui.thumbnails.facts.find(entry->first);
        const bool is_empty = fact == ui.thumbnails.facts.end() || !fact->second.cell;
        if (!is_seen && is_empty &&
            !(fact != ui.thumbnails.facts.end() && fact->second.is_no_look)) {
            ui.thumbnails.facts.erase(entry->first);
            entry = entries_.erase(entry);
        } else {
            ++entry;
        }
    }
    reader_->ask(ui.look_strip.is_open ? ui.look_strip.listing.folder : std::string(),
                 std::move(jobs));
}

void ThumbnailShelf::take(panels::Ui& ui) {
    if (!reader_ && ui.thumbnails.wanted.empty() && !ui.look_strip.is_open) {
        return;
    }
    if (!reader_) {
        reader_ = std::make_unique<editor::LookReader>(wake_);
    }
    if (const PictureCodes& now = ui.history.draft().picture; now != codes_) {
        codes_ = now;
        for (auto& [key, entry] : entries_) {
            if (key.kind != ThumbnailKind::scene) {
                forget_look(ui, key, entry);
            }
        }
    }
    take_news(ui);
    ask(ui);
}

void ThumbnailShelf::notice_what_is_shown(const panels::Ui& ui, const FrameSettings& settings) {
    const editor::State& state = ui.history.draft();
    Made now{settings,           settings.orbit, settings.seconds, state.lights,
             state.surroundings, state.shown,    settings.output};
    const bool is_same = made_ && made_->settings == now.settings &&
                         std::memcmp(&made_->orbit, &now.orbit, sizeof now.orbit) == 0 &&
                         made_->seconds == now.seconds && made_->lights == now.lights &&
                         made_->surroundings == now.surroundings && made_->shown == now.shown &&
                         made_->size == now.size;
    if (!is_same) {
        made_ = std::move(now);
        ++drawing_;
    }
}

/// Its own, a free one, or that of the picture that was seen the longest ago.
std::size_t ThumbnailShelf::cell_for(panels::Ui& ui, const ThumbnailKey& key) {
    auto& facts = ui.thumbnails.facts;
    if (facts[key].cell) {
        return *facts[key].cell;
    }
    std::vector<bool> taken(ThumbnailCells::count);
    std::optional<ThumbnailKey> oldest;
    for (const auto& [other, fact] : facts) {
        if (fact.cell) {
            taken[*fact.cell] = true;
            if (!oldest || entries_[other].seen < entries_[*oldest].seen) {
                oldest = other;
            }
        }
    }
    const auto free = std::find(taken.begin(), taken.end(), false);
    if (free != taken.end()) {
        return static_cast<std::size_t>(free - taken.begin());
    }
    const std::size_t cell = *facts[*oldest].cell;
    facts[*oldest].cell.reset();
    entries_[*oldest].drawn = 0;
    return cell;
}

bool ThumbnailShelf::is_due(const panels::Ui& ui, const ThumbnailKey& key) const {
    const auto found = entries_.find(key);
    if (found == entries_.end()) {
        return false;
    }
    const Entry& entry = found->second;
    const bool is_ready = key.kind == ThumbnailKind::scene ? entry.scene != nullptr
                                                           : entry.look != nullptr && !ui.plays;
    return is_ready && !is_current(ui, key, entry);
}

bool ThumbnailShelf::draw(panels::Ui& ui, Screen& screen, const FrameInputs& inputs,
                          FrameSettings settings, const RasterChoice& raster) {
    const bool is_held = ImGui::IsAnyItemActive() || ImGui::IsAnyMouseDown();
    if (ui.thumbnails.wanted.empty() || is_held) {
        return false;
    }
    settings = of_thumbnail(std::move(settings), thumbnail_size(ui));
    if (!ui.plays) {
        notice_what_is_shown(ui, settings);
    }
    const std::vector<ThumbnailKey>& wanted = ui.thumbnails.wanted;
    const auto next = std::find_if(wanted.begin(), wanted.end(),
                                   [&](const ThumbnailKey& key) { return is_due(ui, key); });
    if (next == wanted.end()) {
        return false;
    }
    if (!screen.thumbnails) {
        screen.thumbnails.emplace(screen.device);
    }
    const bool is_scene = next->kind == ThumbnailKind::scene;
    settings.output = is_scene ? scene_size() : settings.output;
    settings.raster = raster.on(screen.device, settings.output);
    const std::size_t cell = cell_for(ui, *next);
    Entry& entry = entries_[*next];
    if (is_scene) {
        entry.ticket = 0;
        draw_scene(*screen.thumbnails, cell, std::exchange(entry.scene, nullptr), settings);
    } else {
        screen.thumbnails->draw(cell, inputs, settings, *entry.look);
    }
    entry.drawn = drawing_;
    if (entry.look && is_large(*entry.look)) {
        entry.look.reset();
        entry.ticket = 0;
    }
    ThumbnailFact& fact = ui.thumbnails.facts[*next];
    fact.cell = cell;
    fact.size = settings.output;
    ++ui.thumbnails.drawn;
    return true; // to show it, too
}

void ThumbnailShelf::forget_pictures(panels::Ui& ui) {
    for (auto& [key, fact] : ui.thumbnails.facts) {
        fact.cell.reset();
    }
    for (auto& [key, entry] : entries_) {
        entry.drawn = 0;
    }
}

} // namespace preview
