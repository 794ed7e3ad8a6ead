// lutlib's own types in messages.
#pragma once

#include "lutlib/format.h"
#include "lutlib/io/box/confine.h"
#include "lutlib/io/box/foreign_cache.h"
#include "lutlib/io/box/message.h"
#include "lutlib/io/box/shared_pool.h"
#include "lutlib/io/oiio.h"

namespace lutlib::io::box {

void put(Outgoing& to, const Lut& lut);
/// Validated: what a box says of a look is a stranger's word. Throws Error.
Lut take_lut(Incoming& from);

void put(Outgoing& to, const Reading& reading);
Reading take_reading(Incoming& from);

/// Its pixels travel as shared memory, of the pool's where they do not lie in such; its source does
/// not. What it answers is to live until the message has been used.
[[nodiscard]] SampleBuffer put(Outgoing& to, const SampleImage& image, const SharedPool& pool);
/// Copied from where its sender may still change it to a buffer that `allocate` gives. Throws Error
/// for sides outside limits.h, and for pixels that are not as many.
SampleImage take_image(Incoming& from, ForeignCache& cache, const Oiio::Allocate& allocate);

/// A picture where its sender has it, to read only.
struct ForeignImage {
    SampleImage image; ///< of samples in `bytes`
    ForeignBytes bytes;
};
ForeignImage take_foreign_image(Incoming& from, ForeignCache& cache);

void put(Outgoing& to, const Held& held);
Held take_held(Incoming& from);

/// A library's answer, or what it throws: Error and UsageError as they are, a lack of memory and
/// others as what they are about.
template <class Answer>
Outgoing answered(Answer&& answer);
/// Throws what the other side threw, about `file` where it names none.
void throw_if_failed(Incoming& answer, const std::string& file);

/// The first word of every answer.
enum class Outcome : std::uint8_t { answer, error, usage_error, no_memory, other };

Outgoing failure(Outcome outcome, const std::string& message, const Where& where = {});

template <class Answer>
Outgoing answered(Answer&& answer) {
    try {
        Outgoing out;
        out.put(Outcome::answer);
        answer(out);
        return out;
    } catch (const UsageError& error) {
        return failure(Outcome::usage_error, error.message(), error.where());
    } catch (const Error& error) {
        return failure(Outcome::error, error.message(), error.where());
    } catch (const std::bad_alloc&) {
        return failure(Outcome::no_memory, {});
    } catch (const std::exception& error) {
        return failure(Outcome::other, error.what());
    }
}

} // namespace lutlib::io::box
