// SPDX-License-Identifier: MIT
#include "app/desktop/actions/footage_notice.h"

#include <QBoxLayout>

#include "app/desktop/main_window.h"
#include "widgets/text/footage_text.h"
#include "widgets/views/message_bar.h"

namespace app {

namespace {

constexpr int kMostNotes = 3;

/// The first few notes, a line each, and how many more there are.
QString noticeText(const std::vector<core::FootageNote>& notes) {
    QStringList lines = widgets::footageNotesInWords(notes);
    const int more = lines.size() - kMostNotes;
    if (more > 0) {
        lines = lines.mid(0, kMostNotes);
        lines << MainWindow::tr("and %n more: see handlens-batch check", nullptr, more);
    }
    return lines.isEmpty() ? QString() : MainWindow::tr("About the footage: %1").arg(lines.join(QLatin1Char('\n')));
}

} // namespace

void bindFootageNotice(MainWindow& window) {
    auto* bar = new widgets::MessageBar(window.centralWidget());
    bar->setObjectName(QStringLiteral("footage"));
    static_cast<QBoxLayout*>(window.centralWidget()->layout())->insertWidget(1, bar);
    QObject::connect(
        &window.session(), &widgets::WindowSession::ready, bar,
        [&window, bar] {
            const core::Sequence* sequence = window.session().opened.sequence();
            bar->offer(sequence ? noticeText(sequence->notes) : QString(), {}, widgets::MessageBar::Tone::Notice);
        });
    QObject::connect(&window.session().document, &widgets::AnnotationDocument::aboutToClose, bar,
                     [bar] { bar->setMessage({}); });
}

} // namespace app
