// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/annotation/annotation_set.h"
#include "core/error.h"
#include "core/io/store/annotation_journal.h"

namespace core {

enum class StoreAccess {
    ReadWrite, ///< read-only if that cannot be had; see readOnlyReason
    ReadOnly
};

/// Why a store is read-only.
struct ReadOnlyReason {
    enum class Kind {
        None,        ///< it is not
        Requested,   ///< StoreAccess::ReadOnly
        OtherWindow, ///< another process writes
        ReadOnlyFolder,
        ReadOnlyFile
    };
    Kind kind = Kind::None;
    std::string holder; ///< of OtherWindow: "user@host, process 123"; empty if it does not say
};
/// In English, for messages of the command line: "opened by another window (user@host, process 123)"; empty for None.
std::string readOnlyText(const ReadOnlyReason& reason);

/// What went wrong without harm when a store was opened.
struct StoreWarning {
    enum class Kind {
        NoLocks, ///< the file system has none, so another window could write at the same time
        NoBackup ///< the newest state could not be copied to the backups
    };
    Kind kind;
    Error problem; ///< NoLocks: the file; NoBackup: what the copy failed of
};

/// The annotations of one sequence in one SQLite file (WAL). Every edit, undo and redo is one transaction that is in
/// the file before the call returns: killing the process at any moment loses at most the call in flight. The file is
/// flushed to the disk within a tenth of a second, so that a power failure costs no more than that, and a click need
/// not wait for the disk.
///
/// A file of a newer version (Error Newer), one that is not ours, damaged or only partly readable (Error BadInput,
/// naming the newest backup) is refused and left untouched. Only one process writes: a second one gets read-only access
/// and is told why. A write that fails (full disk, lost permission) throws Error(Io) and leaves file and history as
/// they were, so the same call can be tried again. Not thread-safe; different stores may be used from different
/// threads.
class AnnotationStore {
public:
    /// Opens or (with ReadWrite) creates the file, its folder too. Keeps the ten newest states in
    /// `<stem>.backups/` beside it: a state is copied when the file is opened with changes since the last copy.
    static AnnotationStore open(const std::filesystem::path& file, StoreAccess access = StoreAccess::ReadWrite);
    ~AnnotationStore();
    AnnotationStore(AnnotationStore&&) noexcept;
    AnnotationStore& operator=(AnnotationStore&&) noexcept;

    const std::filesystem::path& file() const;
    bool isReadOnly() const;
    const ReadOnlyReason& readOnlyReason() const;
    const std::vector<StoreWarning>& warnings() const;

    /// Everything that is in the file. Throws Error(BadInput) if a row makes no sense.
    AnnotationSet annotations() const;
    /// The reachable history; at most `newest` entries of each list.
    AnnotationHistory history(std::optional<int> newest = std::nullopt) const;

    /// Writes an edit and its journal entry. Throws Error(BadInput) if `before` is not what the file holds, Error(Io)
    /// if it is read-only or cannot be written. An empty edit writes nothing.
    void commit(const Edit& edit, const std::string& rater);
    /// Writes `addition` and joins it to the newest entry, as merged() does: a drag or a row of nudges is one step. If
    /// the two cancel, the entry goes. Same as commit if there is no entry to join.
    void amend(const Edit& addition, const std::string& rater);
    /// Takes the newest done entry back; returns what was applied (the inverse); empty if there is none.
    std::optional<Edit> undo();
    /// Does the last undone entry again; returns what was applied; empty if there is none.
    std::optional<Edit> redo();

    /// Called by commit, amend, undo and redo while they write, in their thread: which share of the call's rows is
    /// written, ascending, at most a hundred times per call; none: nobody is told. It must not throw.
    using WriteProgress = std::function<void(double share)>;
    void setWriteProgress(WriteProgress progress);

    /// Small settings of the sequence that belong to the annotations (order of joints, hidden cameras, ...); no
    /// history.
    std::optional<std::string> setting(const std::string& key) const;
    void setSetting(const std::string& key, const std::string& value);

    /// Copies the current state to the backups now, if it is not there yet; returns the newest backup.
    std::optional<std::filesystem::path> backup();
    /// Writes the current state with its history to a new file, complete without a log beside it,
    /// other programs that write here meanwhile. Its folder must exist. Throws Error(Io).
    void copyTo(const std::filesystem::path& file) const;

private:
    struct Impl;
    explicit AnnotationStore(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace core
