#include "lutlib/io/box/box.h"

#include "lutlib/io/box/boxed_oiio.h"

#include <atomic>

namespace lutlib::io::box {
namespace {

std::atomic<bool> used{true};
std::atomic<std::size_t> memory_of_each{Allowance{}.memory};

} // namespace

bool is_used() {
    return used;
}

void set_used(bool is_used) {
    used = is_used;
}

void set_memory(std::size_t bytes) {
    memory_of_each = bytes;
}

std::size_t memory() {
    return memory_of_each;
}

std::string holding_text() {
    if (!is_used()) {
        return "OpenImageIO, OpenColorIO and Assimp read files in this process, without a sandbox";
    }
    const Held held = BoxedOiio().held();
    return "OpenImageIO, OpenColorIO and Assimp read files in processes of " +
           std::to_string(memory() >> 20) + " MiB" +
           (held.landlock > 0 ? ", held from files by Landlock " + std::to_string(held.landlock)
                              : ", not held from files (this system has no Landlock)") +
           (held.seccomp ? ", from network and programs by seccomp"
                         : ", not held from network and programs (this system has no seccomp)");
}

} // namespace lutlib::io::box
