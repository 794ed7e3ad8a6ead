#include "lutlib/io/box/box.h"

#include <atomic>

namespace lutlib::io::box {
namespace {

std::atomic<bool> used{true};

} // namespace

bool is_used() {
    return used;
}

void set_used(bool is_used) {
    used = is_used;
}

} // namespace lutlib::io::box
