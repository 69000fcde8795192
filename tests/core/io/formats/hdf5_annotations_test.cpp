// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/io/hdf5/column_pickle.h"
#include "core/io/hdf5/sleap_file.h"
#include "tests/core/io/formats/annotation_formats_fixture.h"
#include "tests/core/io/formats/hdf5_writer.h"

namespace {

using core::Mark;
using core::MarkState;
using core::Placement;
using core::Side;
using Eigen::Vector2d;
using test::Hdf5Writer;

const double kMissing = std::nan("");

class Hdf5Annotations : public test::AnnotationFormats {
protected:
    /// What importing the file complains of.
    std::string refusal(const std::string& kind, const std::filesystem::path& file) {
        try {
            import(kind, file);
        } catch (const core::Error& error) {
            return error.what();
        }
        return "taken";
    }
    const std::filesystem::path m_file = m_folder / "cam0.h5";
};

/// Python's pickle.dumps([("net", "left_wrist", "x"), ("net", "left_wrist", "y"), ("net", "left_wrist", "likelihood")],
/// 0), which PyTables stores.
const std::string kColumns =
    "(lp0\n(Vnet\np1\nVleft_wrist\np2\nVx\np3\ntp4\na(g1\ng2\nVy\np5\ntp6\na(g1\ng2\nVlikelihood"
    "\np7\ntp8\na.";

TEST(ColumnPickle, HoldsTextsAndTuplesOfTexts) {
    using Columns = std::vector<std::vector<std::string>>;
    EXPECT_EQ(core::columnsOfPickle(kColumns),
              (Columns{{"net", "left_wrist", "x"}, {"net", "left_wrist", "y"}, {"net", "left_wrist", "likelihood"}}));
    EXPECT_EQ(core::columnsOfPickle("(lp0\nVa\np1\naVtip\xe4\\u20ac\np2\na."), (Columns{{"a"}, {"tip\u00e4\u20ac"}}));
    EXPECT_EQ(core::columnsOfPickle("(lp0\nI0\naI1\na."), (Columns{{"0"}, {"1"}}));
    for (const char* wrong : {"", ".", "(l", "t.", "a.", "g1\n.", "cos\nsystem\n(Vls\ntR.", "(lp0\n(lVx\naaa."})
        EXPECT_FALSE(core::columnsOfPickle(wrong)) << wrong;
}

TEST(ColumnPickle, RefusesFewBytesThatStandForMoreThanAnyMemoryHolds) {
    std::string nested = "Vname\np0\n"; // each tuple holds the one before it a hundred times
    for (int level = 0; level < 7; ++level) {
        nested += '(';
        for (int i = 0; i < 100; ++i)
            nested += "g" + std::to_string(level) + "\n";
        nested += "tp" + std::to_string(level + 1) + "\n";
    }
    EXPECT_FALSE(core::columnsOfPickle("(" + nested + "l."));
    std::string repeated = "(lp0\nV" + std::string(100'000, 'n') + "\np1\na"; // one long name, many times
    for (int i = 0; i < 100'000; ++i)
        repeated += "g1\na";
    EXPECT_FALSE(core::columnsOfPickle(repeated + "."));
    const std::size_t deep = 1'000'000; // freeing it would fill the stack of the program
    EXPECT_FALSE(core::columnsOfPickle(std::string(deep, '(') + std::string(deep, 't') + "."));
}

struct TableRow {
    std::int64_t index;
    double values[3];
};

void writeTable(const std::filesystem::path& path, const std::string& columns) {
    Hdf5Writer file(path);
    file.group("df_with_missing");
    const hsize_t three[] = {3};
    const hid_t values = H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, three);
    file.table<TableRow>(
        "df_with_missing/table",
        {{"index", HOFFSET(TableRow, index), H5T_NATIVE_INT64}, {"values_block_0", HOFFSET(TableRow, values), values}},
        {{0, {10.5, 20.25, 0.003}}, {7, {30, 40, 0.97}}, {8, {kMissing, kMissing, kMissing}}});
    file.attribute("df_with_missing/table", "values_block_0_kind", columns);
    H5Tclose(values);
}

TEST_F(Hdf5Annotations, PredictionsInTheTableLayoutAreProposals) {
    writeTable(m_file, kColumns);
    for (const char* kind : {"deeplabcut", "anipose2d"}) {
        const auto got = import(kind, m_file).set;
        ASSERT_EQ(got.marks.size(), 2u);
        EXPECT_EQ(*mark(got, 0, {Side::Left, "wrist"}, "cam0"),
                  (Mark{{10.5, 20.25}, Placement::Proposed, MarkState::Visible, 0.003}));
        EXPECT_EQ(*mark(got, 7, {Side::Left, "wrist"}, "cam0"),
                  (Mark{{30, 40}, Placement::Proposed, MarkState::Visible, 0.97}));
    }
    m_import.minLikelihood = 0.5;
    EXPECT_EQ(import("deeplabcut", m_file).set.marks.size(), 1u);
    EXPECT_EQ(import("deeplabcut", m_folder / "").set.marks.size(), 1u) << "a folder without CSV files";
}

/// One axis whose names have levels: those of each level, and per item the number of its name.
void writeAxis(Hdf5Writer& file, const std::string& axis, const std::vector<std::vector<std::string>>& levels,
               const std::vector<std::vector<double>>& labels) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
        file.fixedTexts(axis + "_level" + std::to_string(i), levels[i]);
        file.numbers(axis + "_label" + std::to_string(i), {labels[i].size()}, labels[i], H5T_STD_I8LE);
    }
}

