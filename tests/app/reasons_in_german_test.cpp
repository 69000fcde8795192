// SPDX-License-Identifier: MIT
// Reasons and kinds are data; the window says all of them in the person's language.
#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include <gtest/gtest.h>

#include "app/desktop/resources.h"
#include "core/error.h"
#include "tests/app/bracket_language.h"
#include "widgets/jobs/fit_pair.h"
#include "widgets/text/advice.h"
#include "widgets/text/edit_text.h"
#include "widgets/text/error_text.h"
#include "widgets/text/footage_text.h"
#include "widgets/text/import_text.h"
#include "widgets/text/store_text.h"

namespace {

using test::expectInBrackets;

class ReasonsInGerman : public testing::Test {
protected:
    ReasonsInGerman() {
        app::initResources();
        EXPECT_TRUE(m_german.load(QStringLiteral("handlens_de"), QStringLiteral(":/translations")));
    }
    ~ReasonsInGerman() override { QCoreApplication::removeTranslator(&m_german); }

    /// Expects that `say` gives a sentence, and another one while the language is German.
    template <class Say>
    void expectTranslated(const Say& say) {
        QCoreApplication::removeTranslator(&m_german);
        const QString english = say();
        QCoreApplication::installTranslator(&m_german);
        const QString german = say();
        EXPECT_FALSE(english.isEmpty());
        EXPECT_FALSE(german.isEmpty());
        EXPECT_NE(german, english) << english.toStdString();
    }

private:
    QTranslator m_german;
};

core::Edit editOf(core::EditKind kind, core::MarkState state, int marks) {
    core::Edit edit;
    edit.description.kind = kind;
    edit.description.state = state;
    for (int camera = 0; camera < marks; ++camera)
        edit.marks.push_back({{1, "ann", {core::Side::Left, "wrist"}, "cam" + std::to_string(camera)},
                              std::nullopt,
                              core::Mark{{1, 2}}});
    if (kind == core::EditKind::Note)
        edit = {{.kind = kind, .firstFrame = 3}, {}, {{3, "", "text"}}};
    return edit;
}

TEST_F(ReasonsInGerman, EveryTriangulationFailureIsTranslated) {
    using core::TriangulationFailure;
    for (int failure = 1; failure <= static_cast<int>(TriangulationFailure::ViewsDisagree); ++failure)
        expectTranslated([&] { return widgets::failureInWords(static_cast<TriangulationFailure>(failure)); });
}

TEST_F(ReasonsInGerman, EveryKindOfEditIsTranslated) {
    for (int kind = 0; kind <= static_cast<int>(core::EditKind::Import); ++kind)
        for (const int marks : {1, 4})
            for (const auto state : {core::MarkState::Visible, core::MarkState::Occluded, core::MarkState::Unplaceable})
                expectTranslated(
                    [&] { return widgets::editText(editOf(static_cast<core::EditKind>(kind), state, marks)); });
}

TEST_F(ReasonsInGerman, AnUnknownLabelOfAFileIsShownAsItStands) {
    core::Edit edit = editOf(core::EditKind::Other, core::MarkState::Visible, 2);
    edit.description = core::parseEditLabel("a step of a later version");
    EXPECT_EQ(widgets::editText(edit), QStringLiteral("a step of a later version"));
}

TEST_F(ReasonsInGerman, EveryReasonForReadingOnlyIsTranslated) {
    using Kind = core::ReadOnlyReason::Kind;
    for (int kind = 1; kind <= static_cast<int>(Kind::ReadOnlyFile); ++kind)
        for (const char* holder : {"", "ann@lab, process 12"})
            expectTranslated([&] { return widgets::readOnlyInWords({static_cast<Kind>(kind), holder}); });
}

TEST_F(ReasonsInGerman, EveryWarningOfAStoreIsTranslated) {
    using Kind = core::StoreWarning::Kind;
    const core::Error problem(core::ErrorCode::Io, "/data/a.db", "", "no space");
    for (const Kind kind : {Kind::NoLocks, Kind::NoBackup})
        expectTranslated([&] { return widgets::storeWarningInWords({kind, problem}); });
}

TEST_F(ReasonsInGerman, EveryErrorIsTranslatedAndKeepsItsEnglishDetailBehindTheText) {
    const QLocale before;
    for (int code = 0; code <= static_cast<int>(core::ErrorCode::Unsupported); ++code) {
        const core::Error error(static_cast<core::ErrorCode>(code), "/data/cameras.json", "cameras[2].K",
                                "is singular");
        expectTranslated([&] {
            QLocale::setDefault(QLocale(QLocale::German));
            return widgets::withoutDetail(widgets::errorInWords(error));
        });
        const QString german = widgets::errorInWords(error);
        EXPECT_TRUE(german.startsWith(QStringLiteral("/data/cameras.json: cameras[2].K: "))) << german.toStdString();
        EXPECT_FALSE(widgets::withoutDetail(german).contains(QStringLiteral("singular")));
        EXPECT_EQ(widgets::detailOf(german), QStringLiteral("is singular"));
        QLocale::setDefault(QLocale(QLocale::English));
        EXPECT_EQ(widgets::errorInWords(error), QString::fromUtf8(error.what()));
    }
    QLocale::setDefault(before);
}

TEST_F(ReasonsInGerman, EveryNoteAboutFootageIsAskedToBeTranslated) {
    using Kind = core::FootageNoteKind;
    const test::BracketLanguage brackets;
    expectInBrackets(widgets::footageNoteInWords({Kind::Simulated}));
    for (int kind = static_cast<int>(Kind::LostFrames); kind <= static_cast<int>(Kind::FirstPicturesDiffer); ++kind) {
        const core::FootageNote note{static_cast<Kind>(kind), {"cam0"}, {{5, 2}}, {12, 90}};
        expectInBrackets(widgets::footageNoteInWords(note));
        EXPECT_TRUE(widgets::footageNoteInWords(note).contains(QStringLiteral("cam0"))) << kind;
    }
    for (const auto kind : {core::MaskNoteKind::Count, core::MaskNoteKind::OtherNumbers})
        expectInBrackets(widgets::maskNoteInWords({kind, "cam0", 3, 5, 0, 1, 5}));
    for (int kind = 1; kind <= static_cast<int>(core::FootageProblemKind::Unreadable); ++kind)
        expectInBrackets(widgets::footageProblemInWords({static_cast<core::FootageProblemKind>(kind), 3, 5}));
    for (const auto reason : {core::RelinkReason::SeveralFit, core::RelinkReason::OtherFootage})
        expectInBrackets(widgets::relinkNoteInWords({"one", "cam0", "a", "", reason, {"b", "c"}, {}, false}));
    EXPECT_EQ(widgets::footageNoteInWords({Kind::Text, {}, {}, {}, "as written"}), QStringLiteral("as written"));
}

TEST_F(ReasonsInGerman, EveryNoteAboutAnImportIsAskedToBeTranslated) {
    using Kind = core::ImportNoteKind;
    const test::BracketLanguage brackets;
    for (int kind = 0; kind <= static_cast<int>(Kind::OutsidePicture); ++kind) {
        const core::ImportNote note{static_cast<Kind>(kind), {"one", "two"}, 3, 0.5};
        const std::string english = core::importNoteText(note);
        EXPECT_FALSE(english.empty()) << kind;
        expectInBrackets(widgets::importNoteInWords(note));
        for (const std::string& name : note.names) // whatever the command line says of it, the window says, too
            if (english.find(name) != std::string::npos)
                EXPECT_TRUE(widgets::importNoteInWords(note).contains(QString::fromStdString(name))) << english;
    }
    const core::ImportNote manyParts{Kind::UnknownParts, {"fits", "a", "b", "c", "d", "e", "f", "g"}, 9};
    EXPECT_TRUE(widgets::importNoteInWords(manyParts).contains(QStringLiteral("[a, b, c, d, e and 2 more]")));
}

TEST_F(ReasonsInGerman, EveryRefusalOfAFitPairIsTranslated) {
    for (const auto refusal : {widgets::FitRefusal::NoStartPose, widgets::FitRefusal::NoTestMasks})
        expectTranslated([&] { return widgets::fitRefusalText(refusal); });
}

} // namespace
