// SPDX-License-Identifier: MIT
#include "core/io/dataset/picture_setup.h"

#include <fstream>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/io/dataset/frames.h"
#include "core/io/dataset/new_sequence.h"
#include "core/io/footage/grey_levels.h"
#include "core/io/footage/image_file.h"
#include "tests/support/camera_ring.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using enum core::ErrorCode;

core::Camera cameraOf(core::ImageSize size) {
    core::Camera camera = test::cameraRing(2).front();
    camera.size = size;
    return camera;
}

/// An EXIF block that holds the orientation only.
std::string exif(int orientation, bool isLittle) {
    const auto two = [&](int value) {
        return isLittle ? std::string{char(value), char(value >> 8)} : std::string{char(value >> 8), char(value)};
    };
    const auto four = [&](int value) { return isLittle ? two(value) + two(0) : two(0) + two(value); };
    return (isLittle ? "II" : "MM") + two(42) + four(8) + two(1) + two(0x0112) + two(3) + four(1) + two(orientation) +
           two(0) + four(0);
}

/// A JPEG of that picture with an orientation tag after the first marker.
std::string jpegWithTag(const cv::Mat& picture, int orientation, bool isLittle = false) {
    std::vector<uchar> bytes;
    cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 95});
    std::string jpeg(bytes.begin(), bytes.end());
    const std::string block = std::string("Exif\0\0", 6) + exif(orientation, isLittle);
    return jpeg.insert(2, std::string("\xFF\xE1") + char(0) + char(block.size() + 2) + block);
}

TEST(Orientation, IsReadFromJpegTiffPngAndWebp) {
    const cv::Mat picture(8, 8, CV_8UC3, cv::Scalar::all(9));
    for (const auto& [tag, degrees] : {std::pair(1, 0), std::pair(3, 180), std::pair(6, 90), std::pair(8, 270)}) {
        for (const bool isLittle : {false, true}) {
            EXPECT_EQ(core::orientationOf(jpegWithTag(picture, tag, isLittle)).rotateDegrees, degrees);
            EXPECT_EQ(core::orientationOf(exif(tag, isLittle)).rotateDegrees, degrees) << "TIFF";
            const std::string block = exif(tag, isLittle), size{0, 0, 0, char(block.size())},
                              reversed(size.rbegin(), size.rend());
            EXPECT_EQ(core::orientationOf("\x89PNG\r\n\x1A\n" + size + "eXIf" + block + "sum!").rotateDegrees, degrees);
            EXPECT_EQ(core::orientationOf("RIFF????WEBPEXIF" + reversed + block).rotateDegrees, degrees);
        }
    }
    EXPECT_TRUE(core::orientationOf(jpegWithTag(picture, 5)).isMirrored);
    // What OpenCV makes of the tag is the oracle of its sense.
    cv::Mat marked(6, 10, CV_8UC3, cv::Scalar::all(0));
    marked(cv::Rect(0, 0, 3, 3)).setTo(cv::Scalar::all(255));
    for (const int tag : {3, 6, 8}) {
        const std::string jpeg = jpegWithTag(marked, tag);
        const cv::Mat upright = cv::imdecode(std::vector<uchar>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
        const int degrees = core::orientationOf(jpeg).rotateDegrees;
        cv::Mat turned;
        cv::rotate(marked, turned, degrees / 90 - 1);
        ASSERT_EQ(turned.size(), upright.size());
        EXPECT_LT(cv::norm(turned, upright, cv::NORM_L1) / static_cast<double>(turned.total()), 40) << tag;
    }
}

TEST(Orientation, OfDamagedFilesLeavesThePictureUnturned) {
    const std::string jpeg = jpegWithTag(cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(9)), 6);
    for (std::size_t length = 0; length < 60; ++length)
        core::orientationOf(std::string_view(jpeg).substr(0, length)); // must not read beyond the end
    EXPECT_EQ(core::orientationOf("").rotateDegrees, 0);
    EXPECT_EQ(core::orientationOf(exif(99, true)).rotateDegrees, 0);
    std::string far = exif(6, true);
    far[4] = '\xFF';
    far[7] = '\x7F';
    EXPECT_EQ(core::orientationOf(far).rotateDegrees, 0);
}

