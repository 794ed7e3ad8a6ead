#include "lutlib/io/box/serve.h"
#include "lutlib/io/box/values.h"

#include <memory>
#include <string>

namespace lutlib::io::box {
namespace {

EvaluationOptions take_evaluation(Incoming& from) {
    EvaluationOptions out;
    out.interpolation = from.take<Interpolation>();
    out.optimization = from.take<Optimization>();
    return out;
}

void read(const Ocio& library, Incoming& question, Outgoing& answer) {
    const std::string path = question.take_text(), file = question.take_text();
    ReadOptions options;
    options.size = question.take<std::int32_t>();
    put(answer, library.read_at(path, file, options));
}

void write(const Ocio& library, Incoming& question, Outgoing& answer) {
    const Lut lut = take_lut(question);
    const std::string name = question.take_text();
    WriteOptions options;
    options.title = question.take_text();
    options.size = question.take<std::int32_t>();
    options.bits = question.take<std::int32_t>();
    answer.put(std::string_view(library.write(lut, name, options)));
}

Transform from_config(const Ocio& library, Incoming& question) {
    ConfigConversion conversion;
    for (std::string* const text : {&conversion.config, &conversion.from, &conversion.to,
                                    &conversion.display, &conversion.view}) {
        *text = question.take_text();
    }
    return library.from_config(conversion);
}

} // namespace

Desk ocio_desk(const Ocio& library, const Held& held) {
    const auto made = std::make_shared<Transform>();
    return [&library, held, made](Incoming& question, Outgoing& answer) {
        switch (question.take<OcioCall>()) {
        case OcioCall::held:
            return put(answer, held);
        case OcioCall::version:
            return answer.put(std::string_view(library.version()));
        case OcioCall::readable_extensions:
            return answer.put_texts(library.readable_extensions());
        case OcioCall::parse: {
            const std::string path = question.take_text(), file = question.take_text();
            *made = library.parse_at(path, file, take_evaluation(question));
            return;
        }
        case OcioCall::from_lut: {
            const Lut lut = take_lut(question);
            *made = library.from_lut(lut, take_evaluation(question));
            return;
        }
        case OcioCall::from_config:
            *made = from_config(library, question);
            return;
        case OcioCall::read:
            return read(library, question, answer);
        case OcioCall::write:
            return write(library, question, answer);
        case OcioCall::images: {
            std::vector<RgbD> colors = question.take_all<RgbD>();
            (*made)(std::span(colors));
            return answer.put_all(std::span<const RgbD>(colors));
        }
        }
        throw Error("a boxed reader was asked what it does not know");
    };
}

} // namespace lutlib::io::box
