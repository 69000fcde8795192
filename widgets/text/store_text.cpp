// SPDX-License-Identifier: MIT
#include "widgets/text/store_text.h"

#include "widgets/text/error_text.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText storeWords{"widgets::StoreText"};

} // namespace

QString readOnlyInWords(const core::ReadOnlyReason& reason) {
    using Kind = core::ReadOnlyReason::Kind;
    switch (reason.kind) {
    case Kind::Requested:
        return storeWords(QT_TRANSLATE_NOOP("widgets::StoreText", "opened for reading only"));
    case Kind::OtherWindow:
        return reason.holder.empty()
                   ? storeWords(QT_TRANSLATE_NOOP("widgets::StoreText", "opened by another window"))
                   : storeWords(QT_TRANSLATE_NOOP("widgets::StoreText", "opened by another window (%1)"))
                         .arg(QString::fromStdString(reason.holder));
    case Kind::ReadOnlyFolder:
        return storeWords(QT_TRANSLATE_NOOP("widgets::StoreText", "the folder is read-only"));
    case Kind::ReadOnlyFile:
        return storeWords(QT_TRANSLATE_NOOP("widgets::StoreText", "the file is read-only"));
    case Kind::None:
        break;
    }
    return {};
}

QString storeWarningInWords(const core::StoreWarning& warning) {
    if (warning.kind == core::StoreWarning::Kind::NoLocks)
        return storeWords(QT_TRANSLATE_NOOP("widgets::StoreText", "This file system has no locks: make sure that no "
                                                                  "other window has %1 open."))
            .arg(QString::fromStdString(warning.problem.file()));
    return storeWords(QT_TRANSLATE_NOOP("widgets::StoreText", "No backup could be made: %1"))
        .arg(errorInWords(warning.problem));
}

} // namespace widgets