TEST(PictureSetup, FollowsTheTagIfTheResultFits) {
    const core::Camera portrait = cameraOf({480, 640});
    const auto turn = [&](core::ImageSize recorded, int tag, std::optional<int> asked = {}) {
        core::PictureOptions options;
        options.rotateDegrees = asked;
        return core::setUpPictures(portrait, "a.mp4", recorded, {tag, false}, options);
    };
    EXPECT_EQ(turn({640, 480}, 90).rotateDegrees, 90);
    EXPECT_EQ(turn({640, 480}, 270).rotateDegrees, 270);
    EXPECT_EQ(turn({480, 640}, 180).rotateDegrees, 180);
    const auto noteOf = [&](core::ImageSize recorded, int tag) {
        return core::footageNoteText(turn(recorded, tag).notes.at(0));
    };
    EXPECT_NE(noteOf({480, 640}, 180).find("--rotate cam0=0 leaves it as recorded"), std::string::npos);
    EXPECT_EQ(turn({480, 640}, 90).rotateDegrees, 0) << "calibrated with the recorded pictures";
    EXPECT_NE(noteOf({480, 640}, 90).find("--rotate cam0=90 follows the tag"), std::string::npos);
    EXPECT_EQ(turn({480, 640}, 180, 0).rotateDegrees, 0);
    EXPECT_EQ(turn({640, 480}, 0, 270).rotateDegrees, 270);
    EXPECT_TRUE(turn({480, 640}, 0).notes.empty());
    test::expectError([&] { turn({640, 480}, 0); }, BadInput, "a.mp4", "--rotate cam0=90 (or 270)");
    test::expectError(
        [&] {
            turn({640, 480}, 90, 180);
        },
        BadInput, "a.mp4", "640 x 480, but cam0 is calibrated for 480 x 640");
}

/// The pixel that a point has in a picture scaled by `scale` of the window at `leftTop`: pixel areas, not centres, are
/// scaled.
Eigen::Vector2d moved(const Eigen::Vector2d& px, const Eigen::Vector2d& leftTop, double scale) {
    return ((px - leftTop).array() + 0.5) * scale - 0.5;
}

TEST(PictureSetup, ScaleAndCropMoveEveryProjectedPoint) {
    const core::Camera camera = cameraOf({1080, 1920});
    const Eigen::Vector3d point(40, -30, 20);
    const Eigen::Vector2d px = *core::project(camera, point);
    core::PictureOptions half, window, both;
    half.scale = 0.5;
    window.cropPx = Eigen::Vector2d(100, 200);
    both.scale = 0.25;
    both.cropPx = Eigen::Vector2d(80, 40);
    const auto found = [&](core::ImageSize size, const core::PictureOptions& options) {
        const core::PictureSetup setup = core::setUpPictures(camera, "a", size, {}, options);
        EXPECT_EQ(setup.camera.size, size);
        EXPECT_EQ(setup.camera.distortion, camera.distortion);
        return *core::project(setup.camera, point);
    };
    EXPECT_LT((found({540, 960}, half) - moved(px, {0, 0}, 0.5)).norm(), 1e-9);
    EXPECT_LT((found({800, 600}, window) - moved(px, {100, 200}, 1)).norm(), 1e-9);
    EXPECT_LT((found({250, 470}, both) - moved(px, {80, 40}, 0.25)).norm(), 1e-9);
    const core::Camera halved = core::setUpPictures(camera, "a", {540, 960}, {}, half).camera;
    EXPECT_DOUBLE_EQ(halved.intrinsics(0, 2), (camera.intrinsics(0, 2) + 0.5) * 0.5 - 0.5);
    EXPECT_DOUBLE_EQ(halved.intrinsics(0, 0), camera.intrinsics(0, 0) * 0.5);
    test::expectError([&] { found({541, 700}, half); }, BadInput, "a", "does not fit with --scale cam0=0.5");
    test::expectError([&] { found({1000, 1800}, window); }, BadInput, "a", "does not fit with --crop cam0=100,200");
}

