// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/annotation/reconstruction.h"
#include "core/io/formats/annotation_formats.h"
#include "tests/support/clicks.h"
#include "tests/support/recordings/ring_dataset.h"
#include "tests/support/temporary_folder.h"

namespace test {

inline core::AnnotationImportOptions importBy(const std::string& rater) {
    core::AnnotationImportOptions options;
    options.rater = rater;
    return options;
}

/// A ring of cameras whose annotations are written and read in every format.
class AnnotationFormats : public testing::Test {
protected:
    const core::Sequence& sequence() const { return m_dataset.sequences[0]; }
    core::ImportedAnnotations import(const std::string& kind, const std::filesystem::path& path) {
        return core::importAnnotations(m_dataset, sequence(), kind, path, m_import);
    }
    core::ImportedAnnotations importSample(const std::string& kind, const std::string& name) {
        return import(kind, std::filesystem::path(HANDLENS_TEST_DATA) / "annotations" / name);
    }
    std::filesystem::path exported(const std::string& kind) {
        const std::filesystem::path path = m_folder / (kind + std::to_string(m_exports++));
        core::exportAnnotations(m_dataset, sequence(), m_set, kind, path, m_export);
        return path;
    }
    void click(int frame, const core::JointId& joint, const Eigen::Vector3d& point, double sigmaPx = 1.0) {
        clickEverywhere(m_set, m_dataset.cameras, frame, "ann", joint, point, sigmaPx, &m_random);
    }
    std::optional<core::Mark> mark(const core::AnnotationSet& set, int frame, const core::JointId& joint,
                                   const std::string& camera) {
        return core::markAt(set, {frame, m_import.rater, joint, camera});
    }
    core::TriangulatedPoint point(int frame, const core::JointId& joint) {
        return *core::reconstruct(m_set, m_dataset.cameras, frame, "ann", joint).result.point;
    }
    /// All 21 joints of both hands in a few frames.
    void clickHands() {
        for (const int frame : {0, 7, 41}) {
            for (const core::Side hand : {core::Side::Left, core::Side::Right}) {
                for (std::size_t i = 0; i < kJoints.size(); ++i) {
                    click(frame, {hand, kJoints[i]},
                          {(hand == core::Side::Left ? -60.0 : 40.0) + 3.0 * static_cast<double>(i),
                           5.0 * static_cast<double>(i % 5), 0.5 * frame});
                }
            }
        }
    }
    /// Marks come in three kinds.
    void varyStates(bool withAuto) {
        for (auto& [key, mark] : m_set.marks) {
            mark.state = m_random() % 4 ? core::MarkState::Visible : core::MarkState::Occluded;
            mark.placement = withAuto && m_random() % 4 == 0 ? core::Placement::Auto : core::Placement::Manual;
        }
    }

    const std::vector<std::string> kJoints{
        "wrist",     "thumb_cmc", "thumb_mcp",  "thumb_ip",   "thumb_tip",  "index_mcp",  "index_pip",
        "index_dip", "index_tip", "middle_mcp", "middle_pip", "middle_dip", "middle_tip", "ring_mcp",
        "ring_pip",  "ring_dip",  "ring_tip",   "little_mcp", "little_pip", "little_dip", "little_tip"};
    TemporaryFolder m_folder;
    core::Dataset m_dataset = ringDataset();
    core::AnnotationSet m_set;
    core::AnnotationExportOptions m_export;
    core::AnnotationImportOptions m_import = importBy("ann");
    std::mt19937_64 m_random = randomFor("AnnotationFormats");
    int m_exports = 0;
};

} // namespace test
