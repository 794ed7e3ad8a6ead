// Looks that are read beside the window, and what is told of their folder.
#include "preview/editor/look_reader.h"

#include "lutlib/error.h"
#include "preview/look/gpu_lookups.h"
#include "tests/preview/editor/look_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>

namespace preview::editor {
namespace {

using lutlib::ScratchFolder;

class LookReading : public testing::Test {
  protected:
    LookJob job(std::uint64_t ticket) {
        return {ticket, [this, ticket] {
                    const std::lock_guard lock(mutex_);
                    order_.push_back(ticket);
                    return std::make_shared<const LoadedLook>();
                }};
    }
    std::vector<std::uint64_t> order() {
        const std::lock_guard lock(mutex_);
        return order_;
    }
    template <class Holds>
    bool until(Holds holds) {
        const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(30);
        while (!holds() && std::chrono::steady_clock::now() < give_up) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            const LookReader::News news = reader_.take();
            for (const ReadLook& read : news.looks) {
                looks_.push_back(read);
            }
            changed_.insert(changed_.end(), news.changed.begin(), news.changed.end());
            failure_ += news.failure;
        }
        return holds();
    }

    std::mutex mutex_;
    std::vector<std::uint64_t> order_;
    std::vector<ReadLook> looks_;
    std::vector<std::string> changed_;
    std::string failure_;
    std::atomic<int> woken_ = 0;
    LookReader reader_{[this] { ++woken_; }};
};

TEST_F(LookReading, does_each_ticket_once_in_the_order_that_is_asked_for) {
    reader_.ask("", {job(3), job(1), job(2)});
    ASSERT_TRUE(until([&] { return looks_.size() == 3; }));
    reader_.ask("", {job(1), job(4)}); // 1 is not wanted anew
    ASSERT_TRUE(until([&] { return looks_.size() == 4; }));
    EXPECT_EQ(order(), (std::vector<std::uint64_t>{3, 1, 2, 4}));
    EXPECT_EQ(looks_.back().ticket, 4U);
    EXPECT_TRUE(looks_.back().look);
    EXPECT_GE(woken_, 2);
}

TEST_F(LookReading, leaves_what_is_not_wanted_any_more) {
    std::mutex held;
    std::unique_lock hold(held);
    std::atomic<bool> is_at_work = false;
    const LookJob slow{1, [&] {
                           is_at_work = true;
                           const std::lock_guard wait(held);
                           return std::make_shared<const LoadedLook>();
                       }};
    reader_.ask("", {slow, job(2), job(3)});
    ASSERT_TRUE(until([&] { return is_at_work.load(); }));
    reader_.ask("", {job(4)});
    hold.unlock();
    ASSERT_TRUE(until([&] { return looks_.size() == 2; }));
    EXPECT_EQ(order(), std::vector<std::uint64_t>{4});
}

TEST_F(LookReading, says_in_one_line_why_there_is_none_and_that_a_file_is_no_look) {
    reader_.ask(
        "",
        {{1, []() -> std::shared_ptr<const LoadedLook> { throw lutlib::Error("first\nsecond"); }},
         {2, [] { return std::shared_ptr<const LoadedLook>(); }}});
    ASSERT_TRUE(until([&] { return looks_.size() == 2; }));
    EXPECT_FALSE(looks_[0].look);
    EXPECT_EQ(looks_[0].reason, "first second");
    EXPECT_FALSE(looks_[1].look);
    EXPECT_EQ(looks_[1].reason, "");
}

TEST_F(LookReading, makes_scenes_as_well_away_from_who_asks) {
    const auto owner =
        std::make_shared<int>(); // what a scene is does not matter, nor is known here
    const std::shared_ptr<const Shown> shown(owner, reinterpret_cast<const Shown*>(owner.get()));
    std::thread::id by;
    LookJob scene{.ticket = 1, .make = {}, .make_scene = [&] {
                      by = std::this_thread::get_id();
                      return shown;
                  }};
    LookJob failing{.ticket = 2, .make = {}, .make_scene = []() -> std::shared_ptr<const Shown> {
                        throw lutlib::Error("no memory");
                    }};
    reader_.ask("", {scene, failing, job(3)});
    ASSERT_TRUE(until([&] { return looks_.size() == 3; }));
    EXPECT_EQ(looks_[0].scene, shown);
    EXPECT_FALSE(looks_[0].look);
    EXPECT_NE(by, std::this_thread::get_id());
    EXPECT_FALSE(looks_[1].scene);
    EXPECT_EQ(looks_[1].reason, "no memory");
    EXPECT_TRUE(looks_[2].look);
}

TEST_F(LookReading, tells_what_changes_in_the_folder_and_nothing_of_another) {
    const ScratchFolder one, other;
    const auto path_of = [](const ScratchFolder& folder) {
        return std::filesystem::path(folder.file("x")).parent_path().string();
    };
    reader_.ask(path_of(one), {job(1)}); // done once the folder is watched
    ASSERT_TRUE(until([&] { return looks_.size() == 1; }));
    overwrite(one.file("a.cube"), cube_of(1));
    EXPECT_TRUE(until([&] {
        return std::find(changed_.begin(), changed_.end(), one.file("a.cube")) != changed_.end();
    }));
    reader_.ask(path_of(other), {job(2)});
    ASSERT_TRUE(until([&] { return looks_.size() == 2; }));
    changed_.clear();
    overwrite(one.file("b.cube"), cube_of(1));
    overwrite(other.file("notes.txt"), "no look");
    overwrite(other.file("c.cube"), cube_of(1));
    EXPECT_TRUE(until([&] { return !changed_.empty(); }));
    EXPECT_EQ(changed_, std::vector<std::string>{other.file("c.cube")});
    EXPECT_EQ(failure_, "");
}

} // namespace
} // namespace preview::editor
