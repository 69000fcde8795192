// SPDX-License-Identifier: MIT
#include "widgets/panels/timeline.h"

#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "widgets/panels/state_colours.h"
#include "widgets/panels/timeline_legend.h"
#include "widgets/text/edit_text.h"

namespace widgets {

namespace {

constexpr double kLaneHeight = 8;
constexpr double kLaneGap = 3;
constexpr double kTickHeight = 4;
constexpr double kSidePad = 6;
constexpr double kDoubtfulFrom = 0.2; ///< as the review queue has it

QColor stateColour(const core::HandCoverage& hand, int joints) {
    if (hand.bad > 0)
        return kBadColour;
    return hand.done >= joints && joints > 0 ? kDoneColour : kPartialColour;
}

} // namespace

Timeline::Timeline(QWidget* parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMouseTracking(false);
    setAccessibleName(tr("Timeline"));
}

void Timeline::setFrameCount(int frames) {
    m_frames = std::max(0, frames);
    update();
}

void Timeline::setFrame(int frame) {
    m_frame = frame;
    update();
}

void Timeline::setCoverage(const FrameCoverage& frames, int leftJoints, int rightJoints) {
    m_coverage = frames;
    m_leftJoints = leftJoints;
    m_rightJoints = rightJoints;
    update();
}

void Timeline::setProposedHands(const std::map<int, std::map<core::Side, double>>& frames) {
    m_proposed = frames;
    update();
}

void Timeline::setNotedFrames(const std::set<int>& frames) {
    m_noted = frames;
    update();
}

void Timeline::setTestFrames(const std::set<int>& frames) {
    m_tests = frames;
    update();
}

void Timeline::setOthersFrames(const std::map<int, QString>& frames) {
    m_others = frames;
    update();
}

QSize Timeline::sizeHint() const {
    return {420, minimumSizeHint().height()};
}

QSize Timeline::minimumSizeHint() const {
    return {120, static_cast<int>(2 * kLaneHeight + kLaneGap + 2 * kTickHeight + 4)};
}

QRectF Timeline::track() const {
    const double height = 2 * kLaneHeight + kLaneGap;
    return {kSidePad, (this->height() - height) / 2.0, width() - 2 * kSidePad, height};
}

double Timeline::xOf(int frame) const {
    const QRectF area = track();
    return m_frames > 0 ? area.left() + (frame + 0.5) * area.width() / m_frames : area.left();
}

int Timeline::frameAt(double x) const {
    const QRectF area = track();
    return std::clamp(static_cast<int>(std::floor((x - area.left()) / area.width() * m_frames)), 0,
                      std::max(0, m_frames - 1));
}

void Timeline::paintLane(QPainter& painter, core::Side hand, const QRectF& lane) const {
    painter.setPen(Qt::NoPen);
    painter.setBrush(mixed(palette().color(QPalette::Window), palette().color(QPalette::WindowText), 0.14));
    painter.drawRect(lane);
    const int joints = hand == core::Side::Left ? m_leftJoints : m_rightJoints;
    const double step = m_frames > 0 ? lane.width() / m_frames : 0;
    for (const auto& [frame, hands] : m_coverage) {
        const auto found = hands.find(hand);
        if (found == hands.end() || found->second.marked() == 0)
            continue;
        const double width = std::max(2.0, step - (step > 4 ? 1 : 0));
        const double share = joints > 0 ? double(found->second.marked()) / joints : 1.0;
        const double filled = std::clamp(share, 0.35, 1.0) * lane.height();
        const QRectF bar(lane.left() + frame * step, lane.bottom() - filled, width, filled);
        painter.fillRect(bar, stateColour(found->second, joints));
        if (found->second.occluded > 0)
            painter.fillRect(QRectF(bar.left(), lane.bottom() - 2, bar.width(), 2), kOccludedColour);
    }
}

/// Stripes across the lane: they show in bars of two pixels, too.
void Timeline::paintProposals(QPainter& painter, core::Side hand, const QRectF& lane) const {
    const double step = m_frames > 0 ? lane.width() / m_frames : 0;
    for (const auto& [frame, hands] : m_proposed) {
        const auto found = hands.find(hand);
        if (found == hands.end())
            continue;
        const QColor& colour = found->second >= kDoubtfulFrom ? kDoubtfulColour : kProposedColour;
        for (double y = std::ceil(lane.top()); y < lane.bottom(); y += 2)
            painter.fillRect(QRectF(lane.left() + frame * step, y, std::max(2.0, step - (step > 4 ? 1 : 0)), 1),
                             colour);
    }
}

void Timeline::paintTicks(QPainter& painter) const {
    const QRectF area = track();
    const double step = m_frames > 0 ? area.width() / m_frames : 0;
    const QColor muted = othersColour(palette());
    for (const auto& [frame, names] : m_others)
        painter.fillRect(
            QRectF(area.left() + frame * step, area.center().y() - kLaneGap / 2, std::max(2.0, step), kLaneGap), muted);
    for (const int frame : m_noted)
        painter.fillRect(QRectF(xOf(frame) - 1, area.top() - kTickHeight, 2, kTickHeight),
                         palette().color(QPalette::WindowText));
    for (const int frame : m_tests)
        painter.fillRect(QRectF(xOf(frame) - 1, area.bottom(), 2, kTickHeight), palette().color(QPalette::Highlight));
}

void Timeline::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF area = track();
    const std::pair<core::Side, QRectF> lanes[] = {
        {core::Side::Left, {area.left(), area.top(), area.width(), kLaneHeight}},
        {core::Side::Right, {area.left(), area.bottom() - kLaneHeight, area.width(), kLaneHeight}}};
    for (const auto& [hand, lane] : lanes) {
        paintLane(painter, hand, lane);
        paintProposals(painter, hand, lane);
    }
    paintTicks(painter);
    if (m_frames == 0)
        return;
    const double x = xOf(m_frame);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(palette().color(QPalette::Highlight));
    painter.setPen(Qt::NoPen);
    painter.drawRect(QRectF(x - 1, area.top() - kTickHeight, 2, area.height() + 2 * kTickHeight));
    painter.drawPolygon(
        QPolygonF({{x - 5, area.top() - kTickHeight - 2}, {x + 5, area.top() - kTickHeight - 2}, {x, area.top() + 3}}));
}

