#include "converter/look_files.h"

#include "converter/report.h"
#include "lutlib/engine/layout.h"
#include "lutlib/io/formats.h"
#include "lutlib/named.h"

#include <atomic>

namespace converter {
namespace {

namespace io = lutlib::io;

const lutlib::Layout* named_layout = nullptr; ///< by --layout
std::atomic<bool> layout_has_part = false;    ///< a picture was read as a look

io::LookOptions with_layout(io::LookOptions options) {
    options.layout = options.layout ? options.layout : named_layout;
    return options;
}

void complain(const std::string& name, const std::string& sentence) {
    print("lutconv: " + one_line(name) + ": " + one_line(sentence) + '\n',
          std::string(io::standard_stream));
}

void complain_of(const std::vector<lutlib::Loss>& losses, const std::string& name) {
    for (const lutlib::Loss& loss : losses) {
        complain(name, "lost: " + loss_text(loss));
    }
}

void complain_of_keywords(const std::vector<std::string>& lines, const std::string& name) {
    for (const std::string& line : lines) {
        complain(name, "kept but not acted on: " + line);
    }
}

// The base of a recipe may be a picture too.
io::Look counted(io::Look look) {
    if (look.kind().layout || look.files().size() > 1) {
        layout_has_part = true;
    }
    return look;
}

io::Look told(io::Look look) {
    tell_of(look);
    return look;
}

} // namespace

void declare_layout(Verb& verb) {
    named_layout = nullptr;
    layout_has_part = false;
    verb.add_action(
        "--layout",
        [](const std::string& name) {
            named_layout = &require_named(lutlib::layouts(), "layout", name);
        },
        "the layout of the LUT pictures to read, where it is not recognised or recognised "
        "wrongly: " +
            lutlib::names_of(lutlib::layouts()));
}

void tell_of(const lutlib::Lut& table, const std::string& path) {
    for (const std::string& note : table.notes) {
        complain(io::input_name(path), note);
    }
    complain_of_keywords(table.keywords, io::input_name(path));
}

void tell_of(const io::Look& look) {
    for (const io::LookFile& file : look.files()) {
        for (const std::string& remark : file.remarks) {
            complain(file.name, remark);
        }
        complain_of(file.losses, file.name);
        complain_of_keywords(file.keywords, file.name);
    }
    const lutlib::Op* const matte = look.recipe() ? matte_of(*look.recipe()) : nullptr;
    if (matte != nullptr) {
        complain(look.files().front().name,
                 "it shows the matte of " + std::string(matte->name) +
                     " in place of the look; take its \"matte\" out for the look");
    }
}

void tell_unused_layout() {
    if (named_layout && !layout_has_part) {
        print(std::string("lutconv: --layout changes nothing here: no look is a picture\n"),
              std::string(io::standard_stream));
    }
}

io::Look identity_look() {
    return io::Look::of_bytes(R"({"schema_version": 1, "operators": []})",
                              std::string(identity_word));
}

io::Look open_quietly(const std::string& path, const io::LookOptions& options) {
    return counted(io::Look::open(path, with_layout(options)));
}

std::optional<io::Look> open_if_look_quietly(const std::string& path,
                                             const io::LookOptions& options) {
    std::optional<io::Look> look = io::Look::open_if_look(path, with_layout(options));
    return look ? std::optional(counted(std::move(*look))) : std::nullopt;
}

io::Look open_look(const std::string& path, const io::LookOptions& options) {
    return told(open_quietly(path, options));
}

io::Look open_look(std::string bytes, const std::string& path) {
    return told(counted(io::Look::of_bytes(std::move(bytes), path, with_layout({}))));
}

std::shared_ptr<const lutlib::Lut> table_of(const io::Look& look) {
    io::LookTable table = look.table();
    complain_of(table.losses, io::input_name(look.path()));
    return std::move(table.lut);
}

std::shared_ptr<const lutlib::Lut> read_table(const std::string& path) {
    return table_of(open_look(path));
}

lutlib::Recipe recipe_of(const io::Look& look) {
    if (!look.recipe()) {
        table_of(look);
    }
    return look.as_recipe();
}

WrittenLook written_as(const lutlib::FileFormat& format, io::Encoded file) {
    const auto lut = std::make_shared<const lutlib::Lut>(std::move(file.lut));
    if (file.losses.empty() || !format.read) {
        return {lut, std::move(file.losses), lutlib::Transform::of(lut), breaks_of(*lut)};
    }
    const io::Look look =
        io::Look::of_bytes(std::move(file.bytes), "the file." + format.extensions.first(),
                           {.format = std::string(format.name),
                            .interpolation = lut->cube ? lut->interpolation : std::nullopt});
    return {lut, std::move(file.losses), look.exact(), look.breaks()};
}

WrittenLook write_look(const lutlib::Lut& lut, const std::string& path,
                       std::span<const io::FileToWrite> others) {
    const lutlib::FileFormat& format = io::format_for_writing(path, lut);
    io::Encoded file = io::encode_lut(lut, format);
    std::vector<io::FileToWrite> files{{path, file.bytes}};
    files.insert(files.end(), others.begin(), others.end());
    io::write_files(files);
    for (const std::string& reader : file.readers) {
        complain(io::output_name(path), reader);
    }
    return written_as(format, std::move(file));
}

void tell_losses(const WrittenLook& written, const std::string& path) {
    complain_of(written.losses, io::output_name(path));
}

} // namespace converter
