// SPDX-License-Identifier: MIT
#include "core/io/annotation_store.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <fstream>
#include <limits>

#include "core/error.h"
#include "core/io/annotation_backups.h"
#include "core/io/annotation_tables.h"
#include "core/io/atomic_file.h"
#include "core/io/file_flusher.h"
#include "core/io/file_lock.h"

namespace core {

namespace fs = std::filesystem;

std::string utcTimestamp() {
    const auto now = std::chrono::system_clock::now();
    const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count() % 1000;
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    std::array<char, 40> text{};
    const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &utc);
    const std::string fraction = std::to_string(1000 + ms).substr(1);
    return std::string(text.data(), size) + "." + fraction + "Z";
}

namespace {

std::string adviceFor(const fs::path& file) {
    const auto backups = backupsOf(file);
    return backups.empty() ? "; there is no backup" : "; the newest backup is " + backups.front().string();
}

Error damaged(const fs::path& file, const std::string& detail) {
    return {ErrorCode::BadInput, file.string(), "", detail + adviceFor(file)};
}

/// What SQLite says, as one of our errors.
Error translated(const SQLite::Exception& problem, const fs::path& file) {
    switch (problem.getErrorCode()) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR:    // a table or column is missing
    case SQLITE_MISMATCH:
    case SQLITE_CONSTRAINT:
        return damaged(file, std::string("is damaged (") + problem.what() + ")");
    case SQLITE_FULL:
        return {ErrorCode::Io, file.string(), "", "cannot be written: the disk is full"};
    case SQLITE_READONLY:
    case SQLITE_PERM:
        return {ErrorCode::Io, file.string(), "", "cannot be written: file or folder is read-only"};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return {ErrorCode::Io, file.string(), "", "is in use by another program"};
    default:
        return {ErrorCode::Io, file.string(), "", std::string("cannot be read or written: ") + problem.what()};
    }
}

fs::path sideFile(const fs::path& file, const char* suffix) { return file.string() + suffix; }

std::uint32_t bigEndian(const unsigned char* bytes) {
    return std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 | std::uint32_t(bytes[2]) << 8 | bytes[3];
}

void checkVersion(const fs::path& file, long long applicationId, long long version) {
    if (applicationId != kAnnotationApplicationId) {
        throw Error(ErrorCode::BadInput, file.string(), "", "is an SQLite file, but not one with annotations");
    }
    if (version > kAnnotationVersion) {
        throw Error(ErrorCode::Newer, file.string(), "version",
                    std::to_string(version) + " was written by a newer Handlens; this one reads up to " + std::to_string(kAnnotationVersion));
    }
    if (version < 1) {
        throw damaged(file, "has no valid version");
    }
}

/// Looks at the first bytes without SQLite, which might write.
void checkHeader(const fs::path& file) {
    std::array<char, 100> header{};
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw Error(ErrorCode::Io, file.string(), "", "cannot be read");
    }
    stream.read(header.data(), header.size());
    if (stream.gcount() == 0) {
        throw damaged(file, "is empty: it has lost its content");
    }
    constexpr std::string_view kMagic("SQLite format 3\0", 16);
    if (stream.gcount() < 100 || std::string_view(header.data(), 16) != kMagic) {
        throw damaged(file, "is not an annotation file, or is cut off");
    }
    const auto* bytes = reinterpret_cast<const unsigned char*>(header.data());
    checkVersion(file, bigEndian(bytes + 68), bigEndian(bytes + 60));
}

