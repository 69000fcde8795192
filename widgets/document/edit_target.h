// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "core/annotation/edit.h"
#include "core/io/store/annotation_store.h"

namespace widgets {

/// Where an undo command makes its edit: the document as the command sees it.
class EditTarget {
public:
    using StoreCall = std::function<void(core::AnnotationStore&)>;

    /// Changes the set as `edit` says and keeps it in the file by `call`.
    virtual void perform(const core::Edit& edit, StoreCall call) = 0;
    virtual const std::string& rater() const = 0;

protected:
    ~EditTarget() = default;
};

} // namespace widgets
