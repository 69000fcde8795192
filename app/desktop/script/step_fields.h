// SPDX-License-Identifier: MIT
#pragma once

#include <QJsonObject>
#include <QPointF>
#include <QStringList>

#include "core/annotation/annotation_set.h"

/// Fields of a script's step. Each throws core::Error(Usage) naming the field if it is missing or of the wrong kind.
namespace app {

QString textField(const QJsonObject& step, const char* name);
int intField(const QJsonObject& step, const char* name);
int intField(const QJsonObject& step, const char* name, int otherwise);
QPointF pointField(const QJsonObject& step, const char* name);
QStringList textsField(const QJsonObject& step, const char* name);
core::JointId jointField(const QJsonObject& step);
Qt::MouseButton buttonField(const QJsonObject& step);
Qt::KeyboardModifiers modifiersField(const QJsonObject& step);

} // namespace app