/// SQLite's own check of every page and of the constraints; then the version once more, which may still be in the log.
void checkContent(SQLite::Database& database, const fs::path& file) {
    SQLite::Statement check(database, "PRAGMA integrity_check(1)");
    const std::string verdict = check.executeStep() ? check.getColumn(0).getString() : "no answer";
    if (verdict != "ok") {
        throw damaged(file, "is damaged (" + verdict + ")");
    }
    checkVersion(file, database.execAndGet("PRAGMA application_id").getInt64(), database.execAndGet("PRAGMA user_version").getInt64());
    constexpr int kTables = 7;
    const int tables = database.execAndGet("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name IN ('mark', 'note', 'journal', "
                                           "'mark_change', 'note_change', 'setting', 'counter')").getInt();
    if (tables != kTables) {
        throw damaged(file, "lacks a table");
    }
    for (const auto& [table, condition] : AnnotationTables::rowConditions()) {
        SQLite::Statement odd(database, "SELECT 1 FROM " + table + " WHERE (" + condition + ") IS NOT TRUE LIMIT 1");
        if (odd.executeStep()) {
            throw damaged(file, "is damaged (a row of table " + table + " makes no sense)");
        }
    }
}

/// A new file with empty tables, there all at once.
void createFile(const fs::path& file) {
    if (fs::exists(sideFile(file, "-wal"))) {
        throw Error(ErrorCode::BadInput, file.string(), "",
                    "is gone, but its log " + sideFile(file, "-wal").string() + " is there: bring the file back, or move the log away" + adviceFor(file));
    }
    const fs::path pending = sideFile(file, (".part-" + std::to_string(::getpid())).c_str());
    std::error_code ignored;
    try {
        {
            SQLite::Database database(pending.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
            database.exec("PRAGMA journal_mode = WAL");
            AnnotationTables::create(database);
        }
        fs::rename(pending, file);
    } catch (const fs::filesystem_error& problem) {
        fs::remove(pending, ignored);
        throw Error(ErrorCode::Io, file.string(), "", "cannot be written: " + problem.code().message());
    } catch (...) {
        for (const char* suffix : {"", "-wal", "-shm"}) {
            fs::remove(sideFile(pending, suffix), ignored);
        }
        throw;
    }
}

bool isWritable(const fs::path& path) { return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0; }

/// A folder for copies that goes with the store.
class TemporaryCopy {
public:
    TemporaryCopy() = default;
    /// Copies the file and its log.
    explicit TemporaryCopy(const fs::path& file) {
        std::string name = (fs::temp_directory_path() / "handlens-XXXXXX").string();
        if (!::mkdtemp(name.data())) {
            throw Error(ErrorCode::Io, name, "", "cannot be created");
        }
        m_folder = name;
        m_file = m_folder / file.filename();
        fs::copy_file(file, m_file);
        fs::copy_file(sideFile(file, "-wal"), sideFile(m_file, "-wal"));
    }
    TemporaryCopy(TemporaryCopy&& other) noexcept { std::swap(m_folder, other.m_folder); std::swap(m_file, other.m_file); }
    TemporaryCopy& operator=(TemporaryCopy&& other) noexcept {
        std::swap(m_folder, other.m_folder);
        std::swap(m_file, other.m_file);
        return *this;
    }
    ~TemporaryCopy() {
        std::error_code ignored;
        if (!m_folder.empty()) {
            fs::remove_all(m_folder, ignored);
        }
    }
    const fs::path& file() const { return m_file; }

private:
    fs::path m_folder, m_file;
};

} // namespace

struct AnnotationStore::Impl {
    fs::path file;
    FileLock lock;
    TemporaryCopy copy;
    std::unique_ptr<FileFlusher> flusher;
    std::unique_ptr<SQLite::Database> database;
    std::unique_ptr<AnnotationTables> tables;
    bool isReadOnly = true;
    std::string readOnlyReason;
    std::vector<std::string> warnings;
    ino_t inode = 0;

    void decideAccess(StoreAccess access);
    void openReadOnly();
    void openForWriting();
    void requireWritable() const;
    /// Runs changes as one durable transaction.
    template <typename Work>
    void transact(Work&& work);
    /// Moves the newest done or oldest undone entry to the other side.
    std::optional<Edit> flip(EntryState from);
};

