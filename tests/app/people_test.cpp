// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <fstream>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include "core/annotation/import_edit.h"
#include "core/io/dataset/dataset_annotations.h"
#include "core/io/formats/annotation_formats.h"
#include "tests/app/bracket_language.h"
#include "tests/app/window_fixture.h"
#include "widgets/panels/name_bar.h"
#include "widgets/panels/quality/quality_panel.h"
#include "widgets/presenters/other_marks.h"

namespace {

using core::Side;

using test::kIndex;

/// Anna's marks of one joint in frame 12, each at x.
core::AnnotationSet marksOf(const std::string& rater, double x) {
    core::AnnotationSet set;
    for (const char* camera : {"cam0", "cam1", "cam2"})
        set.marks[{12, rater, kIndex, camera}] = core::Mark{{x, 100}};
    return set;
}

class People : public test::WindowTest {
protected:
    QToolButton* name() { return window->findChild<QToolButton*>(QStringLiteral("rater")); }
    widgets::MessageBar* bar(const char* id) {
        return window->findChild<widgets::MessageBar*>(QString::fromLatin1(id));
    }
    void press(widgets::MessageBar* where, const QString& text) {
        for (QPushButton* button : where->findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text() == text) {
                button->click();
                return;
            }
        }
        ADD_FAILURE() << "no button " << text.toStdString();
    }
    /// A ground truth file with these marks.
    QString file(const core::AnnotationSet& set) {
        const std::string path = (folder / "theirs.json").string();
        core::exportAnnotations(*session().opened.dataset(), *session().opened.sequence(), set, "handlens", path);
        return QString::fromStdString(path);
    }
    void import(const QString& path) {
        session().files.importFrom(QStringLiteral("handlens"), path);
        ASSERT_TRUE(app::waitUntilIdle(*window));
    }
    double x(const std::string& rater) {
        return core::markAt(session().document.annotations(), {12, rater, kIndex, "cam0"})->px.x();
    }
};

TEST_F(People, TheNameIsShownAllTheTime) {
    ASSERT_TRUE(name() && name()->isVisible());
    EXPECT_EQ(name()->text(), QStringLiteral("ann"));
    session().document.setRater("bob");
    EXPECT_EQ(name()->text(), QStringLiteral("bob"));
    EXPECT_FALSE(window->findChild<widgets::NameBar*>()) << "whoever gives a name is not asked";
}

TEST_F(People, TheLoginNameIsTheNameAndIsAskedForOnce) {
    ASSERT_EQ(::setenv("LOGNAME", "carla", 1), 0);
    window = app::makeMainWindow(*settings, app::WindowOptions{"", true});
    window->show();
    EXPECT_EQ(session().document.rater(), "carla");
    auto* ask = window->findChild<widgets::NameBar*>();
    ASSERT_TRUE(ask && ask->isVisible());
    EXPECT_EQ(ask->findChild<QLineEdit*>()->text(), QStringLiteral("carla"));
    ask->findChild<QLineEdit*>()->setText(QStringLiteral(" Carla M. "));
    ask->findChild<QPushButton*>()->click();
    EXPECT_FALSE(ask->isVisible());
    EXPECT_EQ(session().document.rater(), "Carla M.");
    window = app::makeMainWindow(*settings, app::WindowOptions{"", true});
    EXPECT_EQ(session().document.rater(), "Carla M.");
    EXPECT_FALSE(window->findChild<widgets::NameBar*>());
}

