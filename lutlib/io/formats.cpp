#include "lutlib/io/formats.h"

#include "lutlib/error.h"
#include "lutlib/formats/cube.h"
#include "lutlib/io/file.h"
#include "lutlib/io/fit_format.h"
#include "lutlib/io/ocio_formats.h"
#include "lutlib/io/picture_format.h"

#include <algorithm>
#include <cmath>

namespace lutlib::io {
namespace {

constexpr std::size_t sniffed_bytes = 4096;
constexpr int magic_score = 80;
constexpr int extension_score = 40;

bool has_extension(const FileFormat& format, std::string_view extension) {
    return std::find(format.extensions.begin(), format.extensions.end(), extension) !=
           format.extensions.end();
}

FileFormat own_format(const Format& row) {
    FileFormat out;
    out.name = row.name;
    out.label = row.label;
    out.extensions.assign(row.extensions.begin(), row.extensions.end());
    out.holds = row.holds;
    out.sniff = row.sniff;
    if (row.read) {
        out.read = [read = row.read](std::string_view bytes, const std::string& file,
                                     const ReadOptions&) {
            return Reading{read(bytes, file), {}};
        };
    }
    if (row.write) {
        out.write = [write = row.write](const Lut& lut, const SaveOptions& options) {
            return write(lut, WriteOptions{options.title});
        };
    }
    return out;
}

FileFormat ocio_format(const OcioFormat& row) {
    FileFormat out;
    out.name = row.name;
    out.label = row.label;
    out.extensions.assign(row.extensions.begin(), row.extensions.end());
    out.holds = row.holds;
    if (row.readable) {
        out.sniff = [magic = row.magic](std::string_view bytes) {
            const bool found = !magic.empty() &&
                               bytes.substr(0, sniffed_bytes).find(magic) != std::string_view::npos;
            return found ? magic_score : 0;
        };
        out.read = [extensions = out.extensions](std::string_view bytes, const std::string& file,
                                                 const ReadOptions& options) {
            const std::string own = extension_of(file);
            const bool known =
                std::find(extensions.begin(), extensions.end(), own) != extensions.end();
            return ocio().read(bytes, known ? own : extensions.front(), file, options);
        };
    }
    if (row.write) {
        out.write = [write = row.write](const Lut& lut, const SaveOptions& options) {
            return write(lut, WriteOptions{options.title});
        };
    } else if (!row.ocio_writer.empty()) {
        out.write = [writer = std::string(row.ocio_writer)](const Lut& lut,
                                                            const SaveOptions& options) {
            return ocio().write(lut, writer, WriteOptions{options.title});
        };
    }
    return out;
}

std::vector<FileFormat> make_table() {
    std::vector<FileFormat> out;
    for (const Format& row : cube_formats()) {
        out.push_back(own_format(row));
    }
    for (const OcioFormat& row : ocio_formats()) {
        out.push_back(ocio_format(row));
    }
    out.push_back(recognised_picture_format());
    for (const Layout& row : layouts()) {
        out.push_back(picture_format(row));
    }
    return out;
}

enum class Which { read, written, all };

std::string names(Which which) {
    std::string out;
    for (const FileFormat& row : file_formats()) {
        if (which == Which::all || (which == Which::read && row.read) ||
            (which == Which::written && row.write)) {
            out += (out.empty() ? "" : ", ") + row.name;
        }
    }
    return out;
}

// What OpenColorIO makes of a file that its own writer wrote. Some formats leave it to the reader
// to guess how large the codes are, and a dark look is then read as a bright one.
void check_reading_back(const std::string& bytes, const FileFormat& format, const Lut& meant,
                        std::vector<Loss>& losses) {
    const auto reread = [&] {
        try {
            return format.read(bytes, "look." + format.extensions.front(), {}).lut;
        } catch (const Error& error) {
            throw Error(
                "a ." + format.extensions.front() +
                " of this look cannot be read back, take another format: " + error.message());
        }
    };
    const Lut back = reread();
    if (back.cube && meant.cube && back.cube->size == meant.cube->size) {
        double most = 0;
        for (std::size_t i = 0; i < meant.cube->nodes.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                most = std::max(most, std::abs(static_cast<double>(back.cube->nodes[i][c]) -
                                               std::clamp(meant.cube->nodes[i][c], 0.0F, 1.0F)));
            }
        }
        if (most > 2 / std::ldexp(1.0, format.holds.integer_bits)) {
            losses.push_back({"readers take its codes for another depth, largest error", most, ""});
        }
    }
}

} // namespace

