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
#include "widgets/session/window_session.h"

namespace test {

/// A session with the tiny dataset open at frame 12 of sequence "a", for panels to stand on.
class PanelTest : public testing::Test {
protected:
    PanelTest() {
        writeTinyDataset(folder / "dataset");
        session.document.setRater("ann");
        session.opened.openDataset(QString::fromStdString((folder / "dataset").string()), QStringLiteral("a"), 12);
        settle();
        session.joints.setChoice(widgets::JointChoice::AllBones, *session.opened.dataset());
        session.selection.setJoint(index);
    }
    void settle() {
        ASSERT_TRUE(waitUntil([this] { return session.isIdle() && session.checks.isUpToDate(); }));
    }
    Eigen::Vector3d truth(const core::JointId& joint, int frame) const {
        const std::size_t hand = joint.hand == core::Side::Left ? 0 : 1;
        const core::Skeleton& skeleton = session.opened.dataset()->hands[hand].skeleton;
        return core::jointPositions(
            skeleton, tinyMotion(frame + 1).back()[hand])[static_cast<std::size_t>(skeleton.boneIndex(joint.joint))];
    }
    /// Marks a joint in that camera, `offPx` away from its true place.
    void click(const core::JointId& joint, int camera, double offPx = 0, const std::string& rater = "ann") {
        const core::Camera& seen = session.opened.dataset()->cameras[static_cast<std::size_t>(camera)];
        const Eigen::Vector2d px =
            *core::project(seen, truth(joint, session.selection.frame())) + Eigen::Vector2d(offPx, 0);
        session.document.push(
            core::placeEdit(session.document.annotations(), {session.selection.frame(), rater, joint, seen.name}, px));
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
    widgets::WindowSession session;
};

} // namespace test