TEST_F(People, OtherPeoplesWorkIsAnnouncedAndShownOutOfReach) {
    EXPECT_FALSE(bar("others")->isVisible());
    session().document.push(core::importEdit({}, marksOf("anna", 50), ""));
    restart();
    ASSERT_TRUE(bar("others")->isVisible());
    EXPECT_EQ(bar("others")->message(), QStringLiteral("anna has 3 mark(s) in 1 frame(s) of this sequence."));
    QStringList texts;
    for (QLabel* label : window->workspaces().qualityPanel()->findChildren<QLabel*>())
        texts << label->text();
    EXPECT_FALSE(texts.join(QLatin1Char(' ')).contains(QStringLiteral("No frame of this sequence has marks yet")));
    EXPECT_TRUE(texts.join(QLatin1Char(' ')).contains(QStringLiteral("anna has 3 mark(s)")))
        << texts.join(QLatin1Char(' ')).toStdString();
    widgets::CameraView& view = *window->workspaces().grid()->view(0);
    EXPECT_TRUE(view.otherMarks().empty());
    press(bar("others"), QStringLiteral("Show"));
    EXPECT_FALSE(bar("others")->isVisible());
    ASSERT_EQ(view.otherMarks().size(), 1u);
    EXPECT_EQ(view.otherMarks()[0].px, QPointF(50, 100));
    EXPECT_EQ(view.otherMarks()[0].label, QStringLiteral("anna"));
    EXPECT_FALSE(view.markAt(view.imageToViewport({50, 100}))) << "out of reach";
    session().selection.setFrame(13);
    EXPECT_TRUE(view.otherMarks().empty());
    session().selection.setFrame(12);
    session().document.setRater("anna (again)");
    EXPECT_TRUE(view.otherMarks().empty()) << "a repeat round is blind";
}

TEST_F(People, AnImportAsksBeforeItReplaces) {
    session().document.push(core::importEdit({}, marksOf("anna", 50), ""));
    const core::AnnotationSet before = session().document.annotations();
    import(file(marksOf("anna", 60)));
    ASSERT_TRUE(bar("import")->isVisible());
    EXPECT_EQ(bar("import")->message(), QStringLiteral("theirs.json would replace 3 mark(s) of anna in 1 frame(s)."));
    EXPECT_EQ(session().document.annotations(), before);
    press(bar("import"), QStringLiteral("Cancel"));
    EXPECT_EQ(session().document.annotations(), before);
    import(file(marksOf("anna", 60)));
    press(bar("import"), QStringLiteral("Keep what is there"));
    EXPECT_EQ(session().document.annotations(), before);
    import(file(marksOf("anna", 60)));
    press(bar("import"), QStringLiteral("Replace"));
    EXPECT_EQ(x("anna"), 60);
    session().document.undoStack()->undo();
    EXPECT_EQ(session().document.annotations(), before) << "one step";
    import(file(marksOf("bob", 70)));
    EXPECT_FALSE(bar("import")->isVisible());
    EXPECT_EQ(x("bob"), 70);
    EXPECT_EQ(x("anna"), 50);
}

TEST_F(People, LabelsOfAnotherVideoAreImportedOnlyWhenAskedFor) {
    std::ofstream(folder / "cam0.csv")
        << "scorer,x,x\nbodyparts,left_index_mcp,left_index_mcp\ncoords,x,y\nlabeled-data/monday/img12.png,10,20\n";
    session().files.importFrom(QStringLiteral("deeplabcut"), path("cam0.csv"));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    ASSERT_TRUE(bar("import")->isVisible());
    EXPECT_TRUE(session().document.annotations().marks.empty());
    press(bar("import"), QStringLiteral("Import monday"));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_EQ(x("ann"), 10);
}

TEST_F(People, NotesAboutAnImportAreInTheLanguageOfTheWindow) {
    std::ofstream(folder / "marks.csv") << "sequence,frame,rater,hand,joint,camera,x_px,y_px,state,placement\n"
                                           "z,12,anna,left,index_mcp,cam0,10,20,visible,manual\n"
                                           "z,12,anna,left,index_mcp,cam77,10,20,visible,manual\n"
                                           "z,9999,anna,left,index_mcp,cam0,10,20,visible,manual\n"
                                           "z,13,anna,left,index_mcp,cam0,-900,20,visible,manual\n";
    const test::BracketLanguage brackets;
    session().files.importFrom(QStringLiteral("csv-marks"), path("marks.csv"));
    ASSERT_TRUE(app::waitUntilIdle(*window));
    EXPECT_EQ(x("anna"), 10);
    const QStringList notes = window->message().split(QLatin1Char('\n'));
    ASSERT_EQ(notes.size(), 4) << window->message().toStdString();
    for (const QString& note : notes)
        test::expectInBrackets(note);
    EXPECT_TRUE(window->message().contains(QStringLiteral("cam77")));
}

} // namespace
