#include "converter/reading_limits.h"

#include "lutlib/io/box/box.h"
#include "lutlib/io/references.h"

#include <cstdio>

namespace converter {
namespace {

bool has_no_sandbox = false, allows_outside = false;
double gigabytes = 4;

} // namespace

void declare_reading_limits(Verb& verb) {
    has_no_sandbox = allows_outside = false;
    gigabytes = 4;
    const std::string heading = "Files from strangers";
    verb.add_flag(
            "--no-sandbox", has_no_sandbox,
            "let OpenImageIO and OpenColorIO read files in this process, with all that it may "
            "do")
        .group(heading);
    verb.add_flag("--allow-outside", allows_outside,
                  "let a recipe name a base outside its own folder")
        .group(heading);
    verb.add_option("--max-memory", gigabytes,
                    "GiB that the process which reads a file for them may take")
        .takes(Takes::above_zero)
        .capture_default_str()
        .group(heading);
}

void apply_reading_limits() {
    lutlib::io::allow_references_outside(allows_outside);
    lutlib::io::box::set_used(!has_no_sandbox);
    lutlib::io::box::set_memory(static_cast<std::size_t>(gigabytes * (1 << 30)));
    if (has_no_sandbox) {
        std::fputs("lutconv: files are read without a sandbox\n", stderr);
    }
}

} // namespace converter
