#include "lutlib/io/references.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"

#include <atomic>
#include <filesystem>
#include <system_error>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

std::atomic<bool> outside_is_allowed = false;

fs::path folder_of(const std::string& from) {
    return from == standard_stream ? fs::path() : fs::path(from).parent_path();
}

} // namespace

void allow_references_outside(bool allowed) {
    outside_is_allowed = allowed;
}

std::string referenced_path(const std::string& from, const std::string& reference) {
    return (folder_of(from) / reference).lexically_normal().string();
}

bool leads_outside(const std::string& from, const std::string& reference) {
    std::error_code no_folder, no_target;
    const fs::path folder = folder_of(from).empty() ? "." : folder_of(from);
    const fs::path inside = fs::canonical(folder, no_folder);
    const fs::path target =
        fs::weakly_canonical(fs::absolute(referenced_path(from, reference)), no_target);
    if (no_folder || no_target) {
        return true; // nobody can say
    }
    const fs::path way = target.lexically_relative(inside);
    return way.empty() || *way.begin() == "..";
}

std::string read_reference(const std::string& from, const std::string& reference,
                           std::size_t max_bytes) {
    const std::string path = referenced_path(from, reference);
    if (!outside_is_allowed && leads_outside(from, reference)) {
        throw Error("it lies outside the folder of " + input_name(from) +
                        ", which names it; copy it there, or add --allow-outside",
                    {path, 0, {}});
    }
    std::error_code failed;
    if (fs::exists(path, failed) && !fs::is_regular_file(path, failed)) {
        throw Error("what a file names must be a file; this is a folder, a device or a pipe",
                    {path, 0, {}});
    }
    return read_file(path, max_bytes);
}

} // namespace lutlib::io
