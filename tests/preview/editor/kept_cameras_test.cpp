// Cameras that were kept outlive the window, by what they look at, and a broken file loses none.
#include "preview/editor/kept_cameras.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/scene/camera_settings.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace preview::editor {
namespace {

namespace fs = std::filesystem;

/// Another number in every member.
Orbit odd_orbit() {
    Orbit out;
    out.target = {0.1F, -2.7F, 1e5F};
    out.near_plane = 0.013F;
    float share = 0.1F;
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        row.of(out) = static_cast<float>(row.min + (row.max - row.min) * double{share});
        share += 0.11F;
    }
    return out;
}

void expect_same(const Orbit& a, const Orbit& b) {
    EXPECT_EQ(a.target, b.target);
    EXPECT_EQ(a.near_plane, b.near_plane);
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        EXPECT_EQ(row.value(a), row.value(b)) << row.flag;
    }
}

std::vector<std::string> names_of(const std::vector<NamedCamera>& cameras) {
    std::vector<std::string> out;
    for (const NamedCamera& camera : cameras) {
        out.push_back(camera.name);
    }
    return out;
}

std::string contents(const std::string& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

using Names = std::vector<std::string>;

class KeptCamerasTest : public testing::Test {
  protected:
    lutlib::ScratchFolder scratch_;
    std::string path_ = scratch_.file("cameras.json");
};

TEST_F(KeptCamerasTest, come_back_bit_by_bit_in_their_order) {
    KeptCameras kept(path_);
    EXPECT_TRUE(kept.of("sample").empty());
    EXPECT_FALSE(fs::exists(path_)) << "nothing was kept";
    kept.keep("sample", {"", odd_orbit()});
    kept.keep("sample", {"door", {}});
    kept.keep("sample", {"", {}});
    const auto again = KeptCameras(path_).of("sample");
    EXPECT_EQ(names_of(again), (Names{"kept 1", "door", "kept 2"}));
    expect_same(again.at(0).orbit, odd_orbit());
    expect_same(again.at(1).orbit, {});
}

TEST_F(KeptCamerasTest, belong_to_a_scene_or_to_a_model_from_whatever_folder) {
    KeptCameras kept(path_);
    kept.keep("sample", {"a", {}});
    kept.keep("models/chair.glb", {"b", {}});
    kept.keep("models/\xff.glb", {"c", {}}); // no UTF-8
    EXPECT_EQ(names_of(kept.of("sample")), Names{"a"});
    EXPECT_EQ(names_of(kept.of("./models/../models/chair.glb")), Names{"b"});
    EXPECT_EQ(names_of(kept.of((fs::current_path() / "models/chair.glb").string())), Names{"b"});
    EXPECT_EQ(names_of(kept.of("models/\xff.glb")), Names{"c"});
    EXPECT_TRUE(kept.of("chair.glb").empty());
}

TEST_F(KeptCamerasTest, of_two_windows_are_all_there_and_one_name_has_one_camera) {
    KeptCameras one(path_), other(path_);
    one.keep("plain", {"", {}});
    other.keep("plain", {"", odd_orbit()});
    EXPECT_EQ(names_of(one.of("plain")), (Names{"kept 1", "kept 2"}));
    one.keep("plain", {"kept 1", odd_orbit()});
    expect_same(other.of("plain").at(0).orbit, odd_orbit());
    other.forget("plain", "kept 1");
    other.forget("plain", "nothing");
    EXPECT_EQ(names_of(one.of("plain")), Names{"kept 2"});
    one.keep("plain", {"", {}});
    EXPECT_EQ(names_of(one.of("plain")), (Names{"kept 2", "kept 1"})) << "a free name";
}

TEST_F(KeptCamerasTest, say_once_that_their_file_is_broken_and_put_it_aside) {
    constexpr const char* texts[] = {"",
                                     "[",
                                     "{}",
                                     R"({"cameras": 3})",
                                     R"({"cameras": {"sample": [{"name": 3}]}})",
                                     R"({"cameras": {"sample": [{"name": "a", "target": [1]}]}})"};
    for (const char* const text : texts) {
        lutlib::io::write_file(path_, text);
        KeptCameras kept(path_);
        try {
            kept.of("sample");
            ADD_FAILURE() << text;
        } catch (const lutlib::Error& error) {
            EXPECT_EQ(std::string(error.what()).find(path_ + ": mend or delete it"), 0U)
                << error.what();
        }
        EXPECT_TRUE(kept.of("sample").empty()) << "once is enough";
        EXPECT_EQ(contents(path_), text) << "somebody may mend it";
        kept.keep("sample", {"a", {}});
        EXPECT_EQ(names_of(KeptCameras(path_).of("sample")), Names{"a"});
    }
    EXPECT_EQ(contents(path_ + ".broken"), texts[0]);
    for (std::size_t i = 1; i < std::size(texts); ++i) {
        EXPECT_EQ(contents(path_ + ".broken" + std::to_string(i + 1)), texts[i]);
    }
}

TEST_F(KeptCamerasTest, are_outdated_once_another_window_has_written_them) {
    KeptCameras kept(path_);
    EXPECT_TRUE(kept.of("sample").empty());
    EXPECT_FALSE(kept.is_outdated()) << "there is no file";
    KeptCameras other(path_);
    other.keep("sample", {"a", {}});
    EXPECT_FALSE(other.is_outdated()) << "by itself";
    EXPECT_TRUE(kept.is_outdated());
    EXPECT_EQ(names_of(kept.of("sample")), Names{"a"});
    EXPECT_FALSE(kept.is_outdated());
    // Of the same size, at another time.
    lutlib::io::write_file(path_, contents(path_));
    std::filesystem::last_write_time(path_, std::filesystem::last_write_time(path_) +
                                                std::chrono::seconds(5));
    EXPECT_TRUE(kept.is_outdated());
    kept.of("sample");
    std::filesystem::remove(path_);
    EXPECT_TRUE(kept.is_outdated());
    EXPECT_TRUE(kept.of("sample").empty());
    lutlib::io::write_file(path_, "[");
    EXPECT_TRUE(kept.is_outdated());
    EXPECT_THROW(kept.of("sample"), lutlib::Error);
    EXPECT_FALSE(kept.is_outdated()) << "what is broken is read once";
    EXPECT_FALSE(KeptCameras("").is_outdated());
}

TEST_F(KeptCamerasTest, that_others_damage_meanwhile_are_kept_again_and_that_is_told) {
    KeptCameras kept(path_);
    kept.keep("sample", {"a", {}});
    lutlib::io::write_file(path_, "[");
    try {
        kept.keep("sample", {"b", {}});
        ADD_FAILURE() << "nothing was said";
    } catch (const lutlib::Error& error) {
        EXPECT_NE(std::string(error.what()).find(path_ + ".broken"), std::string::npos)
            << error.what();
    }
    EXPECT_EQ(contents(path_ + ".broken"), "[");
    EXPECT_EQ(names_of(KeptCameras(path_).of("sample")), (Names{"a", "b"}));
    kept.keep("sample", {"c", {}}); // says nothing more
    EXPECT_EQ(names_of(kept.of("sample")), (Names{"a", "b", "c"}));
}

TEST_F(KeptCamerasTest, have_numbers_within_their_ranges) {
    const auto read = cameras_from(R"({"cameras": {"sample": [{"name": "a",
        "target": [1e30, -1e30, 0], "near": -1, "distance": -5, "fov": 1e9, "azimuth": 720}]}})");
    const Orbit& orbit = read.at("sample").at(0).orbit;
    EXPECT_EQ(orbit.target.x, 1e6F);
    EXPECT_EQ(orbit.target.y, -1e6F);
    EXPECT_GT(orbit.near_plane, 0);
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        EXPECT_GE(row.value(orbit), static_cast<float>(row.min)) << row.flag;
        EXPECT_LE(row.value(orbit), static_cast<float>(row.max)) << row.flag;
    }
}

TEST_F(KeptCamerasTest, stay_in_the_window_where_nothing_can_be_written) {
    KeptCameras nowhere("");
    nowhere.keep("sample", {"", {}});
    EXPECT_EQ(names_of(nowhere.of("sample")), Names{"kept 1"});
    KeptCameras kept(scratch_.file("absent/cameras.json"));
    EXPECT_THROW(kept.keep("sample", {"", {}}), lutlib::Error);
    EXPECT_NO_THROW(kept.keep("sample", {"", {}})) << "it was said";
    EXPECT_EQ(names_of(kept.of("sample")), (Names{"kept 1", "kept 2"}));
}

TEST_F(KeptCamerasTest, of_one_scene_are_not_without_end) {
    KeptCameras kept("");
    for (std::size_t i = 0; i < KeptCameras::most_of_one; ++i) {
        kept.keep("sample", {"", {}});
    }
    EXPECT_THROW(kept.keep("sample", {"", {}}), lutlib::Error);
    EXPECT_NO_THROW(kept.keep("sample", {"kept 7", odd_orbit()}));
    EXPECT_EQ(kept.of("sample").size(), KeptCameras::most_of_one);
}

} // namespace
} // namespace preview::editor
