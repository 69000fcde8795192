// SPDX-License-Identifier: MIT
#include "core/io/detector/detector_files.h"

#include <cstdlib>

#include <gtest/gtest.h>
#include <zlib.h>

#include "core/io/detector/detection_journal.h"
#include "core/io/detector/tflite_file.h"
#include "tests/support/detection/network_builder.h"
#include "tests/support/detection/tflite_writer.h"
#include "tests/support/expect_error.h"
#include "tests/support/temporary_folder.h"

namespace {

using core::ErrorCode;

void expectSame(const core::NetworkGraph& read, const core::NetworkGraph& written) {
    ASSERT_GE(read.tensors.size(), written.tensors.size());
    for (std::size_t i = 0; i < written.tensors.size(); ++i) {
        EXPECT_EQ(read.tensors[i].shape, written.tensors[i].shape);
        EXPECT_EQ(read.tensors[i].values, written.tensors[i].values);
        EXPECT_EQ(read.tensors[i].integers, written.tensors[i].integers);
    }
    ASSERT_EQ(read.operators.size(), written.operators.size());
    for (std::size_t i = 0; i < written.operators.size(); ++i) {
        const core::NetworkOperator &a = read.operators[i], &b = written.operators[i];
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.inputs, b.inputs);
        EXPECT_EQ(a.outputs, b.outputs);
        EXPECT_EQ(a.activation, b.activation);
        EXPECT_EQ(a.samePadding, b.samePadding);
        EXPECT_EQ(a.strideX, b.strideX);
        EXPECT_EQ(a.filterHeight, b.filterHeight);
        EXPECT_EQ(a.axis, b.axis);
    }
    EXPECT_EQ(read.outputs, written.outputs);
}

TEST(TfliteFile, IsReadAsItWasWritten) {
    const core::NetworkGraph graph = test::networkOfEverything();
    expectSame(core::parseTflite(test::tfliteBytes(graph), "a.tflite"), graph);
    expectSame(core::parseTflite(test::tfliteBytes(graph, true), "a.tflite"), graph); // weights of 16 bits
}

TEST(TfliteFile, RefusesWhatIsNotOne) {
    test::expectError([] { core::parseTflite("", "a.tflite"); }, ErrorCode::BadInput, "a.tflite", "not a TensorFlow");
    test::expectError([] { core::parseTflite("{\"json\": true}", "a.tflite"); }, ErrorCode::BadInput, "a.tflite",
                      "not a TensorFlow");
}

/// A file of these tensors, which have no other operators than to widen numbers of 16 bits.
std::string tensorsOnly(const std::vector<test::FlatNode>& tensors, const std::vector<test::FlatNode>& buffers,
                        const std::vector<test::FlatNode>& operators = {}) {
    const test::FlatNode code{{{0, test::flatByte(6)}, {3, test::flatInt(6)}}}; // DEQUANTIZE
    const test::FlatNode subgraph{{{0, test::flatTables(tensors)}, {3, test::flatTables(operators)}}};
    return test::FlatWriter().write({{{0, test::flatInt(3)},
                                      {1, test::flatTables({code})},
                                      {2, test::flatTables({subgraph})},
                                      {4, test::flatTables(buffers)}}},
                                    "TFL3");
}

