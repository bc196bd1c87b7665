// SPDX-License-Identifier: GPL-3.0-or-later
// One of the two files that include toml++, which is large and slow to compile.
#include "core/base/text.h"
#include "core/profile/profile_file.h"
#include "core/profile/setting.h"
#include "core/records/file_problems.h"

#include <QStringList>

#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <optional>
#include <span>

namespace boresight::profile {

namespace {

// Reads one parsed file into a profile and gathers everything that is wrong with it.
class Reader
{
public:
    void read(const toml::table& root)
    {
        readVersion(root);
        readTable(root, "");
        assumeTheRest();
        checkTogether();
        checkWhole();
    }

    [[nodiscard]] const Profile& profile() const { return m_profile; }

    [[nodiscard]] const records::FileProblems& problems() const { return m_problems; }

private:
    void readVersion(const toml::table& root)
    {
        const toml::node* node = root.get("version");
        const auto version = node != nullptr ? node->value_exact<std::int64_t>() : std::nullopt;
        if (!version) {
            add(node != nullptr ? node->source().begin.line : 1, "version", Text::tr("\"version = 1\" is expected"));
        } else if (*version != kVersion) {
            add(node->source().begin.line, "version",
                Text::tr("%1 is not known to this program, which reads version %2")
                    .arg(QString::number(*version), QString::number(kVersion)));
        }
    }

    void readTable(const toml::table& table, const std::string& prefix)
    {
        for (const auto& [name, node] : table) {
            const std::string key = prefix + std::string(name.str());
            const std::size_t line = name.source().begin.line;
            m_lines[key] = line;
            // "azimuth.id" in quotes is one name, not the id of [azimuth].
            if (name.str().find('.') != std::string_view::npos) {
                add(line, key, Text::tr("unknown key"));
            } else if (!readList(key, node, line)) {
                readEntry(key, node, line, prefix.empty());
            }
        }
    }

    void readEntry(const std::string& key, const toml::node& node, std::size_t line, bool isAtTop)
    {
        if (const auto* inner = node.as_table(); inner != nullptr && isAtTop) {
            readInner(*inner, key, line);
        } else if (const Setting* setting = findSetting(key)) {
            readValue(*setting, m_profile, key, node, line);
        } else if (key != "version") {
            add(line, key, Text::tr("unknown key"));
        }
    }

    // True if the key is that of a list.
    bool readList(const std::string& key, const toml::node& node, std::size_t line)
    {
        const std::size_t problemsBefore = m_problems.count();
        if (key == kHorizonKey) {
            readHorizon(node, line);
        } else if (key == kKeepOutKey) {
            readRows(key, node, line, keepOutSettings(), m_profile.limits.keepOuts);
        } else if (key == kPresetKey) {
            readRows(key, node, line, presetSettings(), m_profile.presets);
        } else if (key == kSatelliteKey) {
            readRows(key, node, line, satelliteSettings(), m_profile.satellites);
        } else if (key == kAntennaKey) {
            readRows(key, node, line, antennaSettings(), m_profile.antennas);
        } else if (key == kWatchKey) {
            readRows(key, node, line, watchSettings(), m_profile.schedule.watch);
        } else {
            return false;
        }
        if (m_problems.count() != problemsBefore) {
            m_unreadLists.push_back(key);
        }
        return true;
    }

    void readInner(const toml::table& table, const std::string& name, std::size_t line)
    {
        const auto all = settings();
        const bool known = std::any_of(all.begin(), all.end(),
                                       [&](const Setting& setting) { return setting.key.starts_with(name + "."); });
        if (known) {
            readTable(table, name + ".");
        } else {
            add(line, name, Text::tr("unknown table"));
        }
    }

    template <class Row>
    void readRows(const std::string& key, const toml::node& node, std::size_t line,
                  std::span<const SettingOf<Row>> fields, std::vector<Row>& rows)
    {
        const toml::array* list = node.as_array();
        if (list == nullptr) {
            add(line, key, Text::tr("\"[[%1]]\" is expected").arg(toQString(key)));
            return;
        }
        for (const toml::node& one : *list) {
            const std::string rowKey = key + "[" + std::to_string(rows.size() + 1) + "]";
            m_lines[rowKey] = one.source().begin.line;
            readRow(rowKey, one, fields, rows.emplace_back());
        }
    }

    template <class Row>
    void readRow(const std::string& rowKey, const toml::node& node, std::span<const SettingOf<Row>> fields, Row& row)
    {
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            add(node.source().begin.line, rowKey, Text::tr("a table is expected"));
            return;
        }
        for (const auto& [name, value] : *table) {
            const std::string key = rowKey + "." + std::string(name.str());
            const std::size_t line = name.source().begin.line;
            m_lines[key] = line;
            const auto field = std::find_if(fields.begin(), fields.end(),
                                            [&](const SettingOf<Row>& one) { return one.key == name.str(); });
            if (field != fields.end()) {
                readValue(*field, row, key, value, line);
            } else {
                add(line, key, Text::tr("unknown key"));
            }
        }
        std::vector<std::string> missing;
        for (const SettingOf<Row>& field : fields) {
            if (!table->contains(field.key) && !field.mayBeLeftOut) {
                missing.push_back(field.key);
            }
        }
        addMissing(node.source().begin.line, rowKey, missing);
    }

