// What a reader of strangers' files can do to its program and to the machine: nothing.
#include "lutlib/error.h"
#include "lutlib/io/box/box.h"
#include "lutlib/io/box/boxed_oiio.h"
#include "lutlib/io/box/message.h"
#include "lutlib/io/box/values.h"
#include "tests/lutlib/io/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <sys/prctl.h>
#include <thread>
#include <unistd.h>

namespace lutlib::io::box {
namespace {

using testing::HasSubstr;

constexpr Foreign hostile{"lutlib_hostile", "lutlib_oiio", "HostileIO"};

class Box : public testing::Test {
  protected:
    std::string write(const std::string& deed) {
        const std::string path = scratch_.file("picture");
        std::ofstream(path) << deed;
        return path;
    }
    std::string reason(const std::string& deed) {
        try {
            boxed_.read(write(deed), "picture");
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing";
    }

    ScratchFolder scratch_;
    BoxedOiio boxed_{hostile};
};

TEST_F(Box, hands_over_pictures) {
    const SampleImage image = boxed_.read(write("a picture"), "picture");
    const auto samples = image.samples.as<float>();
    EXPECT_EQ(std::vector(samples.begin(), samples.end()), (std::vector<float>{0, 0.25F, 0.5F, 1}));
}

TEST_F(Box, hands_over_copies_of_pictures_that_their_reader_goes_on_changing) {
    const SampleImage image = boxed_.read(write("keep hold"), "picture");
    const float first = image.samples.as<float>()[0];
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(image.samples.as<float>()[0], first);
}

TEST_F(Box, tells_a_crash_as_an_error_of_the_file_and_reads_the_next_one) {
    for (const char* const deed : {"crash", "abort", "leave"}) {
        EXPECT_THAT(reason(deed), HasSubstr("picture: HostileIO's reader crashes on it")) << deed;
        EXPECT_EQ(boxed_.read(write("a picture"), "picture").width, 1) << deed;
    }
}

TEST_F(Box, ends_a_reader_that_computes_without_end) {
    EXPECT_THAT(reason("run for ever"), HasSubstr("picture: HostileIO computes longer on it"));
}

TEST_F(Box, refuses_memory_beyond_the_limit) {
#if defined(__SANITIZE_ADDRESS__) || defined(__clang__)
    GTEST_SKIP() << "a sanitizer's own memory cannot be limited";
#else
    const std::size_t usual = memory();
    set_memory(std::size_t{256} << 20);
    EXPECT_THAT(reason("take memory"), HasSubstr("picture: reading it takes more memory"));
    set_memory(usual);
#endif
}

TEST_F(Box, has_no_network_and_starts_no_programs) {
    if (::prctl(PR_GET_SECCOMP) < 0) {
        GTEST_SKIP() << "this system has no seccomp";
    }
    ASSERT_TRUE(boxed_.held().seccomp);
    for (const char* const deed : {"call home", "start a program", "become a program"}) {
        EXPECT_THAT(reason(deed), HasSubstr("held")) << deed;
    }
}

TEST_F(Box, reads_and_changes_no_files) {
    if (boxed_.held().landlock == 0) {
        GTEST_SKIP() << "this system has no Landlock";
    }
    std::ofstream("/tmp/lutlib_hostile_victim") << "kept";
    for (const char* const deed : {"read a secret", "write a file", "remove a file"}) {
        EXPECT_THAT(reason(deed), HasSubstr("held")) << deed;
    }
    EXPECT_EQ(::unlink("/tmp/lutlib_hostile_victim"), 0);
}

TEST_F(Box, believes_no_answer) {
    EXPECT_THAT(reason("lie"), HasSubstr("sent a damaged picture"));
}

TEST_F(Box, serves_several_threads) {
    const std::string path = write("a picture");
    std::vector<std::thread> threads;
    std::atomic<int> read{0};
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            for (int k = 0; k < 8; ++k) {
                read += boxed_.read(path, "picture").width;
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(read, 32);
}

TEST(Message, of_any_bytes_gives_values_or_an_error) {
    Lut look;
    look.cube = identity_cube(3);
    look.title = "title";
    Outgoing whole;
    put(whole, look);
    for (std::size_t i = 0; i < whole.bytes().size(); i += 3) {
        std::string cut = whole.bytes().substr(0, i), flipped = whole.bytes();
        flipped[i] = static_cast<char>(flipped[i] ^ 0x55);
        Incoming shorter(cut, {}), changed(flipped, {});
        EXPECT_THROW(take_lut(shorter), Error) << i;
        try {
            validate(take_lut(changed));
        } catch (const Error&) {
        }
    }
    Incoming same(whole.bytes(), {});
    EXPECT_EQ(take_lut(same).cube, look.cube);
}

} // namespace
} // namespace lutlib::io::box
