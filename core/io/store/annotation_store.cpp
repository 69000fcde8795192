// SPDX-License-Identifier: MIT
#include "core/io/store/annotation_store.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "core/io/files/atomic_file.h"
#include "core/io/files/file_flusher.h"
#include "core/io/files/file_lock.h"
#include "core/io/store/annotation_backups.h"
#include "core/io/store/annotation_database.h"
#include "core/io/store/annotation_schema.h"
#include "core/io/store/annotation_tables.h"

namespace core {

namespace fs = std::filesystem;

std::string readOnlyText(const ReadOnlyReason& reason) {
    switch (reason.kind) {
    case ReadOnlyReason::Kind::Requested:
        return "opened for reading only";
    case ReadOnlyReason::Kind::OtherWindow:
        return "opened by another window" + (reason.holder.empty() ? "" : " (" + reason.holder + ")");
    case ReadOnlyReason::Kind::ReadOnlyFolder:
        return "the folder is read-only";
    case ReadOnlyReason::Kind::ReadOnlyFile:
        return "the file is read-only";
    case ReadOnlyReason::Kind::None:
        break;
    }
    return "";
}

struct AnnotationStore::Impl {
    fs::path file;
    FileLock lock;
    TemporaryCopy copy;
    std::unique_ptr<FileFlusher> flusher;
    std::unique_ptr<SQLite::Database> database;
    std::unique_ptr<AnnotationTables> tables;
    bool isReadOnly = true;
    ReadOnlyReason readOnlyReason;
    std::vector<StoreWarning> warnings;
    ino_t inode = 0;
    WriteProgress progress;

    void decideAccess(StoreAccess access);
    void openReadOnly();
    void openForWriting();
    void requireWritable() const;
    /// Tells the progress of the writing that follows.
    void expectMarks(std::size_t rows);
    /// Runs changes as one durable transaction.
    template <typename Work>
    void transact(Work&& work);
    /// Moves the newest done or oldest undone entry to the other side.
    std::optional<Edit> flip(EntryState from);
};

void AnnotationStore::Impl::decideAccess(StoreAccess access) {
    if (access == StoreAccess::ReadOnly) {
        readOnlyReason.kind = ReadOnlyReason::Kind::Requested;
        return;
    }
    lock = FileLock(file.parent_path() / ("." + file.filename().string() + ".lock"));
    if (lock.state() == FileLock::State::HeldByOther)
        readOnlyReason = {ReadOnlyReason::Kind::OtherWindow, lock.holder()};
    else if (lock.state() == FileLock::State::NotPermitted ||
             !isWritablePath(file.parent_path().empty() ? "." : file.parent_path()))
        readOnlyReason.kind = ReadOnlyReason::Kind::ReadOnlyFolder;
    else if (fs::exists(file) && !isWritablePath(file))
        readOnlyReason.kind = ReadOnlyReason::Kind::ReadOnlyFile;
    else
        isReadOnly = false;
    if (lock.state() == FileLock::State::NotSupported)
        warnings.push_back(
            {StoreWarning::Kind::NoLocks, Error(ErrorCode::Io, file.string(), "", "the file system has no locks")});
}

void AnnotationStore::Impl::openReadOnly() {
    const bool canShare = isWritablePath(file.parent_path().empty() ? "." : file.parent_path());
    std::error_code ignored;
    const fs::path log = sideFile(file, "-wal");
    const bool hasLog = fs::exists(log, ignored) && fs::file_size(log, ignored) > 0;
    std::string name = file.string();
    int flags = SQLite::OPEN_READONLY;
    if (!canShare && hasLog) {
        // Reading a log needs a shared index beside it, which cannot be made there.
        copy = TemporaryCopy(file);
        name = copy.file().string();
    } else if (!canShare) {
        std::string escaped;
        for (const char c : fs::absolute(file).string())
            escaped += c == '%' ? "%25" : c == '?' ? "%3f" : c == '#' ? "%23" : std::string(1, c);
        name = "file:" + escaped + "?immutable=1";
        flags |= SQLite::OPEN_URI;
    }
    database = std::make_unique<SQLite::Database>(name, flags);
    database->setBusyTimeout(2000);
    checkDatabaseContent(*database, file);
}

void AnnotationStore::Impl::openForWriting() {
    database = std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READWRITE);
    database->setBusyTimeout(2000);
    database->exec("PRAGMA journal_mode = WAL");
    // Commits survive the end of the process at once, and a failure of the machine as soon as the log is flushed.
    database->exec("PRAGMA synchronous = NORMAL");
    if (isOlderVersion(*database)) {
        backUp(*database, file, AnnotationTables(*database, file.string()).changeCount());
        upgradeAnnotationTables(*database);
    }
    flusher = std::make_unique<FileFlusher>(sideFile(file, "-wal"));
    struct stat status {};
    ::stat(file.c_str(), &status);
    inode = status.st_ino;
}

