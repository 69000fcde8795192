// SPDX-License-Identifier: MIT
#include "app/desktop/script/step_fields.h"

#include <cmath>

#include <QJsonArray>
#include <QKeySequence>

#include "core/error.h"

namespace app {

namespace {

core::Error wrong(const char* name, const std::string& expected) {
    return {core::ErrorCode::Usage, {}, name, "expected " + expected};
}

} // namespace

QString textField(const QJsonObject& step, const char* name) {
    const QJsonValue value = step[QLatin1String(name)];
    if (!value.isString() || value.toString().isEmpty())
        throw wrong(name, "a text");
    return value.toString();
}

int intField(const QJsonObject& step, const char* name) {
    const QJsonValue value = step[QLatin1String(name)];
    if (!value.isDouble() || value.toDouble() != std::floor(value.toDouble()) || std::abs(value.toDouble()) > 1e9)
        throw wrong(name, "a whole number");
    return static_cast<int>(value.toDouble());
}

int intField(const QJsonObject& step, const char* name, int otherwise) {
    return step.contains(QLatin1String(name)) ? intField(step, name) : otherwise;
}

QPointF pointField(const QJsonObject& step, const char* name) {
    const QJsonArray value = step[QLatin1String(name)].toArray();
    if (value.size() != 2 || !value[0].isDouble() || !value[1].isDouble())
        throw wrong(name, "two numbers [x, y]");
    return {value[0].toDouble(), value[1].toDouble()};
}

QStringList textsField(const QJsonObject& step, const char* name) {
    QStringList texts;
    for (const QJsonValue& value : step[QLatin1String(name)].toArray()) {
        if (!value.isString())
            throw wrong(name, "a list of texts");
        texts << value.toString();
    }
    if (texts.isEmpty())
        throw wrong(name, "a list of texts");
    return texts;
}

core::JointId jointField(const QJsonObject& step) {
    const auto side = core::sideFromName(textField(step, "hand").toStdString());
    if (!side)
        throw wrong("hand", "\"left\" or \"right\"");
    return {*side, textField(step, "joint").toStdString()};
}

Qt::MouseButton buttonField(const QJsonObject& step) {
    if (!step.contains(QLatin1String("button")))
        return Qt::LeftButton;
    const QString name = textField(step, "button");
    if (name == QLatin1String("left"))
        return Qt::LeftButton;
    if (name == QLatin1String("middle"))
        return Qt::MiddleButton;
    if (name == QLatin1String("right"))
        return Qt::RightButton;
    throw wrong("button", "\"left\", \"middle\" or \"right\"");
}

Qt::KeyboardModifiers modifiersField(const QJsonObject& step) {
    if (!step.contains(QLatin1String("modifiers")))
        return Qt::NoModifier;
    const QKeySequence sequence =
        QKeySequence::fromString(textField(step, "modifiers") + QStringLiteral("+A"), QKeySequence::PortableText);
    if (sequence.count() != 1)
        throw wrong("modifiers", "a text such as \"Shift\" or \"Ctrl+Alt\"");
    return Qt::KeyboardModifiers(sequence[0] & static_cast<int>(Qt::KeyboardModifierMask));
}

} // namespace app
