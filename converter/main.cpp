// lutconv: the command line of lutlib.
#include "converter/program.h"
#include "lutlib/io/terminal.h"

int main(int argc, char** argv) {
    lutlib::io::open_standard_streams();
    return converter::run_program(argc, argv);
}
