// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/annotation/annotation_set.h"

namespace core {

/// What an annotator's step does. Behind each kind: the fields of EditDescription that belong to it.
enum class EditKind {
    Other,       ///< text: as it stands in a file of another version
    Place,       ///< joint, camera
    Move,        ///< joint, camera
    Delete,      ///< joint, camera
    SetState,    ///< joint, camera, state
    Note,        ///< firstFrame
    AcceptJoint, ///< joint, camera (empty: in every view)
    AcceptFrame, ///< firstFrame
    Propose,     ///< proposals of the hand model
    FirstPass,   ///< firstFrame, lastFrame: proposals of the hand detector
    CopyPose,    ///< firstFrame (copied from), lastFrame (copied to)
    Interpolate, ///< firstFrame, lastFrame
    SwapHands,   ///< firstFrame, lastFrame (empty: to the last annotated one)
    DeleteRange, ///< firstFrame, lastFrame
    Import       ///< text: the file's name
};

/// A step's kind with its data. The words that a person reads are made elsewhere.
struct EditDescription {
    EditKind kind = EditKind::Other;
    JointId joint = {};
    std::string camera = {};
    MarkState state = MarkState::Visible;
    int firstFrame = 0;
    std::optional<int> lastFrame = {};
    std::string text = {};
    bool operator==(const EditDescription&) const = default;
};

/// The text that stands for a step in annotation files and in error messages, such as "move left index_mcp in cam3".
/// These texts never change: files of every version hold them.
std::string editLabel(const EditDescription& description);
/// The step that a label of an annotation file stands for; Other with the label as its text if it is unknown. So
/// editLabel(parseEditLabel(label)) is always the label.
EditDescription parseEditLabel(std::string_view label);

} // namespace core
