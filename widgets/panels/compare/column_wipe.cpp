// SPDX-License-Identifier: MIT
#include "widgets/panels/compare/column_wipe.h"

namespace widgets {

namespace {

constexpr int kBlinkMs = 600;

} // namespace

ColumnWipe::ColumnWipe(CameraGrid& grid, InspectColumns& columns, QObject* parent)
    : QObject(parent)
    , m_grid(grid)
    , m_columns(columns) {
    m_timer.setInterval(kBlinkMs);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        m_isOver = !m_isOver;
        place(m_isOver ? 0 : 1);
    });
    connect(&columns, &InspectColumns::currentChanged, this, &ColumnWipe::refresh);
}

std::size_t ColumnWipe::other() const {
    const std::size_t current = m_columns.current();
    return current + 1 < m_columns.count() ? current + 1 : current - 1;
}

void ColumnWipe::setKind(Kind kind) {
    if (kind == m_kind)
        return;
    m_kind = kind;
    refresh();
    emit changed();
}

void ColumnWipe::setPlace(double share) {
    m_place = share;
    if (m_kind == Kind::Wipe)
        place(m_place);
}

void ColumnWipe::place(double share) {
    for (const QPointer<WipeCover>& cover : m_covers)
        if (cover)
            cover->setPlace(share);
}

void ColumnWipe::refresh() {
    for (const QPointer<WipeCover>& cover : m_covers)
        delete cover;
    m_covers.clear();
    m_isOver = true;
    const auto columns = static_cast<int>(m_columns.count());
    if (m_kind == Kind::None || columns < 2) {
        m_timer.stop();
        return;
    }
    for (int first = 0; first + columns <= m_grid.count(); first += columns) {
        auto* cover = new WipeCover(*m_grid.view(first + static_cast<int>(m_columns.current())),
                                    *m_grid.view(first + static_cast<int>(other())));
        connect(cover, &WipeCover::dragged, this, &ColumnWipe::setPlace);
        m_covers.emplace_back(cover);
    }
    place(m_kind == Kind::Wipe ? m_place : 0);
    if (m_kind == Kind::Blink)
        m_timer.start();
    else
        m_timer.stop();
}

} // namespace widgets
