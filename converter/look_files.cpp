#include "converter/look_files.h"

#include "converter/report.h"
#include "lutlib/engine/layout.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/named.h"

namespace converter {
namespace {

namespace io = lutlib::io;

const lutlib::Layout* named_layout = nullptr; ///< by --layout

io::LookOptions with_layout(io::LookOptions options) {
    options.layout = options.layout ? options.layout : named_layout;
    return options;
}

void complain_of(const std::vector<lutlib::Loss>& losses, const std::string& name) {
    for (const lutlib::Loss& loss : losses) {
        print("lutconv: " + one_line(name) + ": lost: " + loss_text(loss) + '\n',
              std::string(io::standard_stream));
    }
}

// Vendors' keywords may change what a table means.
void complain_of_keywords(const std::vector<std::string>& keywords, const std::string& name) {
    for (const std::string& line : keywords) {
        print("lutconv: " + one_line(name) + ": kept but not acted on: " + one_line(line) + '\n',
              std::string(io::standard_stream));
    }
}

io::Look told(io::Look look) {
    tell_remarks(look);
    for (const io::LookFile& file : look.files()) {
        complain_of(file.losses, file.name);
        complain_of_keywords(file.keywords, file.name);
    }
    return look;
}

} // namespace

void declare_layout(CLI::App& verb) {
    named_layout = nullptr;
    verb.add_option_function<std::string>(
        "--layout",
        [](const std::string& name) {
            named_layout = &require_named(lutlib::layouts(), "layout", name);
        },
        "the layout of LUT pictures that are read, where their content does not tell it or tells "
        "it wrong: " +
            lutlib::names_of(lutlib::layouts()));
}

const lutlib::Layout* layout_option() {
    return named_layout;
}

void tell_remarks(const io::Look& look) {
    for (const io::LookFile& file : look.files()) {
        for (const std::string& remark : file.remarks) {
            print("lutconv: " + one_line(file.name) + ": " + one_line(remark) + '\n',
                  std::string(io::standard_stream));
        }
    }
}

io::Look open_look(const std::string& path, const io::LookOptions& options) {
    return told(io::Look::open(path, with_layout(options)));
}

io::Look open_look(std::string bytes, const std::string& path) {
    return told(io::Look::of_bytes(std::move(bytes), path, with_layout({})));
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

void write_look(const lutlib::Lut& lut, const std::string& path) {
    complain_of(io::write_lut(path, lut).losses, io::output_name(path));
}

} // namespace converter
