#include "lutlib/io/output_names.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/frames.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> own_fields{"name", "ext", "frame"};

std::string in_braces(std::string_view field) {
    return '{' + std::string(field) + '}';
}

bool is_folder(const std::string& text) {
    std::error_code failed;
    return text != standard_stream &&
           ((!text.empty() && text.back() == '/') || fs::is_directory(text, failed));
}

std::string needed_frame(const InputFile& input, const std::string& text) {
    if (input.frame.empty()) {
        throw UsageError("-o " + text + " wants the number of a frame, which '" + input.path +
                         "' does not have; name outputs by {name}");
    }
    return input.frame;
}

// The same file by any of its paths.
std::string whole_path(const std::string& path) {
    constexpr int longest_chain = 40; // Linux's own limit
    std::error_code failed;
    fs::path at = fs::weakly_canonical(fs::absolute(path), failed);
    // A link to what is not there yet.
    for (int i = 0; i < longest_chain && !failed && fs::is_symlink(at, failed); ++i) {
        at = fs::weakly_canonical(at.parent_path() / fs::read_symlink(at, failed), failed);
    }
    return failed && failed != std::errc::no_such_file_or_directory ? path : at.string();
}

} // namespace

OutputTemplate::OutputTemplate(std::string text, std::vector<std::string_view> fields,
                               const std::string& in_folder)
    : text_(std::move(text)) {
    if (!in_folder.empty() && is_folder(text_)) {
        text_ += (text_.back() == '/' ? "" : "/") + in_folder;
    }
    fields.insert(fields.end(), own_fields.begin(), own_fields.end());
    varies_ = FramePattern::of(text_).has_value() ||
              std::any_of(fields.begin(), fields.end(), [&](auto field) { return has(field); });
}

bool OutputTemplate::has(std::string_view field) const {
    return text_.find(in_braces(field)) != text_.npos;
}

std::string OutputTemplate::path_for(const InputFile& input,
                                     std::span<const NameField> fields) const {
    std::string text = text_;
    if (const auto pattern = FramePattern::of(text_)) {
        // Digits alone, so that names that are filled in are not taken for patterns.
        const std::string frame = needed_frame(input, text_);
        if (frame.size() > 9) {
            throw UsageError("the number of '" + input.path + "' is too long for -o " + text_);
        }
        text = pattern->path_of(std::stoi(frame));
    }
    const fs::path path = input.path == standard_stream ? "stdin" : input.path;
    const std::string extension = path.extension().string();
    std::vector<NameField> all(fields.begin(), fields.end());
    all.emplace_back("name", path.stem().string());
    all.emplace_back("ext", extension.empty() ? "" : extension.substr(1));
    all.emplace_back("frame", has("frame") ? needed_frame(input, text_) : "");
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const auto field = std::find_if(all.begin(), all.end(), [&](const NameField& f) {
            return text.compare(at, f.first.size() + 2, in_braces(f.first)) == 0;
        });
        if (field == all.end()) {
            out += text[at++];
        } else {
            out += field->second;
            at += field->first.size() + 2;
        }
    }
    return out;
}

void require_distinct(std::span<const Route> routes) {
    std::map<std::string, const Route*> by_output;
    for (const Route& route : routes) {
        const auto [at, is_new] = by_output.emplace(whole_path(route.to), &route);
        if (!is_new) {
            const bool is_one_input = at->second->from.path == route.from.path;
            throw UsageError(
                (is_one_input ? "several pictures of '" + route.from.path + "'"
                              : "'" + at->second->from.path + "' and '" + route.from.path + "'") +
                " would " + (is_one_input ? "all" : "both") + " be written to '" + route.to +
                "'; give -o a place for what differs, as out/{name}." +
                (is_one_input ? "{engine}.png" : "{ext}"));
        }
    }
    for (const Route& route : routes) {
        const auto found = by_output.find(whole_path(route.from.path));
        if (route.from.path != standard_stream && found != by_output.end() &&
            found->second != &route) {
            throw UsageError("'" + route.from.path +
                             "' is read, and would be overwritten by what "
                             "comes of '" +
                             found->second->from.path + "'; write into another folder");
        }
    }
}

void require_another_than(const std::string& input, std::string_view what,
                          const std::string& output) {
    std::error_code none;
    if (output != standard_stream && fs::equivalent(input, output, none)) {
        throw UsageError("-o names " + std::string(what) + " itself, '" + input +
                         "': name another file");
    }
}

void require_distinct(std::span<const std::string> outputs) {
    std::map<std::string, std::string> by_path;
    for (const std::string& output : outputs) {
        std::error_code failed;
        const bool is_special = fs::exists(output, failed) && !fs::is_regular_file(output, failed);
        const auto [at, is_new] = by_path.emplace(whole_path(output), output);
        if (!is_new && !is_special) {
            throw UsageError("two outputs would be written to '" + output +
                             (at->second == output ? "'" : "', also called '" + at->second + "'") +
                             "; give each a name of its own");
        }
    }
}

void make_folders(std::span<const Route> routes) {
    std::set<std::string> made;
    for (const Route& route : routes) {
        const fs::path folder = fs::path(route.to).parent_path();
        std::error_code failed;
        if (!folder.empty() && made.insert(folder.string()).second &&
            !fs::create_directories(folder, failed) && failed) {
            throw Error("cannot make the folder: " + failed.message(), {folder.string(), 0, {}});
        }
    }
}

bool is_up_to_date(const std::string& path, std::span<const std::string> inputs) {
    std::error_code failed;
    if (!fs::is_regular_file(path, failed) || fs::file_size(path, failed) == 0 || failed) {
        return false;
    }
    const fs::file_time_type made = fs::last_write_time(path, failed);
    return !failed && std::all_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
        std::error_code unknown;
        const fs::file_time_type changed = fs::last_write_time(input, unknown);
        return !unknown && changed < made;
    });
}

} // namespace lutlib::io