void Timeline::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_frames > 0)
        emit frameRequested(frameAt(event->localPos().x()));
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) && m_frames > 0)
        emit frameRequested(frameAt(event->localPos().x()));
}

QString Timeline::describe(int frame) const {
    QString text = tr("Frame %1").arg(frame);
    if (const auto others = m_others.find(frame); others != m_others.end())
        text += QLatin1Char('\n') + tr("Marks of %1").arg(others->second);
    if (const auto proposed = m_proposed.find(frame); proposed != m_proposed.end())
        for (const auto& [hand, doubt] : proposed->second)
            text += QLatin1Char('\n') +
                    tr("%1: proposed, doubt %2 %").arg(sideText(hand)).arg(static_cast<int>(100 * doubt + 0.5));
    const auto found = m_coverage.find(frame);
    if (found == m_coverage.end())
        return text;
    for (const auto& [hand, state] : found->second) {
        text += QLatin1Char('\n') + tr("%1: %2 done, %3 partial, %4 bad, %5 occluded")
                                        .arg(sideText(hand))
                                        .arg(state.done)
                                        .arg(state.partial)
                                        .arg(state.bad)
                                        .arg(state.occluded);
    }
    return text;
}

QString Timeline::toolTipOf(int frame) const {
    return describe(frame).toHtmlEscaped().replace(QLatin1Char('\n'), QLatin1String("<br>")) +
           timelineLegendText(palette());
}

bool Timeline::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && m_frames > 0) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), toolTipOf(frameAt(help->pos().x())), this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace widgets
