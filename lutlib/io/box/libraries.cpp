// OpenImageIO and OpenColorIO as everybody gets them: boxed, unless the program has said otherwise.
#include "lutlib/io/box/box.h"
#include "lutlib/io/box/boxed_ocio.h"
#include "lutlib/io/box/boxed_oiio.h"
#include "lutlib/io/module.h"

namespace lutlib::io {
namespace {

template <class Library>
const Library& in_this_process(const char* module) {
    using Entry = const Library* (*)();
    static const Library* const library = reinterpret_cast<Entry>(module_symbol(module, module))();
    return *library;
}

} // namespace

const Ocio& ocio() {
    static const box::BoxedOcio boxed;
    return box::is_used() ? boxed : in_this_process<Ocio>("lutlib_ocio");
}

const Oiio& oiio() {
    static const box::BoxedOiio boxed;
    return box::is_used() ? boxed : in_this_process<Oiio>("lutlib_oiio");
}

} // namespace lutlib::io
