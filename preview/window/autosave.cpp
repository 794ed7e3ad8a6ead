#include "preview/window/autosave.h"

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
        if (process > 0 && (process == ::getpid() || !is_running(process))) {
            out.push_back(fmt::format("a window ended before its look was saved: open {} with "
                                      "--allow-outside and save it, or delete that file",
                                      entry.path().string()));
        }
    }
    return out;
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
    const fs::path path = folder_ / fmt::format("{}{}{}", before_number, ::getpid(), after_number);
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