AnnotationStore AnnotationStore::open(const fs::path& file, StoreAccess access) {
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    try {
        if (access == StoreAccess::ReadWrite && !file.parent_path().empty())
            ensureFolder(file.parent_path());
        impl->decideAccess(access);
        if (!fs::exists(file)) {
            if (impl->isReadOnly) {
                throw Error(access == StoreAccess::ReadOnly ? ErrorCode::NotFound : ErrorCode::Io, file.string(), "",
                            access == StoreAccess::ReadOnly
                                ? "there is no such file"
                                : "cannot be created: " + readOnlyText(impl->readOnlyReason));
            }
            createDatabaseFile(file);
        }
        checkDatabaseHeader(file);
        impl->openReadOnly();
        if (!impl->isReadOnly)
            impl->openForWriting();
        impl->tables = std::make_unique<AnnotationTables>(*impl->database, file.string());
    } catch (const SQLite::Exception& problem) {
        throw translatedError(problem, file);
    } catch (const fs::filesystem_error& problem) {
        throw Error(ErrorCode::Io, file.string(), "", problem.code().message());
    }
    AnnotationStore store(std::move(impl));
    try {
        store.backup();
    } catch (const Error& problem) {
        store.m_impl->warnings.push_back({StoreWarning::Kind::NoBackup, problem});
    }
    return store;
}

AnnotationStore::AnnotationStore(std::unique_ptr<Impl> impl)
    : m_impl(std::move(impl)) {}
AnnotationStore::AnnotationStore(AnnotationStore&&) noexcept = default;
AnnotationStore& AnnotationStore::operator=(AnnotationStore&&) noexcept = default;
AnnotationStore::~AnnotationStore() = default;

const fs::path& AnnotationStore::file() const {
    return m_impl->file;
}
bool AnnotationStore::isReadOnly() const {
    return m_impl->isReadOnly;
}
const ReadOnlyReason& AnnotationStore::readOnlyReason() const {
    return m_impl->readOnlyReason;
}
const std::vector<StoreWarning>& AnnotationStore::warnings() const {
    return m_impl->warnings;
}

namespace {

/// Calls and turns what SQLite throws into our errors.
template <typename Work>
auto guarded(const fs::path& file, Work&& work) {
    try {
        return work();
    } catch (const SQLite::Exception& problem) {
        throw translatedError(problem, file);
    }
}

constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

} // namespace

AnnotationSet AnnotationStore::annotations() const {
    return guarded(
        m_impl->file, [this] { return m_impl->tables->readSet(); });
}

AnnotationHistory AnnotationStore::history(std::optional<int> newest) const {
    return guarded(
        m_impl->file,
        [this, newest] {
            AnnotationTables& tables = *m_impl->tables;
            AnnotationHistory history;
            const auto first = newest && *newest > 0 ? tables.newestEntry(EntryState::Done, *newest - 1) : std::nullopt;
            history.done = tables.readEntries(EntryState::Done, first.value_or(0), kNoLimit);
            history.undone = tables.readEntries(EntryState::Undone, 0, kNoLimit);
            std::reverse(history.undone.begin(), history.undone.end());
            if (newest && history.undone.size() > static_cast<std::size_t>(*newest))
                history.undone.erase(history.undone.begin(), history.undone.end() - *newest);
            return history;
        });
}

