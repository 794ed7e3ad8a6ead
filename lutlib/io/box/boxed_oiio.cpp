#include "lutlib/io/box/boxed_oiio.h"

#include "lutlib/io/box/box.h"
#include "lutlib/io/box/serve.h"
#include "lutlib/io/box/source.h"
#include "lutlib/io/box/values.h"
#include "lutlib/io/file.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>

namespace lutlib::io::box {
namespace {

[[noreturn]] void fail(const char* message, const std::string& file) {
    throw Error(message + (": " + std::generic_category().message(errno)), {file, 0, {}});
}

void write_all(const std::string& path, int memory, const std::string& file) {
    const Descriptor to(::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (to.get() < 0) {
        fail("cannot open the file for writing", file);
    }
    copy_all(to.get(), memory, "cannot write the picture", file);
}

// A reader's work on a picture of ours, not on a file of so many bytes.
About about_picture(const std::string& file, const SampleImage& image) {
    return {file, image.pixels() * 2};
}

} // namespace

template <class Take>
auto BoxedOiio::ask(const Outgoing& question, const About& about, const Take& take) const {
    Asked asked;
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty()) {
            asked = std::move(idle_.back());
            idle_.pop_back();
        }
    }
    if (!asked.reader) {
        asked.reader = std::make_unique<Reader>(library_, Allowance{box::memory(), {}});
    }
    const auto keep = [&] {
        if (asked.reader->is_alive()) {
            const std::lock_guard lock(mutex_);
            idle_.push_back(std::move(asked));
        }
    };
    try {
        Incoming answer = asked.reader->ask(question, about);
        auto out = take(answer, asked.pictures);
        keep();
        return out;
    } catch (...) {
        keep();
        throw;
    }
}

Held BoxedOiio::held() const {
    return ask(question(OiioCall::held, {}), {},
               [](Incoming& answer, ForeignCache&) { return take_held(answer); });
}

std::string BoxedOiio::version() const {
    return ask(question(OiioCall::version, {}), {},
               [](Incoming& answer, ForeignCache&) { return answer.take_text(); });
}

Oiio::Size BoxedOiio::size(const std::string& path) const {
    const FileCopy copy = copies_.keep(path, path);
    const About about{path, copy.size()};
    Outgoing asked = question(OiioCall::size, about);
    asked.attach(copy.memory->get());
    return ask(asked, about, [](Incoming& answer, ForeignCache&) { return answer.take<Size>(); });
}

SampleImage BoxedOiio::read(const std::string& path, const std::string& file,
                            const ImageReadOptions& options, const Allocate&) const {
    const FileCopy copy = copies_.take(path, file);
    const About about{file, copy.size()};
    Outgoing asked = question(OiioCall::read, about);
    asked.put(std::string_view(file));
    asked.put(std::string_view(options.layer));
    asked.put(std::uint8_t{options.partial});
    asked.attach(copy.memory->get());
    return ask(asked, about, [&](Incoming& answer, ForeignCache& pictures) {
        SampleImage out =
            take_image(answer, pictures, [this](std::size_t size) { return pool_.take(size); });
        out.source = take_source(answer);
        return out;
    });
}

bool BoxedOiio::writes(const std::string& path) const {
    Outgoing asked = question(OiioCall::writes, {});
    asked.put(std::string_view(path));
    return ask(asked, {}, [](Incoming& answer, ForeignCache&) { return answer.take_bool(); });
}

std::vector<std::string> BoxedOiio::written_extensions() const {
    return ask(question(OiioCall::written_extensions, {}), {},
               [](Incoming& answer, ForeignCache&) { return answer.take_texts(); });
}

Depth BoxedOiio::written_depth(const std::string&, const std::string& name, const std::string& file,
                               Depth depth) const {
    const About about{file};
    Outgoing asked = question(OiioCall::written_depth, about);
    asked.put(std::string_view(name));
    asked.put(std::string_view(file));
    asked.put(depth);
    return ask(asked, about, [](Incoming& answer, ForeignCache&) { return answer.take<Depth>(); });
}

SampleBuffer BoxedOiio::memory(std::size_t bytes) const {
    return pool_.take(bytes);
}

std::vector<std::string> BoxedOiio::write(const std::string& path, const std::string& name,
                                          const std::string& file, const SampleImage& image,
                                          const ImageWriteOptions& options) const {
    const About about = about_picture(file, image);
    Outgoing asked = question(OiioCall::write, about);
    asked.put(std::string_view(name));
    asked.put(std::string_view(file));
    const SampleBuffer lent = put(asked, image, pool_);
    asked.put(std::uint8_t{options.keep_color});
    asked.put_pairs(options.text);
    const auto* const boxed = dynamic_cast<const BoxedSource*>(options.keep);
    put_source(asked, options.keep, boxed ? boxed->packed.descriptor() : -1);
    return ask(asked, about, [&](Incoming& answer, ForeignCache&) {
        std::vector<std::string> lost = answer.take_texts();
        const Descriptor written(answer.take_file());
        write_all(path, written.get(), file);
        return lost;
    });
}

std::string BoxedOiio::packed(const PictureSource& source) const {
    const auto* const boxed = dynamic_cast<const BoxedSource*>(&source);
    const auto bytes = boxed ? boxed->packed.bytes() : std::span<const std::byte>{};
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::shared_ptr<const PictureSource> BoxedOiio::unpacked(std::string_view) const {
    throw Error("a boxed picture is unpacked in its reader");
}

} // namespace lutlib::io::box
