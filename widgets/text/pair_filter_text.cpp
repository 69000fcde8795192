// SPDX-License-Identifier: MIT
#include "widgets/text/pair_filter_text.h"

#include "widgets/text/local_text.h"

namespace widgets {

namespace {
constexpr LocalText filterWords{"widgets::PairFilterText"};
}

QString pairFilterProblemText(const core::PairFilterProblem& problem) {
    using Kind = core::PairFilterProblem::Kind;
    const QString word = QString::fromStdString(problem.word);
    switch (problem.kind) {
    case Kind::UnknownQuantity:
        return filterWords(QT_TRANSLATE_NOOP("widgets::PairFilterText",
                                             "\u201c%1\u201d is neither a method of these results nor sequence, start, "
                                             "test, difference or initial."))
            .arg(word);
    case Kind::NotANumber:
        return filterWords(QT_TRANSLATE_NOOP("widgets::PairFilterText", "\u201c%1\u201d is not a number.")).arg(word);
    case Kind::NoComparison:
        return filterWords(QT_TRANSLATE_NOOP("widgets::PairFilterText",
                                             "\u201c%1\u201d is neither a comparison such as A-B>1 nor a sequence."))
            .arg(word);
    }
    return {};
}

QString pairFilterHelp() {
    return filterWords(QT_TRANSLATE_NOOP(
        "widgets::PairFilterText", "Conditions with blanks between them, all of which must hold: A-B>1 difference>=10 "
                                   "sequence=01. A and B are the "
                                   "methods chosen on the left; a method's name is its error in mm, .seconds or "
                                   ".iterations behind it what it took; "
                                   "start, test and difference are frames, initial is the error of the start pose."));
}

} // namespace widgets
