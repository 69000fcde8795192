// SPDX-License-Identifier: MIT
// The calibration's health and refinement, and measuring hands, in the real window. Simulated clicks.
#include <QToolButton>

#include "core/annotation/import_edit.h"
#include "core/geometry/rigid_motion.h"
#include "tests/app/window_fixture.h"
#include "tests/support/clicks.h"
#include "widgets/panels/quality/refinement_page.h"
#include "widgets/panels/quality/subject_page.h"

namespace {

class RigWindow : public test::WindowTest {
protected:
    /// Clicks of a rig whose cam5 was turned by 1.2 degrees after it was calibrated.
    void clickFrames(const std::vector<int>& frames) {
        std::vector<core::Camera> seen = session().opened.dataset()->cameras;
        core::RigidMotion& motion = seen[5].cameraFromWorld;
        const Eigen::Vector3d centre = seen[5].centreInWorld();
        motion.rotation = core::rotationExp(Eigen::Vector3d(0, 0.021, 0)) * motion.rotation;
        motion.translation = -(motion.rotation * centre);
        auto random = test::randomFor("RigWindow");
        std::uniform_real_distribution<double> uniform(-60, 60);
        core::AnnotationSet set;
        for (const int frame : frames)
            for (int j = 0; j < 14; ++j)
                test::clickEverywhere(set, seen, frame, "ann", {core::Side::Left, "joint" + std::to_string(j)},
                                      {uniform(random), uniform(random), uniform(random)}, 0.3, &random);
        session().document.push(core::importEdit(session().document.annotations(), set, "clicks"));
        look();
    }
    void look() {
        ASSERT_TRUE(app::waitFor(*window, [this] { return session().rig.isUpToDate(); }));
        ASSERT_TRUE(app::waitUntilIdle(*window));
    }
    QToolButton* notice() { return window->statusLine().findChild<QToolButton*>(QStringLiteral("notice")); }
};

TEST_F(RigWindow, TheStatusLineNamesACameraThatMovedWhateverJointIsSelected) {
    look();
    EXPECT_FALSE(notice()->isVisible());
    clickFrames({2, 8, 14, 20});
    ASSERT_TRUE(notice()->isVisible());
    EXPECT_TRUE(notice()->toolTip().startsWith(QStringLiteral("cam5 is"))) << notice()->toolTip().toStdString();
    session().selection.setJoint({core::Side::Right, "index_mcp"});
    session().selection.setFrame(3);
    EXPECT_TRUE(notice()->toolTip().startsWith(QStringLiteral("cam5 is")));
    notice()->click();
    EXPECT_TRUE(window->workspaces().qualityPanel()->cameras()->isVisible());
    session().document.undoStack()->undo();
    look();
    EXPECT_FALSE(notice()->isVisible());
}

TEST_F(RigWindow, AScriptRefinesUsesTheResultAndTakesPictures) {
    clickFrames({2, 8, 14, 20, 26});
    ASSERT_EQ(play("{\"do\":\"action\",\"id\":\"view.residuals\"}\n"
                   "{\"do\":\"action\",\"id\":\"rig.health\"}\n"
                   "{\"do\":\"action\",\"id\":\"rig.refine\"}\n"
                   "{\"do\":\"shot\",\"of\":\"refinement\",\"path\":\"refinement.png\"}\n"
                   "{\"do\":\"action\",\"id\":\"rig.apply\"}\n"
                   "{\"do\":\"action\",\"id\":\"subject.measure\"}\n"
                   "{\"do\":\"shot\",\"of\":\"subject\",\"path\":\"subject.png\"}\n"),
              0)
        << errors.str() << answers.str();
    EXPECT_EQ(session().opened.dataset()->camerasFile, "cameras-refined-1.json");
    EXPECT_TRUE(QFile::exists(path("out/refinement.png")));
    EXPECT_TRUE(QFile::exists(path("out/subject.png")));
    look();
    EXPECT_FALSE(notice()->isVisible());
    EXPECT_FALSE(window->workspaces().grid()->view(5)->residualArrows().empty());
}

TEST_F(RigWindow, WithoutClicksTheActionsSayWhatIsMissing) {
    look();
    ASSERT_EQ(play("{\"do\":\"action\",\"id\":\"rig.apply\"}\n"
                   "{\"do\":\"action\",\"id\":\"view.residuals\"}\n"
                   "{\"do\":\"action\",\"id\":\"rig.refine\"}\n"
                   "{\"do\":\"action\",\"id\":\"subject.run\"}\n"),
              0)
        << errors.str();
    EXPECT_NE(answers.str().find("Refine the calibration first."), std::string::npos);
    EXPECT_NE(answers.str().find("No joint is clicked in two cameras yet."), std::string::npos);
    EXPECT_FALSE(session().rig.proposal());
    EXPECT_FALSE(session().subject.isMeasuring());
}

} // namespace
