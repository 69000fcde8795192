// SPDX-License-Identifier: MIT
#include "core/io/footage/film_writer.h"

#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace core {
namespace {

std::size_t filesIn(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(FilmWriter, WritesEveryPictureInItsOrder) {
    const test::TemporaryFolder folder;
    for (const char* name : {"film.avi", "film.mp4"}) {
        FilmWriter film(folder / name, 10);
        for (int i = 0; i < 5; ++i)
            film.add(cv::Mat(51, 64, CV_8UC3, cv::Scalar::all(40 * i + 20))); // an odd height becomes an even one
        film.finish();
        cv::VideoCapture read((folder / name).string());
        ASSERT_TRUE(read.isOpened()) << name;
        int count = 0;
        for (cv::Mat picture; read.read(picture); ++count) {
            EXPECT_EQ(picture.size(), cv::Size(64, 50)) << name;
            EXPECT_NEAR(cv::mean(picture)[1], 40 * count + 20, 8) << name << " " << count;
        }
        EXPECT_EQ(count, 5) << name;
    }
    EXPECT_EQ(filesIn(folder.path()), 2u) << "nothing beside them";
}

TEST(FilmWriter, LeavesNothingUnlessItIsFinished) {
    const test::TemporaryFolder folder;
    {
        FilmWriter film(folder / "film.avi", 10);
        film.add(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(90)));
    }
    EXPECT_EQ(filesIn(folder.path()), 0u);
}

TEST(FilmWriter, SaysWhyThereIsNoFilm) {
    const test::TemporaryFolder folder;
    test::expectError([&] { FilmWriter(folder / "film.gif", 10); }, ErrorCode::Usage, "film.gif", ".mp4");
    test::expectError([&] { FilmWriter(folder / "film.avi", 10).finish(); }, ErrorCode::Usage, "film.avi",
                      "needs pictures");
    test::expectError([&] { FilmWriter(folder / "nowhere/film.avi", 10).add(cv::Mat(48, 64, CV_8UC3)); }, ErrorCode::Io,
                      "film.avi", "cannot be written");
}

} // namespace
} // namespace core
