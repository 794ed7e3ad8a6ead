#include "converter/quiet.h"

namespace converter {
namespace {

bool quiet_run = false;

} // namespace

void set_quiet(bool quiet) {
    quiet_run = quiet;
}

bool is_quiet() {
    return quiet_run;
}

} // namespace converter