void AnnotationStore::Impl::requireWritable() const {
    if (isReadOnly)
        throw Error(ErrorCode::Io, file.string(), "", "is read-only here: " + readOnlyText(readOnlyReason));
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0 || status.st_ino != inode)
        throw Error(ErrorCode::Io, file.string(), "", "was moved, replaced or deleted while it was open");
}

void AnnotationStore::Impl::expectMarks(std::size_t rows) {
    if (!progress || rows == 0) {
        tables->setMarkWritten({});
        return;
    }
    tables->setMarkWritten([this, rows, written = std::size_t{0}, told = std::size_t{0}]() mutable {
        const std::size_t percent = std::min<std::size_t>(100, 100 * ++written / rows);
        if (percent > told)
            progress(static_cast<double>(told = percent) / 100);
    });
}

template <typename Work>
void AnnotationStore::Impl::transact(Work&& work) {
    requireWritable();
    guarded(file, [&] {
        SQLite::Transaction transaction(*database, SQLite::TransactionBehavior::IMMEDIATE);
        work(*tables);
        tables->countChange();
        transaction.commit();
    });
    flusher->request();
}

void AnnotationStore::commit(const Edit& edit, const std::string& rater) {
    if (edit.empty())
        return;
    m_impl->expectMarks(2 * edit.marks.size());
    m_impl->transact([&](AnnotationTables& tables) {
        const std::string time = utcTimestamp();
        tables.applyEdit(edit, rater, time);
        tables.abandonUndone();
        tables.addEntry(edit, rater, time);
    });
}

void AnnotationStore::amend(const Edit& addition, const std::string& rater) {
    if (addition.empty())
        return;
    m_impl->expectMarks(2 * addition.marks.size());
    m_impl->transact([&](AnnotationTables& tables) {
        const std::string time = utcTimestamp();
        tables.applyEdit(addition, rater, time);
        const auto newest = tables.newestEntry(EntryState::Done);
        if (!newest || tables.newestEntry(EntryState::Undone)) {
            tables.abandonUndone();
            tables.addEntry(addition, rater, time);
            return;
        }
        const Edit joined = merged(tables.readEntries(EntryState::Done, *newest, *newest).front().edit, addition);
        if (joined.empty())
            tables.removeEntry(*newest);
        else
            tables.replaceEntry(*newest, joined, time);
    });
}

std::optional<Edit> AnnotationStore::Impl::flip(EntryState from) {
    std::optional<Edit> applied;
    const bool isUndo = from == EntryState::Done;
    requireWritable();
    const auto id = guarded(file, [&] { return isUndo ? tables->newestEntry(from) : tables->oldestEntry(from); });
    if (!id)
        return applied;
    transact([&](AnnotationTables& work) {
        const JournalEntry entry = work.readEntries(from, *id, *id).front();
        applied = isUndo ? inverse(entry.edit) : entry.edit;
        expectMarks(applied->marks.size());
        work.applyEdit(*applied, entry.rater, utcTimestamp());
        work.setEntryState(*id, isUndo ? EntryState::Undone : EntryState::Done);
    });
    return applied;
}

std::optional<Edit> AnnotationStore::undo() {
    return m_impl->flip(EntryState::Done);
}
std::optional<Edit> AnnotationStore::redo() {
    return m_impl->flip(EntryState::Undone);
}

void AnnotationStore::setWriteProgress(WriteProgress progress) {
    m_impl->progress = std::move(progress);
}

std::optional<std::string> AnnotationStore::setting(const std::string& key) const {
    return guarded(
        m_impl->file, [&] { return m_impl->tables->setting(key); });
}

void AnnotationStore::setSetting(const std::string& key, const std::string& value) {
    m_impl->transact([&](AnnotationTables& tables) { tables.setSetting(key, value); });
}

std::optional<fs::path> AnnotationStore::backup() {
    if (m_impl->isReadOnly) {
        const auto backups = backupsOf(m_impl->file);
        return backups.empty() ? std::nullopt : std::optional(backups.front());
    }
    return guarded(m_impl->file,
                   [this] { return backUp(*m_impl->database, m_impl->file, m_impl->tables->changeCount()); });
}

void AnnotationStore::copyTo(const fs::path& file) const {
    copyDatabase(*m_impl->database, file);
}

} // namespace core
