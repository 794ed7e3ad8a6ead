// lutconv: the command line of lutlib.
#include "converter/program.h"

int main(int argc, char** argv) {
    return converter::run_program(argc, argv);
}
