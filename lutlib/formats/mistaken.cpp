#include "lutlib/formats/mistaken.h"

#include "lutlib/error.h"
#include "lutlib/text.h"

#include <algorithm>
#include <array>

namespace lutlib {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view archive = "take the LUT out of it and give that";
constexpr std::string_view document =
    "copy the LUT's text into a text editor and save it as plain text";

struct Mistaken {
    std::string_view begins; ///< its first bytes
    std::string_view what;
    std::string_view remedy;
};

constexpr std::array<Mistaken, 14> mistaken_types{{
    {"{\\rtf"sv, "rich text (RTF) as a word processor saves it",
     "open it in a text editor and save it as plain text (in TextEdit: Format, Make Plain Text)"},
    {"version https://git-lfs.github.com/spec/"sv, "a Git LFS pointer to the file",
     "fetch the file with 'git lfs pull' in its repository"},
    {"version https://hawser.github.com/spec/"sv, "a Git LFS pointer to the file",
     "fetch the file with 'git lfs pull' in its repository"},
    {"/annex/objects/"sv, "a git-annex pointer to the file",
     "fetch the file with 'git annex get' in its repository"},
    {"PK\3\4"sv, "a ZIP archive (or an office document, which is one)", archive},
    {"PK\5\6"sv, "an empty ZIP archive", "download or pack it again"},
    {"7z\xBC\xAF\x27\x1C"sv, "a 7-Zip archive", archive},
    {"Rar!\x1A\7"sv, "a RAR archive", archive},
    {"\x1F\x8B"sv, "compressed by gzip", "decompress it with gunzip first"},
    {"BZh"sv, "compressed by bzip2", "decompress it with bunzip2 first"},
    {"\xFD\x37zXZ\0"sv, "compressed by xz", "decompress it with unxz first"},
    {"%PDF-"sv, "a PDF document", document},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, "an office document", document},
    {"\xFF\xFE\0\0"sv, "UTF-32 text", "save it as UTF-8"},
}};

const Mistaken* row_of(std::string_view bytes) {
    const auto* const row =
        std::find_if(mistaken_types.begin(), mistaken_types.end(),
                     [&](const Mistaken& each) { return bytes.starts_with(each.begins); });
    return row == mistaken_types.end() ? nullptr : row;
}

// A page may begin with blanks, a byte order mark, comments or an XML declaration.
bool is_web_page(std::string_view bytes) {
    constexpr std::size_t head = 1024;
    const std::string text = upper(bytes.substr(0, head));
    const std::size_t first = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
    if (first == std::string::npos || text[first] != '<') {
        return false;
    }
    constexpr std::array marks{"<!DOCTYPE HTML"sv, "<HTML"sv, "<HEAD>"sv, "<BODY"sv, "<SCRIPT"sv};
    return std::any_of(marks.begin(), marks.end(), [&](std::string_view mark) {
        return text.find(mark, first) != std::string::npos;
    });
}

[[noreturn]] void refuse(std::string_view what, std::string_view remedy, const std::string& file) {
    throw Error("this is " + std::string(what) + ", not a LUT; " + std::string(remedy),
                {file, 0, {}});
}

} // namespace

bool begins_as_mistaken(std::string_view bytes) {
    return row_of(bytes) != nullptr || is_web_page(bytes);
}

void refuse_mistaken_file(std::string_view bytes, const std::string& file) {
    if (const Mistaken* row = row_of(bytes)) {
        refuse(row->what, row->remedy, file);
    }
    if (is_web_page(bytes)) {
        refuse("a web page (HTML)",
               "download the file itself instead of the page that shows it (on GitHub: Raw)", file);
    }
}

} // namespace lutlib