void AnnotationStore::Impl::decideAccess(StoreAccess access) {
    if (access == StoreAccess::ReadOnly) {
        readOnlyReason = "opened for reading only";
        return;
    }
    lock = FileLock(file.parent_path() / ("." + file.filename().string() + ".lock"));
    if (lock.state() == FileLock::State::HeldByOther) {
        readOnlyReason = "opened by another window" + (lock.holder().empty() ? "" : " (" + lock.holder() + ")");
    } else if (lock.state() == FileLock::State::NotPermitted || !isWritable(file.parent_path().empty() ? "." : file.parent_path())) {
        readOnlyReason = "the folder is read-only";
    } else if (fs::exists(file) && !isWritable(file)) {
        readOnlyReason = "the file is read-only";
    } else {
        isReadOnly = false;
    }
    if (lock.state() == FileLock::State::NotSupported) {
        warnings.push_back("this file system has no locks: make sure that no other window has " + file.string() + " open");
    }
}

void AnnotationStore::Impl::openReadOnly() {
    const bool canShare = isWritable(file.parent_path().empty() ? "." : file.parent_path());
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
        for (const char c : fs::absolute(file).string()) {
            escaped += c == '%' ? "%25" : c == '?' ? "%3f" : c == '#' ? "%23" : std::string(1, c);
        }
        name = "file:" + escaped + "?immutable=1";
        flags |= SQLite::OPEN_URI;
    }
    database = std::make_unique<SQLite::Database>(name, flags);
    database->setBusyTimeout(2000);
    checkContent(*database, file);
}

void AnnotationStore::Impl::openForWriting() {
    database = std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READWRITE);
    database->setBusyTimeout(2000);
    database->exec("PRAGMA journal_mode = WAL");
    // Commits survive the end of the process at once, and a failure of the machine as soon as the log is flushed.
    database->exec("PRAGMA synchronous = NORMAL");
    flusher = std::make_unique<FileFlusher>(sideFile(file, "-wal"));
    struct stat status{};
    ::stat(file.c_str(), &status);
    inode = status.st_ino;
}

AnnotationStore AnnotationStore::open(const fs::path& file, StoreAccess access) {
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    try {
        if (access == StoreAccess::ReadWrite && !file.parent_path().empty()) {
            ensureFolder(file.parent_path());
        }
        impl->decideAccess(access);
        if (!fs::exists(file)) {
            if (impl->isReadOnly) {
                throw Error(access == StoreAccess::ReadOnly ? ErrorCode::NotFound : ErrorCode::Io, file.string(), "",
                            access == StoreAccess::ReadOnly ? "there is no such file" : "cannot be created: " + impl->readOnlyReason);
            }
            createFile(file);
        }
        checkHeader(file);
        impl->openReadOnly();
        if (!impl->isReadOnly) {
            impl->openForWriting();
        }
        impl->tables = std::make_unique<AnnotationTables>(*impl->database, file.string());
    } catch (const SQLite::Exception& problem) {
        throw translated(problem, file);
    } catch (const fs::filesystem_error& problem) {
        throw Error(ErrorCode::Io, file.string(), "", problem.code().message());
    }
    AnnotationStore store(std::move(impl));
    try {
        store.backup();
    } catch (const Error& problem) {
        store.m_impl->warnings.emplace_back(problem.what());
    }
    return store;
}

