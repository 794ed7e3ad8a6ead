#include "lutlib/io/box/serve.h"

#include "lutlib/io/box/shared_bytes.h"
#include "lutlib/io/box/shared_pool.h"
#include "lutlib/io/box/source.h"
#include "lutlib/io/box/values.h"

#include <cstring>
#include <string>

namespace lutlib::io::box {
namespace {

// The library opens files by a path; this one leads to what has been opened already.
std::string path_of(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

SharedBytes shared(std::string_view bytes) {
    if (bytes.empty()) {
        return {};
    }
    const SharedBytes out(bytes.size());
    std::memcpy(out.bytes().data(), bytes.data(), bytes.size());
    return out;
}

void read(const Oiio& library, const SharedPool& pool, Incoming& question, Outgoing& answer) {
    const std::string file = question.take_text();
    ImageReadOptions options;
    options.layer = question.take_text();
    options.partial = question.take_bool();
    const Descriptor opened(question.take_file());
    const SampleImage image =
        library.read(path_of(opened.get()), file, options, [&pool](std::size_t bytes) {
            constexpr std::size_t bytes_a_second = 1 << 22;
            limit_computing(static_cast<unsigned>(1 + bytes / bytes_a_second));
            return pool.take(bytes);
        });
    // Asked anew only when the answer has been used.
    static_cast<void>(put(answer, image, pool));
    put_source(answer, image.source.get(), shared(library.packed(*image.source)).descriptor());
}

void write(const Oiio& library, ForeignCache& cache, Incoming& question, Outgoing& answer) {
    const std::string name = question.take_text(), file = question.take_text();
    const ForeignImage given = take_foreign_image(question, cache);
    ImageWriteOptions options;
    options.keep_color = question.take_bool();
    options.text = question.take_pairs();
    const std::shared_ptr<const BoxedSource> boxed = take_source(question);
    std::shared_ptr<const PictureSource> keep = boxed;
    if (boxed && boxed->packed.descriptor() >= 0) {
        const auto bytes = boxed->packed.bytes();
        keep = library.unpacked({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    options.keep = keep.get();
    const Descriptor written(new_memory_file());
    answer.put_texts(library.write(path_of(written.get()), name, file, given.image, options));
    answer.attach(written.get());
}

} // namespace

Desk oiio_desk(const Oiio& library, const Held& held) {
    return [&library, held, pool = SharedPool(), cache = ForeignCache()](Incoming& question,
                                                                         Outgoing& answer) mutable {
        switch (question.take<OiioCall>()) {
        case OiioCall::held:
            return put(answer, held);
        case OiioCall::version:
            return answer.put(std::string_view(library.version()));
        case OiioCall::size: {
            const Descriptor opened(question.take_file());
            return answer.put(library.size(path_of(opened.get())));
        }
        case OiioCall::read:
            return read(library, pool, question, answer);
        case OiioCall::writes:
            return answer.put(std::uint8_t{library.writes(question.take_text())});
        case OiioCall::written_extensions:
            return answer.put_texts(library.written_extensions());
        case OiioCall::written_depth: {
            const std::string name = question.take_text(), file = question.take_text();
            const auto depth = question.take<Depth>();
            const Descriptor trial(new_memory_file());
            return answer.put(library.written_depth(path_of(trial.get()), name, file, depth));
        }
        case OiioCall::write:
            return write(library, cache, question, answer);
        }
        throw Error("a boxed reader was asked what it does not know");
    };
}

} // namespace lutlib::io::box
