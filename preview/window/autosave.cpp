#include "preview/window/autosave.h"

#include "lutlib/error.h"
#include "lutlib/io/recipe_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace preview {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view before_number = "unsaved-", after_number = ".json";

/// The process that keeps its look in a file of this name; 0: it is no such file.
pid_t process_of(const std::string& name) {
    if (!name.starts_with(before_number) || !name.ends_with(after_number)) {
        return 0;
    }
    pid_t out = 0;
    const char* const end = name.data() + name.size() - after_number.size();
    const auto read = std::from_chars(name.data() + before_number.size(), end, out);
    return read.ec == std::errc() && read.ptr == end ? out : 0;
}

bool is_running(pid_t process) {
    return ::kill(process, 0) == 0 || errno == EPERM;
}

} // namespace

Autosave::Autosave(fs::path folder) : folder_(std::move(folder)) {}

std::vector<std::string> Autosave::found() const {
    std::vector<std::string> out;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, none)) {
        const pid_t process = process_of(entry.path().filename().string());
        if (process > 0 && entry.path() != kept_ &&
            (process == ::getpid() || !is_running(process))) {
            out.push_back(entry.path().string());
        }
    }
    return out;
}

fs::path Autosave::own_path() const {
    return folder_ / fmt::format("{}{}{}", before_number, ::getpid(), after_number);
}

void Autosave::adopt(const fs::path& left) {
    std::error_code failed;
    fs::rename(left, own_path(), failed);
    if (failed) {
        throw lutlib::Error("choose another look, for this one has been taken or deleted: " +
                                failed.message(),
                            {left.string(), 0, {}});
    }
    kept_ = own_path();
    last_ = {};
}

void Autosave::keep(const editor::State& state) {
    if (folder_.empty()) {
        return;
    }
    if (!is_unsaved(state)) {
        forget();
        return;
    }
    if (kept_ && editor::same(state.recipe, last_)) {
        return;
    }
    const fs::path path = own_path();
    lutlib::io::save_recipe(state.recipe, path.string(), state.base_path);
    kept_ = path;
    last_ = state.recipe;
}

void Autosave::forget() {
    if (kept_) {
        std::error_code stays;
        fs::remove(*kept_, stays);
        kept_.reset();
    }
}

} // namespace preview
