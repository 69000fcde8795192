// SPDX-License-Identifier: MIT
#pragma once

#include <QApplication>
#include <QSignalSpy>
#include <QTableView>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include "core/annotation/edits.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tiny_dataset.h"
#include "tests/support/wait_until.h"
#include "widgets/session/workbench.h"

namespace test {

/// A workbench with the tiny dataset open at frame 12 of sequence "a", for panels to stand on.
class PanelTest : public testing::Test {
protected:
    PanelTest() {
        writeTinyDataset(folder / "dataset");
        bench.document.setRater("ann");
        bench.session.openDataset(QString::fromStdString((folder / "dataset").string()), QStringLiteral("a"), 12);
        settle();
        bench.joints.setChoice(widgets::JointChoice::AllBones, *bench.session.dataset());
        bench.selection.setJoint(index);
    }
    void settle() {
        ASSERT_TRUE(waitUntil([this] { return bench.isIdle() && bench.checks.isUpToDate(); }));
    }
    Eigen::Vector3d truth(const core::JointId& joint, int frame) const {
        const std::size_t hand = joint.hand == core::Side::Left ? 0 : 1;
        const core::Skeleton& skeleton = bench.session.dataset()->hands[hand].skeleton;
        return core::jointPositions(
            skeleton, tinyMotion(frame + 1).back()[hand])[static_cast<std::size_t>(skeleton.boneIndex(joint.joint))];
    }
    /// Marks a joint in that camera, `offPx` away from its true place.
    void click(const core::JointId& joint, int camera, double offPx = 0, const std::string& rater = "ann") {
        const core::Camera& seen = bench.session.dataset()->cameras[static_cast<std::size_t>(camera)];
        const Eigen::Vector2d px =
            *core::project(seen, truth(joint, bench.selection.frame())) + Eigen::Vector2d(offPx, 0);
        bench.document.push(
            core::placeEdit(bench.document.annotations(), {bench.selection.frame(), rater, joint, seen.name}, px));
    }
    static QString cell(const QTableView& table, int row, int column) {
        return table.model()->index(row, column).data().toString();
    }
    template <class Widget>
    static Widget* child(QWidget& parent, int which = 0) {
        return parent.findChildren<Widget*>().value(which);
    }

    const core::JointId index{core::Side::Left, "index_mcp"};
    TemporaryFolder folder;
    widgets::Workbench bench;
};

} // namespace test
