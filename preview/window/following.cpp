#include "preview/window/following.h"

#include "lutlib/error.h"
#include "lutlib/io/reason.h"
#include "preview/editor/reload.h"
#include "preview/editor/stills.h"
#include "preview/frame/shown.h"
#include "preview/window/opening.h"
#include "preview/window/screen.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace preview {

namespace {

/// An error names a file mostly, which need not be the one that was read: a model's texture.
std::string sentence_of(const std::string& path, const std::string& reason) {
    return (reason.starts_with(path) ? reason : path + ": " + reason) +
           "; what was read before is still shown";
}

void take_shown_everywhere(editor::History& history, const std::shared_ptr<const Shown>& fresh) {
    history.change_all([&](editor::State& state) {
        if (state.shown && state.shown->name == fresh->name &&
            state.shown->seconds == fresh->seconds &&
            state.shown->surroundings_file == fresh->surroundings_file) {
            take_shown_again(state, fresh);
        }
    });
}

std::vector<editor::FollowedFile> followed(const editor::State& state) {
    std::vector<editor::FollowedFile> out = followed_looks(state);
    for (editor::FollowedFile& file : followed_stills(state)) {
        out.push_back(std::move(file));
    }
    const std::shared_ptr<const Shown>& shown = state.shown;
    if (shown && !shown->files.empty()) {
        Shown named; // nothing large, which would stay while others are shown
        named.name = shown->name;
        named.seconds = shown->seconds;
        named.surroundings_file = shown->surroundings_file;
        out.push_back({"shown " + named.name + " " + named.surroundings_file, shown->files,
                       [named]() -> editor::PutInPlace {
                           return [fresh = std::make_shared<const Shown>(load_again(named))](
                                      editor::History& history) {
                               take_shown_everywhere(history, fresh);
                               return nullptr;
                           };
                       }});
    }
    return out;
}

} // namespace

Following::Following() {
    try {
        follower_.emplace([] { glfwPostEmptyEvent(); });
    } catch (const lutlib::Error& error) {
        failure_ = error.what();
    }
}

void Following::put(panels::Ui& ui, const editor::Reread& reread,
                    const std::function<void()>& show) {
    const editor::History before = ui.history;
    try {
        auto offered = reread.put(ui.history);
        show();
        reasons_.erase(reread.key);
        if (offered) {
            ui.offered = std::move(offered);
        }
    } catch (const std::exception& error) {
        const auto* const of_vulkan = dynamic_cast<const vk::SystemError*>(&error);
        if (of_vulkan != nullptr && is_lost(*of_vulkan)) {
            return; // all is shown anew on the next device
        }
        ui.history = before;
        reasons_[reread.key] = sentence_of(reread.path, lutlib::io::reason_of(error));
    }
}

void Following::take(panels::Ui& ui, const std::function<void()>& show) {
    const std::vector<editor::Reread> news =
        follower_ ? follower_->take() : std::vector<editor::Reread>();
    for (const editor::Reread& reread : news) {
        if (reread.key.empty()) {
            failure_ = reread.reason;
        } else if (reread.put) {
            put(ui, reread, show);
        } else {
            reasons_[reread.key] = sentence_of(reread.path, reread.reason);
        }
    }
    if (!failure_.empty()) {
        ui.errors.add("files that change on disk are not read again: " + failure_);
        failure_.clear();
    }
}

void Following::follow(panels::Ui& ui, Clock::time_point opened) {
    const editor::State& state = ui.history.draft();
    Made made{
        state.recipe_path, state.base_path, state.saved.base, state.recipe.base_lut != nullptr,
        state.said,        state.sides,     state.shown};
    if (follower_ && made_ != made) {
        made_ = std::move(made);
        std::vector<editor::FollowedFile> files = followed(state);
        keys_.clear();
        for (const editor::FollowedFile& file : files) {
            keys_.push_back(file.key);
        }
        follower_->follow(std::move(files), opened);
    }
    ui.notices.clear();
    for (const std::string& key : keys_) {
        const auto reason = reasons_.find(key);
        if (reason != reasons_.end() &&
            std::find(ui.notices.begin(), ui.notices.end(), reason->second) == ui.notices.end()) {
            ui.notices.push_back(reason->second);
        }
    }
}

} // namespace preview
