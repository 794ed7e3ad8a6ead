#include "lutlib/io/inputs.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/frames.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
    std::error_code failed;
    return path != standard_stream && fs::is_directory(path, failed);
}

bool is_there(const std::string& path) {
    std::error_code failed;
    return path == standard_stream || fs::exists(path, failed);
}

// The last digits of a name without its extension.
std::string number_of(const std::string& path) {
    constexpr std::string_view digits = "0123456789";
    std::string stem = fs::path(path).stem().string();
    const std::size_t last = stem.find_last_of(digits);
    if (last == stem.npos) {
        return {};
    }
    stem.resize(last + 1);
    const std::size_t before = stem.find_last_not_of(digits);
    return stem.substr(before == stem.npos ? 0 : before + 1);
}

// The paths of files in a folder, as `folder` begins them.
std::vector<std::string> paths_in(const std::string& folder) {
    std::error_code failed;
    std::vector<std::string> out;
    for (auto at = fs::directory_iterator(folder.empty() ? "." : folder, failed);
         !failed && at != fs::directory_iterator(); at.increment(failed)) {
        std::error_code unknown;
        if (at->is_regular_file(unknown)) {
            const std::string name = at->path().filename().string();
            out.push_back(folder.empty() || folder.back() == '/' ? folder + name
                                                                 : folder + '/' + name);
        }
    }
    if (failed) {
        throw Error("cannot read the folder: " + failed.message(), {folder, 0, {}});
    }
    return out;
}

void add_folder(const std::string& folder, Inputs& inputs,
                const std::function<bool(const std::string&)>& taken) {
    std::vector<std::string> paths;
    std::size_t others = 0;
    for (std::string& path : paths_in(folder)) {
        if (fs::path(path).filename().string().front() == '.') {
            continue;
        }
        if (taken(extension_of(path))) {
            paths.push_back(std::move(path));
        } else {
            ++others;
        }
    }
    if (paths.empty()) {
        throw Error("the folder holds no file of a type that is read here", {folder, 0, {}});
    }
    if (others > 0) {
        inputs.remarks.push_back(folder + ": left out " + std::to_string(others) +
                                 (others == 1 ? " file" : " files") +
                                 " of types that are not read here");
    }
    std::sort(paths.begin(), paths.end());
    for (std::string& path : paths) {
        std::string number = number_of(path);
        inputs.files.push_back({std::move(path), std::move(number), true});
    }
}

int value_of(const InputFile& file) {
    return std::stoi(file.frame); // of at most nine digits
}

// "1003, 1005-1007"
std::string gaps_of(const std::vector<InputFile>& files, std::size_t& missing) {
    constexpr std::size_t most = 5;
    std::string out;
    std::size_t gaps = 0;
    for (std::size_t i = 1; i < files.size(); ++i) {
        const int first = value_of(files[i - 1]) + 1, last = value_of(files[i]) - 1;
        if (first > last) {
            continue;
        }
        missing += static_cast<std::size_t>(last - first + 1);
        if (++gaps <= most) {
            out += (out.empty() ? "" : ", ") + std::to_string(first) +
                   (first == last ? "" : "-" + std::to_string(last));
        }
    }
    return gaps > most ? out + " and others" : out;
}

void add_sequence(const std::string& word, const FramePattern& pattern, Inputs& inputs) {
    const std::size_t slash = word.rfind('/');
    std::vector<InputFile> files;
    for (const std::string& path : paths_in(slash == word.npos ? "" : word.substr(0, slash + 1))) {
        if (const auto frame = pattern.frame_in(path)) {
            files.push_back({path, *frame});
        }
    }
    if (files.empty()) {
        throw Error("no file has a name of this pattern", {word, 0, {}});
    }
    std::sort(files.begin(), files.end(),
              [](const auto& a, const auto& b) { return value_of(a) < value_of(b); });
    std::size_t missing = 0;
    const std::string gaps = gaps_of(files, missing);
    if (missing > 0) {
        inputs.remarks.push_back(word + ": " + std::to_string(missing) +
                                 " numbers between the first and the last have no file: " + gaps +
                                 "; --frames names those that must be there");
    }
    inputs.files.insert(inputs.files.end(), files.begin(), files.end());
}

} // namespace

Inputs find_inputs(std::span<const std::string> words, const std::string& frames,
                   const std::function<bool(const std::string&)>& taken) {
    Inputs out;
    bool has_pattern = false;
    const std::vector<int> numbers = frames.empty() ? std::vector<int>{} : parse_frames(frames);
    for (const std::string& word : words) {
        const auto pattern = is_there(word) ? std::nullopt : FramePattern::of(word);
        has_pattern = has_pattern || pattern;
        if (is_folder(word)) {
            add_folder(word, out, taken);
            out.are_listed = true;
        } else if (pattern && frames.empty()) {
            add_sequence(word, *pattern, out);
            out.are_listed = true;
        } else if (pattern) {
            for (const int frame : numbers) {
                const std::string path = pattern->path_of(frame);
                out.files.push_back({path, *pattern->frame_in(path)});
            }
            out.are_listed = true;
        } else {
            out.files.push_back({word, word == standard_stream ? "" : number_of(word)});
        }
    }
    if (!frames.empty() && !has_pattern) {
        throw UsageError("--frames needs an input with a place for the number, as shot.####.exr "
                         "or shot.%04d.exr");
    }
    return out;
}

} // namespace lutlib::io