AnnotationStore::AnnotationStore(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
AnnotationStore::AnnotationStore(AnnotationStore&&) noexcept = default;
AnnotationStore& AnnotationStore::operator=(AnnotationStore&&) noexcept = default;
AnnotationStore::~AnnotationStore() = default;

const fs::path& AnnotationStore::file() const { return m_impl->file; }
bool AnnotationStore::isReadOnly() const { return m_impl->isReadOnly; }
const std::string& AnnotationStore::readOnlyReason() const { return m_impl->readOnlyReason; }
const std::vector<std::string>& AnnotationStore::warnings() const { return m_impl->warnings; }

namespace {

/// Calls and turns what SQLite throws into our errors.
template <typename Work>
auto guarded(const fs::path& file, Work&& work) {
    try {
        return work();
    } catch (const SQLite::Exception& problem) {
        throw translated(problem, file);
    }
}

constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

} // namespace

AnnotationSet AnnotationStore::annotations() const {
    return guarded(m_impl->file, [this] { return m_impl->tables->readSet(); });
}

AnnotationHistory AnnotationStore::history(std::optional<int> newest) const {
    return guarded(m_impl->file, [this, newest] {
        AnnotationTables& tables = *m_impl->tables;
        AnnotationHistory history;
        const auto first = newest && *newest > 0 ? tables.newestEntry(EntryState::Done, *newest - 1) : std::nullopt;
        history.done = tables.readEntries(EntryState::Done, first.value_or(0), kNoLimit);
        history.undone = tables.readEntries(EntryState::Undone, 0, kNoLimit);
        std::reverse(history.undone.begin(), history.undone.end());
        if (newest && history.undone.size() > static_cast<std::size_t>(*newest)) {
            history.undone.erase(history.undone.begin(), history.undone.end() - *newest);
        }
        return history;
    });
}

void AnnotationStore::Impl::requireWritable() const {
    if (isReadOnly) {
        throw Error(ErrorCode::Io, file.string(), "", "is read-only here: " + readOnlyReason);
    }
    struct stat status{};
    if (::stat(file.c_str(), &status) != 0 || status.st_ino != inode) {
        throw Error(ErrorCode::Io, file.string(), "", "was moved, replaced or deleted while it was open");
    }
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
    if (edit.empty()) {
        return;
    }
    m_impl->transact([&](AnnotationTables& tables) {
        const std::string time = utcTimestamp();
        tables.applyEdit(edit, rater, time);
        tables.abandonUndone();
        tables.addEntry(edit, rater, time);
    });
}

void AnnotationStore::amend(const Edit& addition, const std::string& rater) {
    if (addition.empty()) {
        return;
    }
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
        if (joined.empty()) {
            tables.removeEntry(*newest);
        } else {
            tables.replaceEntry(*newest, joined, time);
        }
    });
}

std::optional<Edit> AnnotationStore::Impl::flip(EntryState from) {
    std::optional<Edit> applied;
    const bool isUndo = from == EntryState::Done;
    requireWritable();
    const auto id = guarded(file, [&] { return isUndo ? tables->newestEntry(from) : tables->oldestEntry(from); });
    if (!id) {
        return applied;
    }
    transact([&](AnnotationTables& work) {
        const JournalEntry entry = work.readEntries(from, *id, *id).front();
        applied = isUndo ? inverse(entry.edit) : entry.edit;
        work.applyEdit(*applied, entry.rater, utcTimestamp());
        work.setEntryState(*id, isUndo ? EntryState::Undone : EntryState::Done);
    });
    return applied;
}

std::optional<Edit> AnnotationStore::undo() { return m_impl->flip(EntryState::Done); }
std::optional<Edit> AnnotationStore::redo() { return m_impl->flip(EntryState::Undone); }

std::optional<std::string> AnnotationStore::setting(const std::string& key) const {
    return guarded(m_impl->file, [&] { return m_impl->tables->setting(key); });
}

void AnnotationStore::setSetting(const std::string& key, const std::string& value) {
    m_impl->transact([&](AnnotationTables& tables) { tables.setSetting(key, value); });
}

std::optional<fs::path> AnnotationStore::backup() {
    if (m_impl->isReadOnly) {
        const auto backups = backupsOf(m_impl->file);
        return backups.empty() ? std::nullopt : std::optional(backups.front());
    }
    return guarded(m_impl->file, [this] { return backUp(*m_impl->database, m_impl->file, m_impl->tables->changeCount()); });
}

} // namespace core