TEST(TfliteFile, TakesNoMemoryForWhatItSharesOrClaims) {
    const auto refused = [](const std::string& bytes, const std::string& word) {
        test::expectError([&] { core::parseTflite(bytes, "a.tflite"); }, ErrorCode::BadInput, "a.tflite", word);
    };
    // Each of the tensors would hold a copy of the buffer, 8 GB in all.
    constexpr int kValues = 1 << 20;
    const test::FlatNode buffer{{{0, test::flatBytes(std::string(2 * kValues, '\1'))}}};
    const test::FlatNode half{{{0, test::flatInts({kValues})}, {1, test::flatByte(1)}, {2, test::flatInt(1)}}};
    const test::FlatNode empty{{{0, test::flatInts({kValues})}, {2, test::flatInt(0)}}};
    refused(tensorsOnly(std::vector<test::FlatNode>(2000, half), {{}, buffer}), "constants are too large");
    std::vector<test::FlatNode> tensors(2000, empty), widenings;
    tensors[0] = half;
    for (int i = 1; i < 2000; ++i)
        widenings.push_back({{{1, test::flatInts({0})}, {2, test::flatInts({i})}}});
    refused(tensorsOnly(tensors, {{}, buffer}, widenings), "constants are too large");
    refused(tensorsOnly(std::vector<test::FlatNode>(10'001), {{}}), "there are 10001");
    core::NetworkGraph graph = test::networkOfEverything();
    graph.tensors[0].name = std::string(500'000, 'n');
    EXPECT_EQ(core::parseTflite(test::tfliteBytes(graph), "a.tflite").tensors[0].name, std::string(200, 'n'));
}

TEST(TfliteFile, NeverCrashesWhateverIsCutOffOrChanged) {
    const std::string bytes = test::tfliteBytes(test::networkOfEverything(), true);
    int refused = 0;
    const auto tryIt = [&](const std::string& damaged) {
        try {
            core::parseTflite(damaged, "a.tflite");
        } catch (const core::Error& error) {
            EXPECT_EQ(error.file(), "a.tflite");
            ++refused;
        }
    };
    for (std::size_t length = 0; length < bytes.size(); length += 7)
        tryIt(bytes.substr(0, length));
    EXPECT_GT(refused, static_cast<int>(bytes.size() / 7 - 5));
    test::RandomValues random("damaged files");
    for (int i = 0; i < 4000; ++i) {
        std::string damaged = bytes;
        for (int k = 0; k <= i % 4; ++k)
            damaged[static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())))] =
                static_cast<char>(k % 2 == 0 ? random.below(256) : 255);
        tryIt(damaged);
    }
}

/// Networks of the right inputs and outputs, with few weights.
core::NetworkGraph smallPalmNetwork() {
    using core::Activation;
    using Kind = core::NetworkOperatorKind;
    test::NetworkBuilder b("palms", {1, 192, 192, 3});
    const int coarse = b.pool(b.input(), 8, 8, false), coarser = b.pool(b.input(), 16, 16, false);
    const auto head = [&](int perAnchor) {
        const int fine =
            b.reshape(b.convolution(coarse, 2 * perAnchor, 1, 1, true, Activation::None), {1, 1152, perAnchor});
        const int rest =
            b.reshape(b.convolution(coarser, 6 * perAnchor, 1, 1, true, Activation::None), {1, 864, perAnchor});
        return b.simple(Kind::Concatenation, {fine, rest}, {1, 2016, perAnchor}, 1);
    };
    b.graph.outputs = {head(18), head(1)};
    return b.graph;
}

core::NetworkGraph smallLandmarkNetwork() {
    using Kind = core::NetworkOperatorKind;
    test::NetworkBuilder b("landmarks", {1, 224, 224, 3});
    const int features = b.mean(b.input());
    const int landmarks = b.connected(features, 63);
    const int presence = b.simple(Kind::Logistic, {b.connected(features, 1)}, {1, 1});
    const int side = b.simple(Kind::Logistic, {b.connected(features, 1)}, {1, 1});
    b.graph.outputs = {landmarks, presence, side, b.connected(features, 63)};
    return b.graph;
}

std::map<std::string, std::string> packageFiles() {
    const std::string palms = test::tfliteBytes(smallPalmNetwork());
    return {
        {"package.json", R"({"name": "@mediapipe/hands", "version": "1.2.3"})"},
        {"hand_landmark_full.tflite", test::tfliteBytes(smallLandmarkNetwork())},
        {"hands_solution_packed_assets.data", "Left\nRight\n" + palms + "rest"},
        {"hands_solution_packed_assets_loader.js",
         R"(function loadPackage(metadata) {} loadPackage({"files": [{"filename": "/m/handedness.txt", "start": 0, )"
         R"("end": 11}, {"filename": "/m/palm_detection_full.tflite", "start": 11, "end": )" +
             std::to_string(11 + palms.size()) + "}], \"remote_package_size\": 1});\n"},
        {"README.md", "a file that is not needed"}};
}

void writeFolder(const std::filesystem::path& folder, const std::map<std::string, std::string>& files) {
    std::filesystem::create_directories(folder);
    for (const auto& [name, content] : files)
        test::writeText(folder / name, content);
}

std::string tarOf(const std::map<std::string, std::string>& files) {
    std::string tar;
    for (const auto& [name, content] : files) {
        std::string header(512, '\0');
        header.replace(0, name.size() + 8, "package/" + name);
        char size[12];
        std::snprintf(size, sizeof size, "%011o", static_cast<unsigned>(content.size()));
        header.replace(124, 11, size, 11);
        header[156] = '0';
        header.replace(257, 5, "ustar");
        tar += header + content + std::string((512 - content.size() % 512) % 512, '\0');
    }
    return tar + std::string(1024, '\0');
}

std::string gzipOf(const std::string& content) {
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, content.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

TEST(Detector, IsInstalledFromFolderAndArchive) {
    const test::TemporaryFolder folder;
    writeFolder(folder / "package", packageFiles());
    test::writeText(folder / "hands.tgz", gzipOf(tarOf(packageFiles())));
    EXPECT_FALSE(core::isDetectorInstalled(folder / "a/detector"));
    EXPECT_EQ(core::installDetector(folder / "package", folder / "a/detector"), "@mediapipe/hands 1.2.3");
    EXPECT_EQ(core::installDetector(folder / "hands.tgz", folder / "b"), "@mediapipe/hands 1.2.3");
    EXPECT_EQ(core::installDetector(folder / "hands.tgz", folder / "b"), "@mediapipe/hands 1.2.3") << "again";
    for (const std::string installed : {"a/detector", "b"}) {
        const core::DetectorNetworks networks = core::readDetector(folder / installed);
        expectSame(networks.palms, smallPalmNetwork());
        expectSame(networks.landmarks, smallLandmarkNetwork());
    }
}

TEST(Detector, SaysHowToGetItWhereItIsMissing) {
    const test::TemporaryFolder folder;
    test::expectError([&] { core::readDetector(folder / "none"); }, ErrorCode::NotFound, "none",
                      "npm pack @mediapipe/hands");
}

TEST(Detector, RefusesPackagesThatAreNotWhole) {
    const test::TemporaryFolder folder;
    const auto expectRefused = [&](const std::map<std::string, std::string>& files, ErrorCode code,
                                   const std::string& file, const std::string& word) {
        const test::TemporaryFolder package;
        writeFolder(package.path(), files);
        test::expectError([&] { core::installDetector(package.path(), folder / "out"); }, code, file, word);
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    };
    const auto files = packageFiles();
    for (const char* needed :
         {"hand_landmark_full.tflite", "hands_solution_packed_assets.data", "hands_solution_packed_assets_loader.js"}) {
        auto fewer = files;
        fewer.erase(needed);
        expectRefused(fewer, ErrorCode::NotFound, needed, "npm pack");
    }
    auto changed = files;
    changed["hands_solution_packed_assets.data"].resize(1000);
    expectRefused(changed, ErrorCode::BadInput, "loader.js", "lies outside");
    changed = files;
    changed["hands_solution_packed_assets_loader.js"] = "loadPackage({\"files\": 3})";
    expectRefused(changed, ErrorCode::BadInput, "loader.js", "files");
    changed = files;
    std::swap(changed["hand_landmark_full.tflite"], changed["README.md"]);
    expectRefused(changed, ErrorCode::BadInput, "hand_landmark_full.tflite", "not a TensorFlow");
    changed = files;
    changed["hand_landmark_full.tflite"] = test::tfliteBytes(test::networkOfEverything());
    expectRefused(changed, ErrorCode::BadInput, "hand_landmark_full.tflite", "1x224x224x3");
}

TEST(Detector, RefusesDamagedArchives) {
    const test::TemporaryFolder folder;
    const std::string tar = tarOf(packageFiles()), packed = gzipOf(tar);
    const auto expectRefused = [&](const std::string& content, const std::string& word) {
        test::writeText(folder / "hands.tgz", content);
        test::expectError([&] { core::installDetector(folder / "hands.tgz", folder / "out"); }, ErrorCode::BadInput,
                          "hands.tgz", word);
    };
    expectRefused("", "gzip");
    expectRefused("PK and so on", "gzip");
    expectRefused(packed.substr(0, packed.size() / 2), "truncated");
    expectRefused(gzipOf(tar.substr(0, 1700)), "truncated"); // within the second file
    expectRefused(gzipOf("no tar" + std::string(600, 'x')), "tar");
    test::RandomValues random("damaged archives");
    for (int i = 0; i < 100; ++i) {
        std::string damaged = i % 2 == 0 ? tar : packed;
        damaged[static_cast<std::size_t>(
            random.below(static_cast<int>(std::min<std::size_t>(damaged.size(), 2000))))] ^=
            static_cast<char>(1 + random.below(255));
        test::writeText(folder / "hands.tgz", i % 2 == 0 ? gzipOf(damaged) : damaged);
        try {
            core::installDetector(folder / "hands.tgz", folder / "out");
        } catch (const core::Error&) { // any sentence will do
        }
    }
}

TEST(Detector, FindsNoHandInAnEmptyPictureWithTheRealNetworks) {
    const char* package = std::getenv("HANDLENS_DETECTOR_PACKAGE");
    if (!package)
        GTEST_SKIP() << "HANDLENS_DETECTOR_PACKAGE names no package of @mediapipe/hands";
    const test::TemporaryFolder folder;
    core::installDetector(package, folder / "detector");
    core::HandDetector detector(core::readDetector(folder / "detector"));
    EXPECT_TRUE(detector.search(cv::Mat(720, 720, CV_8UC3, cv::Scalar(90, 90, 90)), true).empty());
}

core::ViewDetections someDetections() {
    core::ViewDetections detections(2);
    detections[1].resize(1);
    for (std::size_t i = 0; i < core::kLandmarkCount; ++i)
        detections[1][0].px[i] = {1.0 / 3 + static_cast<double>(i), 2};
    detections[1][0].sidePx = 200;
    return detections;
}

core::FrameFit someFit() {
    core::FrameFit fit;
    fit.source = core::FitSource::Tracking;
    fit.overlap = 0.9;
    fit.deepPx = 1.0 / 7;
    fit.hands.resize(2);
    fit.hands[1] = {
        Eigen::VectorXd::LinSpaced(9, -1.0 / 3, 1), {Eigen::Matrix3d::Random(), Eigen::Matrix3d::Random()}, 0.25};
    return fit;
}

TEST(DetectionJournal, GoesOnAfterALineThatWasCutOff) {
    const test::TemporaryFolder folder;
    const auto file = folder / "out.json.progress";
    const core::JournalWork work{"work", "fits"};
    const core::ViewDetections detections = someDetections();
    {
        core::DetectionJournal journal(file, work, 2);
        journal.append(4, detections);
        journal.append(9, detections);
    }
    const std::string whole = test::readText(file);
    test::writeText(file, whole.substr(0, whole.size() - 20));
    {
        core::DetectionJournal journal(file, work, 2);
        ASSERT_EQ(journal.frames().size(), 1u);
        EXPECT_EQ(journal.frames().at(4)[1][0].px, detections[1][0].px);
        EXPECT_EQ(journal.frames().at(4)[1][0].sidePx, 200);
        journal.append(9, detections);
    }
    EXPECT_EQ(test::readText(file), whole);
    EXPECT_TRUE(core::DetectionJournal(file, {"other work", "fits"}, 2).frames().empty());
}

TEST(DetectionJournal, KeepsFitsToTheLastDigitAndDropsThoseOfOtherWork) {
    const test::TemporaryFolder folder;
    const auto file = folder / "out.json.progress";
    const core::FrameFit fit = someFit();
    {
        core::DetectionJournal journal(file, {"work", "fits"}, 2);
        journal.append(4, someDetections());
        journal.append({"key", 4}, fit);
    }
    {
        const core::DetectionJournal journal(file, {"work", "fits"}, 2);
        ASSERT_EQ(journal.fits().count({"key", 4}), 1u);
        const core::FrameFit& kept = journal.fits().at({"key", 4});
        EXPECT_EQ(kept.source, fit.source);
        EXPECT_EQ(kept.overlap, fit.overlap);
        EXPECT_EQ(kept.deepPx, fit.deepPx);
        ASSERT_EQ(kept.hands.size(), 2u);
        EXPECT_EQ(kept.hands[0].pose.size(), 0);
        EXPECT_EQ(kept.hands[1].pose, fit.hands[1].pose);
        EXPECT_EQ(kept.hands[1].jointCovarianceMm2, fit.hands[1].jointCovarianceMm2);
        EXPECT_EQ(kept.hands[1].doubt, 0.25);
    }
    const core::DetectionJournal other(file, {"work", "other frames"}, 2);
    EXPECT_EQ(other.frames().size(), 1u);
    EXPECT_TRUE(other.fits().empty());
}

TEST(DetectionJournal, OfAnEarlierVersionIsBegunAnew) {
    const test::TemporaryFolder folder;
    const auto file = folder / "out.json.progress";
    for (const std::string old : {"{\"work\":\"work\"}\n{\"frame\":4,\"views\":[[],[]]}\n", "", "not json\n", "{\"a"}) {
        test::writeText(file, old);
        EXPECT_TRUE(core::DetectionJournal(file, {"work", "fits"}, 2).frames().empty());
    }
}

} // namespace
