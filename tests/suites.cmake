# Run after a test program was linked: writes a CTest test for each of its test suites. The start of
# a process (libraries, a Vulkan device) costs more than most tests, and a suite shares it.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests
    OUTPUT_VARIABLE lines COMMAND_ERROR_IS_FATAL ANY TIMEOUT 60)
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${lines}")
set(out "")
foreach(suite IN LISTS suites)
    string(STRIP "${suite}" suite)
    string(REGEX REPLACE "\\.$" "" suite "${suite}")
    string(APPEND out
        "add_test([==[${NAME}: ${suite}]==] [==[${PROGRAM}]==] "
        "[==[--gtest_filter=${suite}.*]==] --gtest_brief=1)\n"
        "set_tests_properties([==[${NAME}: ${suite}]==] PROPERTIES TIMEOUT 900)\n")
    # The longest first, or a core waits for the other one at the end.
    if(suite MATCHES "Mutations|^Window$|^Survey$|^StiffSurvey$|^ImportTest$")
        string(APPEND out
            "set_tests_properties([==[${NAME}: ${suite}]==] PROPERTIES COST 100)\n")
    endif()
endforeach()
file(WRITE ${OUTPUT} "${out}")