TEST(PictureSetup, RefusalNamesTheOptionThatWouldMakeItFit) {
    const auto refused = [](core::ImageSize calibrated, core::ImageSize recorded) {
        try {
            core::setUpPictures(cameraOf(calibrated), "a", recorded, {}, {});
        } catch (const core::Error& error) {
            return error.detail();
        }
        return std::string("taken");
    };
    EXPECT_NE(refused({1080, 1920}, {540, 960}).find("use --scale cam0=0.5"), std::string::npos);
    EXPECT_NE(refused({1081, 1921}, {540, 960}).find("use --scale cam0=0.5"), std::string::npos);
    EXPECT_NE(refused({640, 480}, {1280, 960}).find("use --scale cam0=2"), std::string::npos);
    EXPECT_NE(refused({1920, 1080}, {1280, 720}).find("use --scale cam0=0.6666666667"), std::string::npos);
    EXPECT_NE(refused({1080, 1920}, {800, 600}).find("use --crop cam0=x,y"), std::string::npos);
    EXPECT_NE(refused({1080, 1920}, {960, 540}).find("--rotate cam0=90 (or 270) with --scale cam0=0.5"),
              std::string::npos);
    EXPECT_EQ(refused({640, 480}, {700, 300}), "700 x 300, but cam0 is calibrated for 640 x 480");
    // The value that is named works.
    core::PictureOptions options;
    options.scale = 0.6666666667;
    EXPECT_EQ(core::setUpPictures(cameraOf({1920, 1080}), "a", {1280, 720}, {}, options).camera.size,
              (core::ImageSize{1280, 720}));
}

/// Every level of a 12-bit camera once, in a picture of 16 bits.
cv::Mat ramp12() {
    cv::Mat picture(64, 64, CV_16U);
    for (int i = 0; i < 4096; ++i)
        picture.at<std::uint16_t>(i / 64, i % 64) = static_cast<std::uint16_t>(i);
    return picture;
}

/// The output level of every pixel, in the ramp's order; they must not fall, and use all 256 levels.
void expectWholeRange(const cv::Mat& shown) {
    std::set<int> used;
    int last = 0;
    for (int i = 0; i < 4096; ++i) {
        const int level = shown.at<cv::Vec3b>(i / 64, i % 64)[0];
        EXPECT_GE(level, last) << i;
        last = level;
        used.insert(level);
    }
    EXPECT_EQ(used.size(), 256u);
}

TEST(GreyLevels, OfTwelveBitsInSixteenUseAllOfTheScreen) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a_0.png", "a_1.tif"}) {
        cv::imwrite(folder / name, ramp12());
        expectWholeRange(core::readImage(folder / name));
        const auto measured = core::measureFileLevels({folder / name});
        ASSERT_TRUE(measured);
        EXPECT_NEAR(measured->black, 4, 1);
        EXPECT_NEAR(measured->white, 4091, 1);
        expectWholeRange(core::readImage(folder / name, *measured));
    }
    EXPECT_EQ(core::levelsByDepth(ramp12()), (core::GreyLevels{0, 4095}));
    EXPECT_EQ(core::levelsByDepth(ramp12() * 16), (core::GreyLevels{0, 65535}));
    core::writePng(folder / "eight.png", cv::Mat(4, 4, CV_8U, cv::Scalar(7)));
    EXPECT_FALSE(core::measureFileLevels({folder / "eight.png"}));
    // A picture of nearly one level is not stretched to noise.
    const auto flat = core::measureLevels({cv::Mat(8, 8, CV_16U, cv::Scalar(1000))});
    EXPECT_EQ(flat->white - flat->black, 255);
}

/// A camera's folder of pictures becomes a sequence.
core::NewSequence madeOf(const core::Camera& camera, const fs::path& images, const fs::path& dataset,
                         const core::PictureOptions& options = {}) {
    return core::makeSequence("s", {camera}, {{camera.name, images, 0, options}}, dataset);
}

TEST(GreyLevels, AreKeptByTheDatasetAndGuessedForOldOnes) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "shots");
    cv::imwrite(folder / "shots/0.png", ramp12());
    cv::imwrite(folder / "shots/1.png", cv::Mat(ramp12() / 4));
    core::Dataset dataset;
    dataset.folder = folder / "set";
    dataset.cameras = {cameraOf({64, 64})};
    const core::NewSequence made = madeOf(dataset.cameras[0], folder / "shots", dataset.folder);
    ASSERT_EQ(made.notes.size(), 1u);
    EXPECT_NE(core::footageNoteText(made.notes[0]).find("--levels cam0=BLACK,WHITE"), std::string::npos);
    ASSERT_TRUE(made.sequence.views[0].levels);
    const double black = made.sequence.views[0].levels->black, white = made.sequence.views[0].levels->white;
    EXPECT_EQ(made.notes[0].numbers, (std::vector<double>{black, white}));
    dataset.sequences = {made.sequence};
    core::writeDataset(dataset, {}, dataset.folder);
    dataset = core::readDataset(dataset.folder);
    ASSERT_TRUE(dataset.sequences[0].views[0].levels);
    const auto levelAt = [&](int frame, int pixel) {
        const core::FrameSource frames(dataset, dataset.sequences[0], {});
        return int(frames.read(0, frame).at<cv::Vec3b>(pixel / 64, pixel % 64)[1]);
    };
    EXPECT_NEAR(levelAt(0, 2048), 128, 2);
    EXPECT_NEAR(levelAt(1, 2048), 32, 2);
    dataset.sequences[0].views[0].levels.reset(); // as written before there were levels
    EXPECT_EQ(levelAt(1, 2048), 32) << "by the bit depth of the first picture, not of this one";
    EXPECT_EQ(levelAt(0, 4095), 255);
    dataset.sequences[0].views[0].levels = core::GreyLevels{1000, 2000};
    EXPECT_EQ(levelAt(0, 1000), 0);
    EXPECT_NEAR(levelAt(0, 1500), 127.5, 0.6);
    EXPECT_EQ(levelAt(0, 3000), 255);
}