/// Labels of two pictures in the fixed layout; pandas sorts the names of a level, and turns the block.
void writeFixed(const std::filesystem::path& path, const std::vector<hsize_t>& shape = {2, 4}) {
    Hdf5Writer file(path);
    file.group("keypoints");
    for (const char* axis : {"keypoints/axis0", "keypoints/block0_items"})
        writeAxis(file, axis, {{"maria"}, {"left_wrist", "right_wrist"}, {"x", "y"}},
                  {{0, 0, 0, 0}, {1, 1, 0, 0}, {0, 1, 0, 1}});
    writeAxis(file, "keypoints/axis1", {{"labeled-data"}, {"monday", "take1"}, {"img003.png", "img012.png"}},
              {{0, 0}, {1, 0}, {1, 0}});
    file.numbers("keypoints/block0_values", shape, {1, 2, 3, 4, 5, 6, 7, 8});
}

TEST_F(Hdf5Annotations, LabelsInTheFixedLayoutKeepTheRulesOfSessions) {
    writeFixed(m_file);
    m_dataset.sequences[0].name = "take1";
    const auto got = import("deeplabcut", m_file);
    ASSERT_EQ(got.set.marks.size(), 2u);
    EXPECT_EQ(*mark(got.set, 12, {Side::Right, "wrist"}, "cam0"),
              (Mark{{1, 2}, Placement::Manual, MarkState::Visible}));
    EXPECT_EQ(mark(got.set, 12, {Side::Left, "wrist"}, "cam0")->px, Vector2d(3, 4));
    EXPECT_EQ(got.otherVideos, std::vector<std::string>{"monday"});
    m_import.videos = {"monday"};
    EXPECT_EQ(mark(import("deeplabcut", m_file).set, 3, {Side::Left, "wrist"}, "cam0")->px, Vector2d(7, 8));
}

TEST_F(Hdf5Annotations, DataFramesThatAreWrongAreRefusedByName) {
    std::ofstream(m_file) << "scorer,a\n";
    EXPECT_EQ(refusal("deeplabcut", m_file), m_file.string() + ": is not a readable HDF5 file");
    Hdf5Writer(m_file).group("other");
    EXPECT_NE(refusal("deeplabcut", m_file).find(": df_with_missing: is missing"), std::string::npos);
    writeFixed(m_file, {8, 1});
    EXPECT_NE(refusal("deeplabcut", m_file).find("keypoints/block0_values: is of shape 8 x 1, 2 x 4 is expected"),
              std::string::npos)
        << refusal("deeplabcut", m_file);
    writeTable(m_file, "cos\nsystem\n.");
    EXPECT_NE(refusal("deeplabcut", m_file).find("values_block_0_kind: the names of the columns cannot be understood"),
              std::string::npos);
}

/// `tracks` in the order of MATLAB: track, xy, node, frame. Node 0 is the wrist, node 1 the index; x = 100 track + 10
/// node + frame.
std::vector<double> matlabTracks() {
    std::vector<double> values;
    for (int track = 0; track < 2; ++track)
        for (int xy = 0; xy < 2; ++xy)
            for (int node = 0; node < 2; ++node)
                for (int frame = 0; frame < 3; ++frame)
                    values.push_back(track == 1 && frame == 0 ? kMissing : 100 * track + 10 * node + frame + 0.5 * xy);
    return values;
}

