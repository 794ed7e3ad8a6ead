// Runs lutconv as a person does, in a folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace converter_test {

struct Result {
    int exit_code = -1;
    std::string out, err;
};

/// Runs lutconv with these arguments and this standard input, in a process of its own.
Result lutconv_process(const std::vector<std::string>& arguments, const std::string& input = "");

/// The same; under a sanitizer in this process, where nothing depends on another.
Result lutconv(const std::vector<std::string>& arguments, const std::string& input = "");

/// The same without a process of its own, for tests of many runs: its start costs more than a small
/// LUT's work, and a sanitizer's much more.
Result lutconv_in_process(const std::vector<std::string>& arguments);

/// The verbs as the program itself lists them, so that a new one is tested unasked.
std::vector<std::string> verbs();

/// Of what lies in a folder, in order.
std::vector<std::string> names_in(const std::string& folder);

/// A new empty folder, removed with the object.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string path(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const;
    std::vector<std::string> names() const { return names_in(path_.string()); }

  private:
    std::filesystem::path path_;
};

std::string contents(const std::string& path);

/// A .cube of a strongly saturated look, six decimals a value, so that every verb has real work.
std::string saturated_cube(int size, const std::string& head = "");

} // namespace converter_test
