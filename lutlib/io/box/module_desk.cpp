#include "lutlib/io/box/module_desk.h"

#include "lutlib/io/box/box.h"
#include "lutlib/io/box/values.h"
#include "lutlib/io/module.h"

namespace lutlib::io::box {
namespace {

Incoming ask_here(const Foreign& library, const Outgoing& asked, const About& about) {
    using Entry = const ModuleDesk* (*)();
    const auto* const desk = reinterpret_cast<Entry>(
        module_symbol(std::string(library.module), std::string(library.entry).c_str()))();
    Incoming question(asked.bytes(), {});
    question.take<std::uint32_t>(); // the seconds are a box's
    const Outgoing out = answered([&](Outgoing& to) { desk->answer(question, to); });
    Incoming answer(out.bytes(), {});
    throw_if_failed(answer, about.file);
    return answer;
}

} // namespace

Incoming ask_module(const Foreign& library, const Outgoing& asked, const About& about) {
    if (!is_used()) {
        return ask_here(library, asked, about);
    }
    return Reader(library, Allowance{memory(), {}}).ask(asked, about);
}

} // namespace lutlib::io::box