TEST_F(Hdf5Annotations, SleapAnalysisIsReadInEitherOrderOfItsAxes) {
    for (const bool isNamed : {false, true}) {
        {
            Hdf5Writer file(m_file);
            file.fixedTexts("node_names", {"wrist", "index_mcp"});
            file.fixedTexts("track_names", {"left", "right"});
            if (!isNamed) {
                file.numbers("tracks", {2, 2, 2, 3}, matlabTracks());
                file.numbers("point_scores", {2, 2, 3}, {.1, .2, .3, .4, .5, .6, kMissing, .8, .9, 1, 1, 1});
            } else { // frame, track, node, xy
                std::vector<double> values;
                for (int frame = 0; frame < 3; ++frame)
                    for (int track = 0; track < 2; ++track)
                        for (int node = 0; node < 2; ++node)
                            for (int xy = 0; xy < 2; ++xy)
                                values.push_back(matlabTracks()[((track * 2 + xy) * 2 + node) * 3 + frame]);
                file.numbers("tracks", {3, 2, 2, 2}, values);
                file.attribute("tracks", "dims", "[\"frame\", \"track\", \"node\", \"xy\"]");
            }
        }
        const auto got = import("sleap", m_file).set;
        EXPECT_EQ(got.marks.size(), 10u);
        const Mark index = *mark(got, 2, {Side::Right, "index_mcp"}, "cam0");
        EXPECT_EQ(index.px, Vector2d(112, 112.5));
        EXPECT_EQ(index.placement, Placement::Proposed);
        const Mark wrist = *mark(got, 1, {Side::Left, "wrist"}, "cam0");
        EXPECT_EQ(wrist.px, Vector2d(1, 1.5));
        if (!isNamed)
            EXPECT_EQ(wrist.likelihood, 0.2);
    }
    {
        Hdf5Writer file(m_file);
        file.fixedTexts("node_names", {"wrist", "index_mcp"});
        file.numbers("tracks", {3, 2, 2, 2}, std::vector<double>(24));
    }
    EXPECT_EQ(import("sleap", m_file).set.marks.size(), 0u) << "no track says the hand";
    { // frame, node, xy, track, without names: only this fits three nodes
        Hdf5Writer file(m_file);
        file.fixedTexts("node_names", {"left_wrist", "left_index_mcp", "left_index_tip"});
        std::vector<double> values;
        for (int frame = 0; frame < 5; ++frame)
            for (int node = 0; node < 3; ++node)
                for (int xy = 0; xy < 2; ++xy)
                    values.push_back(10 * node + frame + 0.5 * xy);
        file.numbers("tracks", {5, 3, 2, 1}, values);
        file.numbers("point_scores", {5, 3, 1}, std::vector<double>(15, 0.75));
    }
    const auto turned = import("sleap", m_file).set;
    EXPECT_EQ(turned.marks.size(), 15u);
    EXPECT_EQ(*mark(turned, 4, {Side::Left, "index_tip"}, "cam0"),
              (Mark{{24, 24.5}, Placement::Proposed, MarkState::Visible, 0.75}));
    {
        Hdf5Writer file(m_file);
        file.fixedTexts("node_names", {"wrist", "index_mcp"});
        file.numbers("tracks", {3, 5, 2, 2}, std::vector<double>(60));
    }
    EXPECT_NE(refusal("sleap", m_file).find("tracks: has 5 along its axis \"xy\", 2 are expected"), std::string::npos);
}

#pragma pack(push, 1) // as numpy's records
struct FrameRecord {
    std::uint64_t id;
    std::uint32_t video;
    std::uint64_t frame, first, last;
};
struct InstanceRecord {
    std::int64_t id;
    std::uint8_t type;
    std::uint64_t frame;
    std::uint32_t skeleton;
    std::int32_t track;
    std::int64_t fromPredicted;
    float score;
    std::uint64_t first, last;
};
struct PointRecord {
    double x, y;
    std::int8_t visible, complete;
};
struct GuessRecord {
    double x, y;
    std::int8_t visible, complete;
    double score;
};
#pragma pack(pop)