const std::vector<FileFormat>& file_formats() {
    static const std::vector<FileFormat> table = make_table();
    return table;
}

const FileFormat* file_format_named(std::string_view name) {
    const auto& table = file_formats();
    const auto row = std::find_if(table.begin(), table.end(),
                                  [&](const FileFormat& format) { return format.name == name; });
    return row == table.end() ? nullptr : &*row;
}

const FileFormat& require_file_format(std::string_view name) {
    const FileFormat* const row = file_format_named(name);
    if (!row) {
        throw UsageError("there is no format '" + std::string(name) + "'; there are " +
                         names(Which::all));
    }
    return *row;
}

const FileFormat& format_for_writing(const std::string& path, const Lut& lut) {
    const std::string extension = path == standard_stream ? "cube" : extension_of(path);
    const FileFormat* first = nullptr;
    for (const FileFormat& row : file_formats()) {
        if (row.write && has_extension(row, extension)) {
            if (can_hold(lut, row.holds)) {
                return row;
            }
            first = first ? first : &row;
        }
    }
    if (!first) {
        throw UsageError("no format that can be written has the extension of " + output_name(path) +
                         "; choose one with --format: " + names(Which::written));
    }
    return *first;
}

const FileFormat& recognise_format(std::string_view bytes, const std::string& file) {
    const std::string extension = extension_of(file);
    const FileFormat* best = nullptr;
    int best_score = 0;
    for (const FileFormat& row : file_formats()) {
        if (!row.read) {
            continue;
        }
        const int score = (row.sniff ? row.sniff(bytes) : 0) +
                          (has_extension(row, extension) ? extension_score : 0);
        if (score > best_score) {
            best = &row;
            best_score = score;
        }
    }
    if (!best) {
        throw Error(
            "no known LUT format by content or extension; 'lutconv convert --from NAME' reads it "
            "as one of these: " +
                names(Which::read),
            {file, 0, {}});
    }
    return *best;
}

Reading decode_lut(std::string_view bytes, const std::string& file, const ReadOptions& options,
                   std::string_view format) {
    const FileFormat& row =
        format.empty() ? recognise_format(bytes, file) : require_file_format(format);
    if (!row.read) {
        throw UsageError("the format '" + row.name + "' can only be written");
    }
    Reading out = row.read(bytes, file, options);
    out.lut.provenance = file;
    return out;
}

Reading read_lut(const std::string& path, const ReadOptions& options, std::string_view format) {
    return decode_lut(read_file(path), input_name(path), options, format);
}

Encoded encode_lut(const Lut& lut, const FileFormat& format, const SaveOptions& options) {
    if (!format.write) {
        throw UsageError("the format '" + format.name + "' can only be read");
    }
    Holds holds = format.holds;
    int size = options.size;
    if (format.picture) {
        holds.integer_bits = options.bits;
        size = picture_cube_size(*format.picture, lut, options.size);
    }
    FitToFormat fit = fit_to(lut, holds, size);
    Encoded out{format.write(fit.lut, options), std::move(fit.lut), std::move(fit.losses)};
    if (format.read && holds.integer_bits > 0 && !format.picture) {
        check_reading_back(out.bytes, format, out.lut, out.losses);
    }
    return out;
}

Encoded write_lut(const std::string& path, const Lut& lut, const SaveOptions& options,
                  std::string_view format) {
    const FileFormat& row =
        format.empty() ? format_for_writing(path, lut) : require_file_format(format);
    Encoded out = encode_lut(lut, row, options);
    write_file(path, out.bytes);
    return out;
}

} // namespace lutlib::io
