// SPDX-License-Identifier: MIT
#include "core/io/hdf5/column_pickle.h"

#include <algorithm>
#include <map>

namespace core {

namespace {

// A value may hold another one many times over, which holds a third one: a pickle of a hundred bytes can stand for more
// than fits into any memory. The names of a table's columns come nowhere near these.
constexpr int kDeepest = 8;                    ///< sequences in sequences
constexpr std::size_t kMostBytes = 64'000'000; ///< of all values that are made, or copied

/// A value on the stack of the pickle's little machine.
struct Item {
    enum class Kind { Mark, Text, Sequence } kind = Kind::Text;
    std::string text;
    std::vector<Item> items;
    int depth = 0;         ///< sequences in it
    std::size_t bytes = 0; ///< of all that is in it

    void add(Item item) {
        depth = std::max(depth, item.depth + 1);
        bytes += item.bytes;
        items.push_back(std::move(item));
    }
};

void appendUtf8(std::string& text, unsigned code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xC0 | code >> 6);
        text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
        text += static_cast<char>(0xE0 | code >> 12);
        text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
        text += static_cast<char>(0x80 | (code & 0x3F));
    }
}

/// Python's "raw-unicode-escape": Latin-1, and \uXXXX for the rest.
std::string unescaped(std::string_view raw) {
    std::string text;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        unsigned code = static_cast<unsigned char>(raw[i]);
        if (raw.substr(i, 2) == "\\u" && raw.size() >= i + 6) {
            code = 0;
            for (const char digit : raw.substr(i + 2, 4))
                code = code * 16 + static_cast<unsigned>(digit <= '9' ? digit - '0' : (digit | 32) - 'a' + 10);
            i += 5;
        }
        appendUtf8(text, code & 0xFFFF);
    }
    return text;
}

class Machine {
public:
    explicit Machine(std::string_view pickle)
        : m_rest(pickle) {}

    /// The value that remains at the end; empty if the pickle holds something else.
    std::optional<Item> run() {
        while (!m_rest.empty()) {
            const char code = m_rest.front();
            m_rest.remove_prefix(1);
            if (code == '.')
                return m_stack.size() == 1 ? std::optional(m_stack.back()) : std::nullopt;
            if (!step(code) || m_bytes > kMostBytes)
                return std::nullopt;
        }
        return std::nullopt;
    }

private:
    std::string_view line() {
        const std::size_t end = std::min(m_rest.find('\n'), m_rest.size());
        const std::string_view text = m_rest.substr(0, end);
        m_rest.remove_prefix(std::min(end + 1, m_rest.size()));
        return text;
    }
    void push(Item::Kind kind, std::string text = "") {
        const std::size_t bytes = sizeof(Item) + text.size();
        m_stack.push_back({kind, std::move(text), {}, 0, bytes});
        m_bytes += bytes;
    }
    void pushText(std::string text) { push(Item::Kind::Text, std::move(text)); }
    /// A copy, if there is room for it.
    bool copy(const Item& from, Item& to) {
        m_bytes += from.bytes;
        if (m_bytes <= kMostBytes)
            to = from;
        return m_bytes <= kMostBytes;
    }

    /// Everything above the last mark becomes one list or tuple.
    bool collect() {
        std::size_t at = m_stack.size();
        while (at > 0 && m_stack[at - 1].kind != Item::Kind::Mark)
            --at;
        if (at == 0)
            return false;
        Item sequence{Item::Kind::Sequence, "", {}, 0, sizeof(Item)};
        for (std::size_t i = at; i < m_stack.size(); ++i)
            sequence.add(std::move(m_stack[i]));
        m_stack.resize(at - 1);
        m_stack.push_back(std::move(sequence));
        return m_stack.back().depth <= kDeepest;
    }
    bool append() {
        if (m_stack.size() < 2 || m_stack[m_stack.size() - 2].kind != Item::Kind::Sequence)
            return false;
        Item item = std::move(m_stack.back());
        m_stack.pop_back();
        m_stack.back().add(std::move(item));
        return m_stack.back().depth <= kDeepest;
    }
    bool recall() {
        const auto known = m_memo.find(std::string(line()));
        if (known == m_memo.end())
            return false;
        return copy(known->second, m_stack.emplace_back());
    }
    bool step(char code) {
        switch (code) {
        case '(':
            push(Item::Kind::Mark);
            return true;
        case 'l':
        case 't':
            return collect();
        case 'a':
            return append();
        case 'g':
            return recall();
        case 'p':
            if (m_stack.empty())
                return false;
            return copy(m_stack.back(), m_memo[std::string(line())]);
        case 'V':
            pushText(unescaped(line()));
            return true;
        case 'S': { // of Python 2: 'text'
            const std::string_view quoted = line();
            if (quoted.size() < 2)
                return false;
            pushText(std::string(quoted.substr(1, quoted.size() - 2)));
            return true;
        }
        case 'I':
            pushText(std::string(line()));
            return true;
        case 'N':
            pushText("");
            return true;
        default:
            return false;
        }
    }

    std::string_view m_rest;
    std::vector<Item> m_stack;
    std::map<std::string, Item> m_memo;
    std::size_t m_bytes = 0; ///< of all values that were made, or copied
};

} // namespace

std::optional<std::vector<std::vector<std::string>>> columnsOfPickle(std::string_view pickle) {
    const auto list = Machine(pickle).run();
    if (!list || list->kind != Item::Kind::Sequence)
        return std::nullopt;
    std::vector<std::vector<std::string>> columns;
    for (const Item& item : list->items) {
        std::vector<std::string> levels;
        if (item.kind == Item::Kind::Text)
            levels.push_back(item.text);
        for (const Item& level : item.items) {
            if (level.kind != Item::Kind::Text)
                return std::nullopt;
            levels.push_back(level.text);
        }
        columns.push_back(std::move(levels));
    }
    return columns;
}

} // namespace core
