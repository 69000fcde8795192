// SPDX-License-Identifier: MIT
#include "app/desktop/palettes.h"

#include <QApplication>
#include <QIcon>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>

namespace app {

namespace {

/// The colours from which a palette follows.
struct Tones {
    QColor window, panel, base, text, quiet, accent, onAccent, light, dark, link;
};

const Tones kDark{QColor(0x20, 0x22, 0x25), QColor(0x2B, 0x2D, 0x31), QColor(0x1A, 0x1B, 0x1E),
                  QColor(0xD7, 0xDA, 0xE0), QColor(0x7D, 0x82, 0x8B), QColor(0x2F, 0x7F, 0xD6),
                  QColor(0xFF, 0xFF, 0xFF), QColor(0x45, 0x48, 0x4E), QColor(0x14, 0x15, 0x17),
                  QColor(0x4D, 0xA3, 0xFF)};
const Tones kLight{QColor(0xEF, 0xF0, 0xF2), QColor(0xE3, 0xE5, 0xE8), QColor(0xFF, 0xFF, 0xFF),
                   QColor(0x1F, 0x22, 0x26), QColor(0x8A, 0x8F, 0x97), QColor(0x1F, 0x6F, 0xC8),
                   QColor(0xFF, 0xFF, 0xFF), QColor(0xFF, 0xFF, 0xFF), QColor(0xA9, 0xAE, 0xB6),
                   QColor(0x1A, 0x66, 0xBB)};

/// Fusion, with boxes to tick whose edge is seen on a dark ground, where its own is darker than the window, and with
/// icons of one colour that are seen to be out of use.
class ClearBoxStyle : public QProxyStyle {
public:
    ClearBoxStyle()
        : QProxyStyle(QStringLiteral("Fusion")) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton)
            return;
        constexpr double kEdge = 0.55, kDisabledEdge = 0.25;
        QColor edge = option->palette.color(QPalette::WindowText);
        edge.setAlphaF(option->state & State_Enabled ? kEdge : kDisabledEdge);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setBrush(Qt::NoBrush);
        painter->setPen(QPen(edge, 1));
        const QRectF place = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
        if (element == PE_IndicatorCheckBox)
            painter->drawRoundedRect(place, 2, 2);
        else
            painter->drawEllipse(place);
        painter->restore();
    }

    QPixmap generatedIconPixmap(QIcon::Mode mode, const QPixmap& pixmap, const QStyleOption* option) const override {
        if (mode != QIcon::Disabled)
            return QProxyStyle::generatedIconPixmap(mode, pixmap, option);
        constexpr double kDisabledOpacity = 0.35;
        QPixmap faint(pixmap.size());
        faint.setDevicePixelRatio(pixmap.devicePixelRatio());
        faint.fill(Qt::transparent);
        QPainter painter(&faint);
        painter.setOpacity(kDisabledOpacity);
        painter.drawPixmap(0, 0, pixmap);
        return faint;
    }
};

} // namespace

QPalette paletteFor(Look look) {
    const Tones& tones = look == Look::Dark ? kDark : kLight;
    QPalette palette(tones.panel, tones.window);
    palette.setColor(QPalette::Window, tones.window);
    palette.setColor(QPalette::WindowText, tones.text);
    palette.setColor(QPalette::Base, tones.base);
    palette.setColor(QPalette::AlternateBase, tones.panel);
    palette.setColor(QPalette::Text, tones.text);
    palette.setColor(QPalette::PlaceholderText, tones.quiet);
    palette.setColor(QPalette::Button, tones.panel);
    palette.setColor(QPalette::ButtonText, tones.text);
    palette.setColor(QPalette::BrightText, QColor(0xFF, 0x6B, 0x6B));
    palette.setColor(QPalette::ToolTipBase, tones.panel);
    palette.setColor(QPalette::ToolTipText, tones.text);
    palette.setColor(QPalette::Highlight, tones.accent);
    palette.setColor(QPalette::HighlightedText, tones.onAccent);
    palette.setColor(QPalette::Link, tones.link);
    palette.setColor(QPalette::Light, tones.light);
    palette.setColor(QPalette::Midlight, tones.light);
    palette.setColor(QPalette::Mid, tones.dark);
    palette.setColor(QPalette::Dark, tones.dark);
    palette.setColor(QPalette::Shadow, Qt::black);
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        palette.setColor(QPalette::Disabled, role, tones.quiet);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, tones.panel);
    return palette;
}

QString lookName(Look look) {
    return look == Look::Light    ? QStringLiteral("light")
           : look == Look::System ? QStringLiteral("system")
                                  : QStringLiteral("dark");
}

Look lookFromName(const QString& name) {
    for (const Look look : {Look::Light, Look::System})
        if (name == lookName(look))
            return look;
    return Look::Dark;
}

void applyLook(QApplication& application, Look wanted) {
    constexpr int kMiddleGrey = 128;
    static const bool kDesktopIsDark = application.palette().color(QPalette::Window).lightness() < kMiddleGrey;
    const Look look = wanted != Look::System ? wanted : kDesktopIsDark ? Look::Dark : Look::Light;
    application.setStyle(new ClearBoxStyle);
    application.setPalette(paletteFor(look));
    QIcon::setThemeName(look == Look::Dark ? QStringLiteral("breeze-dark") : QStringLiteral("breeze"));
    QIcon::setFallbackThemeName(QStringLiteral("breeze"));
}

} // namespace app
