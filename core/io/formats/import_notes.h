// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/io/dataset/dataset.h"

namespace core {

/// Decides what of a foreign file fits a sequence, and remembers what did not.
class ImportNotes {
public:
    ImportNotes(const Dataset& dataset, const Sequence& sequence)
        : m_dataset(dataset)
        , m_sequence(sequence) {}

    bool acceptsFrame(int frame);
    bool acceptsCamera(const std::string& camera);
    /// Both of them.
    bool accepts(const MarkKey& key) { return acceptsFrame(key.frame) && acceptsCamera(key.camera); }
    /// Something else that was left out; equal texts are counted.
    void leaveOut(const std::string& what);

    /// A mark of a body part that stands for no joint; `fitting` is a name that would.
    void leaveOutPart(const std::string& part, const std::string& fitting);
    /// The names of such body parts, ascending.
    std::vector<std::string> unknownParts() const;
    /// A row with labels of another video's picture.
    void leaveOutVideo(const std::string& video);
    /// Something that is worth knowing though nothing was left out.
    void remark(const std::string& what);
    /// The videos of such rows, ascending.
    std::vector<std::string> otherVideos() const;

    /// One sentence for each kind of thing that was left out, unknown body parts first.
    std::vector<std::string> warnings() const;

private:
    const Dataset& m_dataset;
    const Sequence& m_sequence;
    std::string partsText() const;

    std::map<std::string, int> m_left;
    std::map<std::string, int> m_parts; ///< marks of unknown body parts
    std::string m_fittingPart;
    std::map<std::string, int> m_videos; ///< rows of other videos
    std::vector<std::string> m_remarks;
};

} // namespace core
