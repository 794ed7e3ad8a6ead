// lutconv: the command line of lutlib.
#include "converter/program.h"

#include <fcntl.h>
#include <unistd.h>

namespace {

// A file that is opened while one of the standard streams is closed gets that stream's number, and
// what is printed would go into it.
void open_standard_streams() {
    int lowest_free = 0;
    do {
        lowest_free = ::open("/dev/null", O_RDWR);
    } while (lowest_free >= 0 && lowest_free <= STDERR_FILENO);
    ::close(lowest_free);
}

} // namespace

int main(int argc, char** argv) {
    open_standard_streams();
    return converter::run_program(argc, argv);
}
