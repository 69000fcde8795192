// SPDX-License-Identifier: MIT
#include "widgets/panels/empty_state.h"

#include <QCommandLinkButton>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>

#include "widgets/panels/state_colours.h"

namespace widgets {

EmptyState::EmptyState(QWidget* parent)
    : QWidget(parent)
    , m_recent(new QVBoxLayout)
    , m_recentTitle(new QLabel(tr("Recent datasets"), this)) {
    auto* title = new QLabel(tr("Open a dataset or make one of your videos: drop either here. Or try the demo."), this);
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.5);
    title->setFont(large);
    title->setAlignment(Qt::AlignCenter);
    title->setWordWrap(true);
    auto* open =
        new QPushButton(QIcon::fromTheme(QStringLiteral("document-open-folder")), tr("Open a dataset..."), this);
    auto* make = new QPushButton(QIcon::fromTheme(QStringLiteral("document-new")), tr("Make a dataset..."), this);
    auto* demo = new QPushButton(QIcon::fromTheme(QStringLiteral("media-playback-start")), tr("Try the demo"), this);
    connect(open, &QPushButton::clicked, this, &EmptyState::openRequested);
    connect(make, &QPushButton::clicked, this, &EmptyState::newRequested);
    connect(demo, &QPushButton::clicked, this, &EmptyState::demoRequested);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2 * kSpacing);
    buttons->addStretch(1);
    for (QPushButton* button : {open, make, demo}) {
        button->setMinimumSize(180, 36);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    m_recentTitle->setAlignment(Qt::AlignCenter);
    m_recent->setSpacing(0);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(3 * kSpacing);
    column->addStretch(2);
    column->addWidget(title);
    column->addLayout(buttons);
    column->addWidget(m_recentTitle);
    column->addLayout(m_recent);
    column->addStretch(3);
    setRecentDatasets({});
}

void EmptyState::setRecentDatasets(const QStringList& folders) {
    while (QLayoutItem* item = m_recent->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_recentTitle->setVisible(!folders.isEmpty());
    for (const QString& folder : folders) {
        auto* button = new QPushButton(QDir::toNativeSeparators(folder), this);
        button->setFlat(true);
        button->setCursor(Qt::PointingHandCursor);
        connect(button, &QPushButton::clicked, this, [this, folder] { emit recentRequested(folder); });
        m_recent->addWidget(button, 0, Qt::AlignHCenter);
    }
}

} // namespace widgets
