// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <QObject>

#include "core/annotation/annotation_set.h"
#include "core/io/dataset/dataset.h"

namespace widgets {

/// Which joints of a hand are annotated.
enum class JointChoice {
    Fourteen,  ///< the joints between finger bones, as in the method authors' annotation files
    TwentyOne, ///< wrist, four per finger, tips included
    AllBones,  ///< every bone origin of the dataset's hands
    Custom     ///< the annotator's own list
};

/// Names of one hand's joints, wrist first, thumb to little finger, base to tip. AllBones needs the hand.
std::vector<std::string> jointNames(JointChoice choice, const core::HandModel* hand);

/// The joints that the annotator works through, in the annotator's order.
class JointList : public QObject {
    Q_OBJECT

public:
    explicit JointList(QObject* parent = nullptr);

    const std::vector<core::JointId>& joints() const { return m_joints; }
    JointChoice choice() const { return m_choice; }
    bool contains(const core::JointId& joint) const;
    /// How many of the joints belong to a hand.
    int count(core::Side hand) const;

    /// The joints of a choice for the hands of a dataset (both hands if it has none); Custom keeps what is there.
    void setChoice(JointChoice choice, const core::Dataset& dataset);
    /// An order of the annotator's own; doubles are dropped.
    void setCustom(std::vector<core::JointId> joints);
    /// The same joints for every hand of the dataset (both hands if it has none), in the order given.
    void setNames(const std::vector<std::string>& names, const core::Dataset& dataset);
    /// Moves the joint at `row` by `rows` places, within the list.
    void move(int row, int rows);

    /// The joint `steps` places after `joint` (around the end); the first one if `joint` is not in the list.
    core::JointId neighbour(const core::JointId& joint, int steps) const;

    /// One line such as "fourteen" or "left index_mcp,left index_pip"; read back by setFromText.
    std::string toText() const;
    /// Understands what toText wrote; returns false, changing nothing, if it does not.
    bool setFromText(const std::string& text, const core::Dataset& dataset);

signals:
    void changed();

private:
    JointChoice m_choice = JointChoice::Fourteen;
    std::vector<core::JointId> m_joints;
};

} // namespace widgets