/// A project of two videos. Frame 4 of the first: a label (its index is hidden), the guess that it corrects, and a
/// guess of the right hand; frame 5 of the second: a label.
void writeProject(const std::filesystem::path& path, double formatId) {
    Hdf5Writer file(path);
    file.group("metadata");
    file.attribute("metadata", "format_id", formatId);
    file.attribute("metadata", "json",
                   R"({"skeletons":[{"nodes":[{"id":1},{"id":0}]}],"nodes":[{"name":"index_mcp"},{"name":"wrist"}]})");
    file.variableTexts("videos_json", {R"({"filename":"C:\\data\\01-cam2.mp4","backend":{"type":"MediaVideo"}})",
                                       R"({"backend":{"filename":"monday.mp4"}})"});
    file.variableTexts("tracks_json", {"[0, \"left\"]", "[0, \"right\"]"});
    const hid_t boolean = Hdf5Writer::boolType();
    file.table<FrameRecord>("frames",
                            {{"frame_id", HOFFSET(FrameRecord, id), H5T_NATIVE_UINT64},
                             {"video", HOFFSET(FrameRecord, video), H5T_NATIVE_UINT32},
                             {"frame_idx", HOFFSET(FrameRecord, frame), H5T_NATIVE_UINT64},
                             {"instance_id_start", HOFFSET(FrameRecord, first), H5T_NATIVE_UINT64},
                             {"instance_id_end", HOFFSET(FrameRecord, last), H5T_NATIVE_UINT64}},
                            {{0, 0, 4, 0, 3}, {1, 1, 5, 3, 4}});
    file.table<InstanceRecord>("instances",
                               {{"instance_id", HOFFSET(InstanceRecord, id), H5T_NATIVE_INT64},
                                {"instance_type", HOFFSET(InstanceRecord, type), H5T_NATIVE_UINT8},
                                {"frame_id", HOFFSET(InstanceRecord, frame), H5T_NATIVE_UINT64},
                                {"skeleton", HOFFSET(InstanceRecord, skeleton), H5T_NATIVE_UINT32},
                                {"track", HOFFSET(InstanceRecord, track), H5T_NATIVE_INT32},
                                {"from_predicted", HOFFSET(InstanceRecord, fromPredicted), H5T_NATIVE_INT64},
                                {"score", HOFFSET(InstanceRecord, score), H5T_NATIVE_FLOAT},
                                {"point_id_start", HOFFSET(InstanceRecord, first), H5T_NATIVE_UINT64},
                                {"point_id_end", HOFFSET(InstanceRecord, last), H5T_NATIVE_UINT64}},
                               {{0, 1, 0, 0, 0, -1, 0.9F, 0, 2},
                                {1, 0, 0, 0, 0, 0, 0, 0, 2},
                                {2, 1, 0, 0, 1, -1, 0.8F, 2, 4},
                                {3, 0, 1, 0, 0, -1, 0, 2, 4}});
    const std::vector<Hdf5Writer::Member> point{
        {"x", 0, H5T_NATIVE_DOUBLE}, {"y", 8, H5T_NATIVE_DOUBLE}, {"visible", 16, boolean}, {"complete", 17, boolean}};
    file.table<PointRecord>("points", point, {{10, 20, 1, 0}, {11, 21, 0, 0}, {12, 22, 1, 0}, {13, 23, 1, 0}});
    std::vector<Hdf5Writer::Member> guess = point;
    guess.push_back({"score", 18, H5T_NATIVE_DOUBLE});
    file.table<GuessRecord>("pred_points", guess,
                            {{1, 2, 1, 0, .5}, {3, 4, 1, 0, .5}, {30, 40, 1, 0, .25}, {kMissing, kMissing, 1, 0, 0}});
    H5Tclose(boolean);
}

TEST_F(Hdf5Annotations, SleapProjectsHoldLabelsAndGuesses) {
    const auto file = m_folder / "labels.slp";
    for (const double format : {1.0, 1.1, 2.7}) {
        writeProject(file, format);
        const auto got = import("sleap", file);
        ASSERT_EQ(got.set.marks.size(), 2u);
        const double corner = format < 1.1 ? 0.5 : 0;
        EXPECT_EQ(*mark(got.set, 4, {Side::Left, "wrist"}, "cam2"),
                  (Mark{{10 - corner, 20 - corner}, Placement::Manual, MarkState::Visible}));
        EXPECT_EQ(*mark(got.set, 4, {Side::Right, "wrist"}, "cam2"),
                  (Mark{{30, 40}, Placement::Proposed, MarkState::Visible, 0.25}))
            << "guesses never counted from corners";
        EXPECT_EQ(got.otherVideos, std::vector<std::string>{"monday"});
        m_import.minLikelihood = 0.5;
        EXPECT_EQ(import("sleap", file).set.marks.size(), 1u) << "a person's label has no likelihood";
        m_import.minLikelihood.reset();
    }
    EXPECT_EQ(core::readSleapFile(file).hiddenPoints, 1);
    EXPECT_EQ(core::sleapVideoName("a/labeled/img01.PNG"), "labeled");
    Hdf5Writer(file).group("metadata");
    EXPECT_NE(refusal("sleap", file).find("is neither a SLEAP project"), std::string::npos);
    std::ofstream(file) << "no";
    EXPECT_EQ(refusal("sleap", file), file.string() + ": is not a readable HDF5 file");
}

} // namespace
