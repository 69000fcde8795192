// SPDX-License-Identifier: MIT
// A German window shows reasons, edits and errors without an English word of its own.
#include <fstream>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QDomDocument>
#include <QGroupBox>
#include <QLabel>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

#include "app/desktop/resources.h"
#include "core/annotation/edits.h"
#include "core/io/dataset/dataset_annotations.h"
#include "tests/app/window_fixture.h"
#include "widgets/text/edit_text.h"
#include "widgets/text/store_text.h"

namespace {

using core::Side;

using test::kIndex;
constexpr int kLeastLetters = 12; ///< a shorter piece of a sentence may be German, too

/// The longest piece of a text without places for values and marks of shortcuts.
QString longestPiece(QString text) {
    static const QRegularExpression kPlace(QStringLiteral("%(L?[0-9]|n|p)"));
    QString longest;
    for (const QString& piece : text.remove(QLatin1Char('&')).split(kPlace))
        if (piece.trimmed().size() > longest.size())
            longest = piece.trimmed();
    return longest;
}

/// Pieces of English sentences that have another German translation.
QStringList englishPieces() {
    QFile stream(QStringLiteral(HANDLENS_SOURCE_DIR "/translations/handlens_de.ts"));
    QDomDocument document;
    EXPECT_TRUE(stream.open(QIODevice::ReadOnly) && document.setContent(&stream));
    QStringList pieces;
    const QDomNodeList nodes = document.elementsByTagName(QStringLiteral("message"));
    for (int i = 0; i < nodes.count(); ++i) {
        const QDomElement message = nodes.at(i).toElement();
        const QString piece = longestPiece(message.firstChildElement(QStringLiteral("source")).text());
        const QString german = message.firstChildElement(QStringLiteral("translation")).text().remove('&');
        if (piece.size() >= kLeastLetters && piece.contains(' ') && !german.contains(piece))
            pieces << piece;
    }
    return pieces;
}

void addCells(const QAbstractItemModel& model, QStringList& texts) {
    for (int row = 0; row < model.rowCount(); ++row)
        for (int column = 0; column < model.columnCount(); ++column)
            for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
                texts << model.index(row, column).data(role).toString();
}

/// What a person can read in the window, tool tips of errors' English details aside.
QStringList textsOf(QWidget& window) {
    QStringList texts;
    for (const QLabel* label : window.findChildren<QLabel*>())
        texts << label->text();
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
        texts << button->text() << button->toolTip();
    for (const QAction* action : window.findChildren<QAction*>())
        texts << action->text() << action->toolTip();
    for (const QGroupBox* group : window.findChildren<QGroupBox*>())
        texts << group->title();
    for (const QAbstractItemView* view : window.findChildren<QAbstractItemView*>())
        if (view->model())
            addCells(*view->model(), texts);
    texts.removeAll(QString());
    return texts;
}

class GermanWindow : public test::WindowTest {
protected:
    GermanWindow() {
        app::initResources();
        EXPECT_TRUE(m_german.load(QStringLiteral("handlens_de"), QStringLiteral(":/translations")));
        QCoreApplication::installTranslator(&m_german);
        QLocale::setDefault(QLocale(QLocale::German));
        restart();
        session().selection.setJoint(kIndex);
    }
    ~GermanWindow() override {
        window.reset();
        QCoreApplication::removeTranslator(&m_german);
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    }

    void expectNoEnglish(const char* when) {
        app::waitUntilIdle(*window);
        for (const QString& text : textsOf(*window))
            for (const QString& piece : m_english)
                EXPECT_FALSE(text.contains(piece)) << when << ": " << text.toStdString();
    }
    bool shows(const QString& text) const {
        const QStringList texts = textsOf(*window);
        return std::any_of(texts.begin(), texts.end(), [&](const QString& shown) { return shown.contains(text); });
    }
    void click(int index, double offPx = 0) {
        const Eigen::Vector2d px = *core::project(camera(index), truth(Side::Left, 1, 12)) + Eigen::Vector2d(0, offPx);
        session().document.push(core::placeEdit(session().document.annotations(),
                                                {12, session().document.rater(), kIndex, camera(index).name}, px));
    }
    /// Tries to open a dataset that is not one; returns what the window says.
    QString messageOfOpening(const char* name) {
        window->openDataset(path(name));
        EXPECT_TRUE(app::waitUntilIdle(*window));
        return window->message();
    }

    QTranslator m_german;
    const QStringList m_english = englishPieces();
};

TEST_F(GermanWindow, ShowsReasonsAndUndoStepsInGerman) {
    EXPECT_GT(m_english.size(), 200);
    expectNoEnglish("without marks");
    click(0);
    expectNoEnglish("one click: no point yet");
    EXPECT_TRUE(shows(widgets::editText(core::placeEdit({}, {12, "ann", kIndex, "cam0"}, {1, 1}))));
    click(1, 150);
    expectNoEnglish("two clicks that disagree");
    const core::MarkKey key{12, session().document.rater(), kIndex, camera(1).name};
    session().document.push(core::stateEdit(session().document.annotations(), key, core::MarkState::Occluded));
    expectNoEnglish("an occluded mark");
    session().document.push(core::removeEdit(session().document.annotations(), key));
    session().document.undoStack()->undo();
    expectNoEnglish("an undone deletion");
}

TEST_F(GermanWindow, SaysInGermanWhyItIsReadOnly) {
    click(0);
    const std::filesystem::path file = core::annotationFile(*session().opened.dataset(), *session().opened.sequence());
    window.reset();
    const auto elsewhere = widgets::AnnotationDocument::read(file);
    start();
    ASSERT_TRUE(session().document.store()->isReadOnly());
    const QString why = widgets::readOnlyInWords(session().document.store()->readOnlyReason());
    EXPECT_TRUE(window->message().contains(why)) << window->message().toStdString();
    EXPECT_FALSE(why.contains(QStringLiteral("window"))) << why.toStdString();
    expectNoEnglish("read-only");
}

TEST_F(GermanWindow, SaysInGermanWhyADatasetDoesNotOpen) {
    const auto expectGerman = [&](const QString& message, const char* file, const char* english) {
        EXPECT_TRUE(message.contains(QString::fromUtf8(file))) << message.toStdString();
        EXPECT_FALSE(message.contains(QString::fromUtf8(english))) << message.toStdString();
        expectNoEnglish(file);
    };
    expectGerman(messageOfOpening("gone"), "gone", "no such");
    test::writeTinyDataset(folder / "broken");
    std::ofstream(folder / "broken" / "cameras.json") << "{ \"format\": ";
    expectGerman(messageOfOpening("broken"), "cameras.json", "parse");
    test::writeTinyDataset(folder / "old");
    std::filesystem::remove(folder / "old" / "hands" / "left.json");
    expectGerman(messageOfOpening("old"), "left.json", "no such");
}

} // namespace
