// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <QColor>
#include <QString>

#include "core/fitting/fit_trace.h"
#include "core/hand/hand_model.h"

namespace widgets {

/// A part of a hand, as far as matches are told apart.
enum class HandPart { Thumb, Index, Middle, Ring, Little, Palm };
/// By the name of a bone; Palm for the wrist, the forearm, names outside the fingers, and without a bone.
HandPart handPart(const core::HandModel& hand, std::uint8_t bone);
QColor handPartColour(HandPart part);

/// Which rim points and matches are drawn, and what the colour of kept matches says.
enum class MatchChoice { ByDistance, ByFinger, Thumb, Index, Middle, Ring, Little, Palm };
inline constexpr std::array kMatchChoices{MatchChoice::ByDistance, MatchChoice::ByFinger, MatchChoice::Thumb,
                                          MatchChoice::Index,      MatchChoice::Middle,   MatchChoice::Ring,
                                          MatchChoice::Little,     MatchChoice::Palm};
/// "distance", "finger", "thumb", ... "palm": as scripts and workspace files call it.
QString matchChoiceId(MatchChoice choice);
std::optional<MatchChoice> matchChoiceOf(const QString& id);
QString matchChoiceText(MatchChoice choice);
/// In the person's language: "index", "palm".
QString handPartText(HandPart part);
/// Whether rim points of that part are drawn.
bool isChosen(MatchChoice choice, HandPart part);

/// Why a match is refused, by colour and by the pattern of its line: told apart with every common kind of colour
/// vision, and none of the colours is one of the scale for distances.
struct RefusalLook {
    QColor colour;
    Qt::PenStyle line = Qt::DashLine;
};
RefusalLook refusalLook(core::MatchVerdict verdict);
/// All verdicts but Kept, in the order of legends.
inline constexpr std::array kRefusals{core::MatchVerdict::Orientation, core::MatchVerdict::Gate,
                                      core::MatchVerdict::Truncated, core::MatchVerdict::EmptyBin,
                                      core::MatchVerdict::Forearm};
/// The reason in the person's language; empty for Kept.
QString verdictInWords(core::MatchVerdict verdict);

} // namespace widgets
