// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/annotation/edit.h"
#include "core/io/store/annotation_store.h"

namespace widgets {

/// Whether an edit is made or taken back.
enum class EditDirection { Forth, Back };

/// Where an undo command makes its edit: the document as the command sees it.
class EditTarget {
public:
    using StoreCall = std::function<void(core::AnnotationStore&)>;

    /// Changes the set as `edit` or its inverse says and keeps it in the file by `call`.
    virtual void perform(const std::shared_ptr<const core::Edit>& edit, EditDirection direction, StoreCall call) = 0;
    virtual const std::string& rater() const = 0;

protected:
    ~EditTarget() = default;
};

} // namespace widgets