TEST(GreyLevels, OfMasksDoNotMatter) {
    const test::TemporaryFolder folder;
    cv::Mat mask(4, 6, CV_16U, cv::Scalar(0));
    mask.at<std::uint16_t>(1, 2) = 1;
    mask.at<std::uint16_t>(3, 5) = 65535;
    cv::imwrite(folder / "m.png", mask);
    EXPECT_EQ(cv::countNonZero(core::readMask(folder / "m.png")), 2);
    cv::Mat colours(4, 6, CV_8UC3, cv::Scalar::all(0));
    colours.at<cv::Vec3b>(1, 1) = {1, 0, 0};
    colours.at<cv::Vec3b>(2, 2) = {0, 0, 200};
    core::writePng(folder / "c.png", colours);
    EXPECT_EQ(cv::countNonZero(core::readMask(folder / "c.png")), 2);
    cv::Mat opaque(4, 6, CV_8UC4, cv::Scalar(0, 0, 0, 255));
    opaque.at<cv::Vec4b>(0, 0) = {0, 9, 0, 255};
    core::writePng(folder / "o.png", opaque);
    EXPECT_EQ(cv::countNonZero(core::readMask(folder / "o.png")), 1);
}

TEST(TurnedPictures, AreReadAsTheDatasetSays) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "shots");
    cv::Mat picture(16, 32, CV_8UC3, cv::Scalar::all(0)); // on its side
    picture(cv::Rect(0, 0, 8, 8)).setTo(cv::Scalar::all(255));
    std::ofstream(folder / "shots/0.jpg", std::ios::binary) << jpegWithTag(picture, 6);
    core::Dataset dataset;
    dataset.folder = folder / "set";
    dataset.cameras = {cameraOf({16, 32})};
    const auto cornerOf = [&](const core::PictureOptions& options) {
        const core::NewSequence made = madeOf(dataset.cameras[0], folder / "shots", dataset.folder, options);
        EXPECT_EQ(made.notes.size(), 1u);
        dataset.sequences = {made.sequence};
        fs::remove_all(dataset.folder);
        core::writeDataset(dataset, {}, dataset.folder);
        dataset = core::readDataset(dataset.folder);
        const cv::Mat shown = core::FrameSource(dataset, dataset.sequences[0], {}).read(0, 0);
        EXPECT_EQ(shown.size(), cv::Size(16, 32));
        const auto isBright = [&](int x, int y) { return shown.at<cv::Vec3b>(y, x)[0] > 128; };
        return std::string(isBright(3, 3) ? "top left" : "") + (isBright(12, 3) ? "top right" : "") +
               (isBright(3, 28) ? "bottom left" : "") + (isBright(12, 28) ? "bottom right" : "");
    };
    EXPECT_EQ(cornerOf({}), "top right");
    EXPECT_EQ(dataset.sequences[0].views[0].rotateDegrees, 90);
    core::PictureOptions other;
    other.rotateDegrees = 270;
    EXPECT_EQ(cornerOf(other), "bottom left");
    dataset.cameras[0].size = {32, 16};
    const core::NewSequence made = madeOf(dataset.cameras[0], folder / "shots", dataset.folder);
    EXPECT_EQ(made.sequence.views[0].rotateDegrees, 0) << "only the recorded size fits";
    EXPECT_EQ(made.notes.at(0), (core::FootageNote{core::FootageNoteKind::TagNotFollowed, {"cam0"}, {}, {90, 0}}));
}

} // namespace
