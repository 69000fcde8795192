// SPDX-License-Identifier: MIT
#include "widgets/text/error_text.h"

#include "core/error.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText errorWords{"widgets::ErrorText"};
const QChar kBeforeDetail(QChar::ParagraphSeparator);

QString sentence(core::ErrorCode code) {
    switch (code) {
    case core::ErrorCode::Usage:
        return errorWords(QT_TRANSLATE_NOOP("widgets::ErrorText", "this is not possible with the data that is open"));
    case core::ErrorCode::NotFound:
        return errorWords(QT_TRANSLATE_NOOP("widgets::ErrorText", "not found"));
    case core::ErrorCode::BadInput:
        return errorWords(QT_TRANSLATE_NOOP("widgets::ErrorText", "the content is not valid"));
    case core::ErrorCode::Newer:
        return errorWords(QT_TRANSLATE_NOOP("widgets::ErrorText", "written by a newer version of Handlens"));
    case core::ErrorCode::Io:
        return errorWords(
            QT_TRANSLATE_NOOP("widgets::ErrorText", "cannot be read or written: check permissions and space"));
    case core::ErrorCode::Unsupported:
        return errorWords(QT_TRANSLATE_NOOP("widgets::ErrorText", "this kind of content is not supported"));
    }
    return {};
}

} // namespace

QString errorInWords(const std::exception& error) {
    const QString english = QString::fromUtf8(error.what());
    const QLocale::Language language = QLocale().language();
    if (language == QLocale::English || language == QLocale::C)
        return english;
    const auto* known = dynamic_cast<const core::Error*>(&error);
    if (!known)
        return errorWords(QT_TRANSLATE_NOOP("widgets::ErrorText", "unexpected error")) + kBeforeDetail + english;
    QString where;
    for (const std::string& part : {known->file(), known->field()})
        if (!part.empty())
            where += toQString(part) + QStringLiteral(": ");
    return where + sentence(known->code()) + kBeforeDetail + toQString(known->detail());
}

QString withoutDetail(const QString& message) {
    return message.section(kBeforeDetail, 0, 0);
}

QString detailOf(const QString& message) {
    return message.section(kBeforeDetail, 1);
}

QString withDetailBehind(const QString& message) {
    const QString detail = detailOf(message);
    return detail.isEmpty() ? message : withoutDetail(message) + QStringLiteral(" (") + detail + QLatin1Char(')');
}

} // namespace widgets