    void readHorizon(const toml::node& node, std::size_t line)
    {
        const toml::array* points = node.as_array();
        if (points == nullptr) {
            add(line, std::string(kHorizonKey),
                Text::tr("a list of points is expected, like [[0.0, 5.0], [180.0, 2.5]]"));
            return;
        }
        const auto fields = horizonSettings();
        for (const toml::node& one : *points) {
            auto& row = m_profile.limits.horizon.emplace_back();
            const std::string key =
                std::string(kHorizonKey) + "[" + std::to_string(m_profile.limits.horizon.size()) + "]";
            const std::size_t pointLine = one.source().begin.line;
            m_lines[key] = pointLine;
            const toml::array* point = one.as_array();
            if (point == nullptr || point->size() != fields.size()) {
                add(pointLine, key, Text::tr("a point is [azimuth, elevation]"));
                continue;
            }
            for (std::size_t i = 0; i < fields.size(); ++i) {
                readValue(fields[i], row, key, (*point)[i], pointLine);
            }
        }
    }

    template <class Owner>
    void readValue(const SettingOf<Owner>& setting, Owner& owner, const std::string& key, const toml::node& node,
                   std::size_t line)
    {
        const std::optional<SettingValue> value = plainValue(node);
        if (!value) {
            add(line, key, Text::tr("a number or a text in quotes is expected"));
            return;
        }
        if (const auto done = setting.set(owner, *value); !done) {
            add(line, key, done.error().text);
        }
    }

    static std::optional<SettingValue> plainValue(const toml::node& node)
    {
        if (const auto* text = node.as_string()) {
            return text->get();
        }
        if (const auto* whole = node.as_integer()) {
            return whole->get();
        }
        if (const auto* real = node.as_floating_point()) {
            return real->get();
        }
        return textList(node);
    }

    static std::optional<SettingValue> textList(const toml::node& node)
    {
        const toml::array* list = node.as_array();
        if (list == nullptr) {
            return std::nullopt;
        }
        TextList texts;
        for (const toml::node& one : *list) {
            const auto* text = one.as_string();
            if (text == nullptr) {
                return std::nullopt;
            }
            texts.push_back(text->get());
        }
        return texts;
    }

    // Sets the keys that the file leaves out and whose default depends on other settings.
    void assumeTheRest()
    {
        for (const Setting& setting : settings()) {
            if (setting.assume && !m_lines.contains(setting.key)) {
                setting.assume(m_profile);
            }
        }
    }

    // Checks the tables whose keys must be given all together or not at all.
    void checkTogether()
    {
        std::map<std::string, std::vector<std::string>> missing;
        for (const Setting& setting : settings()) {
            if (setting.isGiven && setting.isGiven(m_profile) && !m_lines.contains(setting.key)) {
                const auto dot = setting.key.find('.');
                missing[setting.key.substr(0, dot)].push_back(setting.key.substr(dot + 1));
            }
        }
        for (const auto& [table, keys] : missing) {
            addMissing(lineOf(table), table, keys);
        }
    }

    void checkWhole()
    {
        for (const Problem& problem : crossCheck(m_profile)) {
            // The error of an unread row was already reported, so its list is not checked again.
            const bool isUnread = std::any_of(m_unreadLists.begin(), m_unreadLists.end(),
                                              [&](const std::string& list) { return problem.key.starts_with(list); });
            if (!isUnread) {
                add(lineOf(problem.key), problem.key,
                    problem.advice.isEmpty() ? problem.text : problem.text + QStringLiteral(". ") + problem.advice);
            }
        }
    }

    // The line of the key, or else of its row or table, or else the first line: a default value can conflict with a
    // value elsewhere in the file.
    [[nodiscard]] std::size_t lineOf(const std::string& key) const
    {
        for (std::size_t end = key.size(); end != std::string::npos; end = key.find_last_of(".[", end - 1)) {
            if (const auto found = m_lines.find(key.substr(0, end)); found != m_lines.end()) {
                return found->second;
            }
        }
        return 1;
    }

    void addMissing(std::size_t line, const std::string& table, const std::vector<std::string>& keys)
    {
        if (keys.empty()) {
            return;
        }
        QStringList list;
        for (const std::string& key : keys) {
            list << toQString(key);
        }
        add(line, table,
            Text::tr("missing: %1. The keys of this table are only valid together.")
                .arg(list.join(QStringLiteral(", "))));
    }

    void add(std::size_t line, const std::string& key, const QString& reason)
    {
        m_problems.add(line, toText(Problem{key, reason}));
    }

    Profile m_profile;
    std::map<std::string, std::size_t> m_lines;  // line of each key, table and row of the file
    std::vector<std::string> m_unreadLists;
    records::FileProblems m_problems;
};

}  // namespace

Result<Profile> parseProfile(std::string_view text, const QString& fileName)
{
    Reader reader;
    records::FileProblems problems;
    try {
        reader.read(toml::parse(text));
        problems = reader.problems();
    } catch (const toml::parse_error& error) {
        problems.add(error.source().begin.line, toQString(error.description()));
    }
    if (problems.count() > 0) {
        return failure(ErrorCode::InvalidInput, problems.text(fileName));
    }
    return reader.profile();
}

}  // namespace boresight::profile
