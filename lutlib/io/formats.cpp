#include "lutlib/io/formats.h"

#include "lutlib/error.h"
#include "lutlib/formats/all.h"
#include "lutlib/formats/mistaken.h"
#include "lutlib/io/file.h"
#include "lutlib/io/fit_format.h"
#include "lutlib/io/formats/all.h"
#include "lutlib/io/formats/picture.h"
#include "lutlib/io/read_back.h"
#include "lutlib/named.h"
#include "lutlib/text.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace lutlib::io {
namespace {

constexpr auto rows = std::to_array<const FileFormat*>({
    &formats::cube,
    &formats::cube_resolve,
    &formats::flame,
    &formats::lustre,
    &formats::azasset,
    &formats::csp,
    &formats::spi1d,
    &formats::spi3d,
});

std::vector<const FileFormat*> make_table() {
    std::vector<const FileFormat*> out(rows.begin(), rows.end());
    const auto append = [&out](std::span<const FileFormat> more) {
        for (const FileFormat& row : more) {
            out.push_back(&row);
        }
    };
    append(formats::opencolorios());
    out.push_back(&formats::png);
    out.push_back(&formats::picture);
    append(formats::pictures());
    return out;
}

template <class Condition>
std::vector<const FileFormat*> formats_where(Condition condition) {
    std::vector<const FileFormat*> out;
    std::copy_if(file_formats().begin(), file_formats().end(), std::back_inserter(out), condition);
    return out;
}

int content_score(const FileFormat& format, std::string_view bytes) {
    constexpr std::size_t searched_bytes = 4096;
    constexpr int magic_score = 80;
    if (format.recognise) {
        return format.recognise(bytes);
    }
    const bool found = !format.magic.empty() &&
                       bytes.substr(0, searched_bytes).find(format.magic) != std::string_view::npos;
    return found ? magic_score : 0;
}

// How much of the look a format keeps: its domains too, its tables, or a resampled table.
int keeps(const FileFormat& format, const Lut& lut) {
    return can_hold(lut, format.holds)                             ? 2
           : lut.shaper && lut.cube && format.holds.curve_and_cube ? 1
                                                                   : 0;
}

} // namespace

std::span<const FileFormat* const> file_formats() {
    static const std::vector<const FileFormat*> table = make_table();
    return table;
}

const FileFormat& require_file_format(std::string_view name) {
    return require_named(file_formats(), "format", name);
}

const FileFormat& format_for_writing(const std::string& path, const Lut& lut) {
    const std::string extension =
        path == standard_stream ? file_formats().front()->extensions.first() : extension_of(path);
    const auto writers = formats_where([](const FileFormat* row) { return row->write != nullptr; });
    const FileFormat* best = nullptr;
    for (const FileFormat* const row : writers) {
        if (row->extensions.contain(extension) && (!best || keeps(*row, lut) > keeps(*best, lut))) {
            best = row;
        }
    }
    if (!best && std::filesystem::is_directory(path)) {
        throw Error("this is a directory; name a file in it", {path, 0, {}});
    }
    if (!best) {
        throw UsageError("no format that can be written has the extension of " + output_name(path) +
                         "; end its name in one that has, such as .cube ('lutconv formats' lists "
                         "them), or choose with 'convert --format': " +
                         names_of(writers));
    }
    return *best;
}

const FileFormat* find_format(std::string_view bytes, const std::string& file) {
    constexpr int extension_score = 40;
    const std::string extension = extension_of(file);
    const FileFormat* best = nullptr;
    int best_score = 0;
    for (const FileFormat* const row : file_formats()) {
        const int score = !row->read
                              ? 0
                              : content_score(*row, bytes) +
                                    (row->extensions.contain(extension) ? extension_score : 0);
        if (score > best_score) {
            best = row;
            best_score = score;
        }
    }
    return best;
}

const FileFormat& recognise_format(std::string_view bytes, const std::string& file) {
    refuse_mistaken_file(bytes, file);
    if (const std::optional<std::string> utf8 = utf8_of_utf16(bytes)) {
        return recognise_format(*utf8, file);
    }
    const FileFormat* const best = find_format(bytes, file);
    if (!best && extension_of(file) == "json") {
        throw Error("this is no recipe: a recipe is a JSON object with \"schema_version\"; look at "
                    "how it begins",
                    {file, 0, {}});
    }
    if (!best) {
        throw Error(
            "no known LUT format by content or extension; 'lutconv convert --from NAME' reads it "
            "as one of these: " +
                names_of(formats_where([](const FileFormat* row) { return row->read != nullptr; })),
            {file, 0, {}});
    }
    return *best;
}

Reading decode_lut(std::string_view bytes, const std::string& file, const ReadOptions& options,
                   std::string_view format) {
    refuse_mistaken_file(bytes, file);
    if (const std::optional<std::string> utf8 = utf8_of_utf16(bytes)) {
        return decode_lut(*utf8, file, options, format);
    }
    const FileFormat& row =
        format.empty() ? recognise_format(bytes, file) : require_file_format(format);
    if (!row.read) {
        throw UsageError("the format '" + std::string(row.name) + "' can only be written");
    }
    try {
        Reading out = row.read(row, bytes, file, options);
        out.lut.provenance = file;
        return out;
    } catch (const UsageError&) {
        throw;
    } catch (const Error& error) { // of a check that knows no file
        throw error.where().file.empty() ? error.in_file(file) : error;
    }
}

Reading read_lut(const std::string& path, const ReadOptions& options, std::string_view format) {
    return decode_lut(read_file(path), input_name(path), options, format);
}

Encoded encode_lut(const Lut& lut, const FileFormat& format, const WriteOptions& options) {
    if (!format.write) {
        throw UsageError("the format '" + std::string(format.name) + "' can only be read");
    }
    Holds holds = format.holds;
    int size = options.size;
    if (format.layout) {
        holds.integer_bits = options.bits;
        size = formats::picture_cube_size(*format.layout, lut, options.size);
    }
    FitToFormat fit = fit_to(lut, holds, size);
    Encoded out{
        format.write(format, fit.lut, options), std::move(fit.lut), std::move(fit.losses), {}};
    if (format.opencolorio && format.read) {
        if (std::optional<Loss> lost = lost_in_reading(format, out.bytes, out.lut)) {
            out.losses.push_back(std::move(*lost));
        }
    }
    if (format.readers) {
        out.readers = format.readers(out.lut);
    }
    return out;
}

Encoded write_lut(const std::string& path, const Lut& lut, const WriteOptions& options,
                  std::string_view format) {
    const FileFormat& row =
        format.empty() ? format_for_writing(path, lut) : require_file_format(format);
    Encoded out = encode_lut(lut, row, options);
    write_file(path, out.bytes);
    return out;
}

} // namespace lutlib::io
