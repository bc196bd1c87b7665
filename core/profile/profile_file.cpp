// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes toml++: it is large and slow to compile.
#include "core/profile/profile_file.h"

#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/profile/setting.h"

#include <QFile>
#include <QSaveFile>

#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace boresight::profile {

namespace {

struct FileProblem
{
    std::size_t line = 0;
    std::string text;
};

// Reads one parsed file into a profile and gathers everything that is wrong with it.
class Reader
{
public:
    void read(const toml::table& root)
    {
        readVersion(root);
        readTable(root, "");
        checkWhole();
    }

    [[nodiscard]] const Profile& profile() const { return m_profile; }

    [[nodiscard]] std::vector<FileProblem> problems() const
    {
        std::vector<FileProblem> sorted = m_problems;
        std::stable_sort(sorted.begin(), sorted.end(),
                         [](const FileProblem& a, const FileProblem& b) { return a.line < b.line; });
        return sorted;
    }

private:
    void readVersion(const toml::table& root)
    {
        const toml::node* node = root.get("version");
        const auto version = node != nullptr ? node->value_exact<std::int64_t>() : std::nullopt;
        if (!version) {
            add(node != nullptr ? node->source().begin.line : 1, "version", "\"version = 1\" is expected");
        } else if (*version != kVersion) {
            add(node->source().begin.line, "version",
                std::to_string(*version) + " is not known to this program, which reads version " +
                    std::to_string(kVersion));
        }
    }

    void readTable(const toml::table& table, const std::string& prefix)
    {
        for (const auto& [name, node] : table) {
            const std::string key = prefix + std::string(name.str());
            const std::size_t line = name.source().begin.line;
            if (const auto* inner = node.as_table(); inner != nullptr && prefix.empty()) {
                m_lines[key] = line;
                readInner(*inner, key, line);
            } else if (const Setting* setting = findSetting(key)) {
                readValue(*setting, node, line);
            } else if (key != "version") {
                add(line, key, "unknown key");
            }
        }
    }

    void readInner(const toml::table& table, const std::string& name, std::size_t line)
    {
        const auto all = settings();
        const bool known = std::any_of(all.begin(), all.end(),
                                       [&](const Setting& setting) { return setting.key.starts_with(name + "."); });
        if (known) {
            readTable(table, name + ".");
        } else {
            add(line, name, "unknown table");
        }
    }

    void readValue(const Setting& setting, const toml::node& node, std::size_t line)
    {
        m_lines[setting.key] = line;
        const std::optional<SettingValue> value = plainValue(node);
        if (!value) {
            add(line, setting.key, "a number or a text in quotes is expected");
            return;
        }
        if (const auto done = setting.set(m_profile, *value); !done) {
            add(line, setting.key, done.error().text);
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
        return std::nullopt;
    }

    void checkWhole()
    {
        for (const Problem& problem : crossCheck(m_profile)) {
            add(lineOf(problem.key), problem.key, problem.text);
        }
    }

    // Of the key, else of its table, else the first: a default can clash with what the file says elsewhere.
    [[nodiscard]] std::size_t lineOf(const std::string& key) const
    {
        for (const std::string& name : {key, key.substr(0, key.find('.'))}) {
            if (const auto found = m_lines.find(name); found != m_lines.end()) {
                return found->second;
            }
        }
        return 1;
    }

    void add(std::size_t line, const std::string& key, const std::string& reason)
    {
        // A key or text of the file may hold anything.
        m_problems.push_back({line, printable(key + ": " + reason)});
    }

    Profile m_profile;
    std::map<std::string, std::size_t> m_lines;  // of every known key and table of the file
    std::vector<FileProblem> m_problems;
};

std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
        }
        result += c;
    }
    return result + "\"";
}

std::string number(double value)
{
    std::string text = formatFixed(value, kDecimals);
    text.erase(std::max(text.find_last_not_of('0'), text.find('.') + 1) + 1);
    return text;
}

std::string inToml(const SettingValue& value)
{
    if (const auto* text = std::get_if<std::string>(&value)) {
        return quoted(*text);
    }
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return std::to_string(*whole);
    }
    return number(std::get<double>(value));
}

std::string bounds(const Setting& setting)
{
    switch (setting.type) {
        case SettingType::Integer:
            return formatFixed(setting.min, 0) + "…" + formatFixed(setting.max, 0);
        case SettingType::Number:
            return number(setting.min) + "…" + number(setting.max);
        case SettingType::Choice: {
            std::string text = "one of";
            for (const std::string& name : setting.choices) {
                text += " " + quoted(name);
            }
            return text;
        }
        case SettingType::Text:
            break;
    }
    return "text";
}

std::string comment(const Setting& setting)
{
    std::string facts = bounds(setting) + (setting.unit.empty() ? "" : " " + setting.unit);
    facts += "; default " + inToml(setting.get(Profile{}));
    facts += setting.applies == Applies::Now ? "; applies at once" : "; applies on reconnect";
    return "# " + setting.text + "\n# " + facts + "\n";
}

}  // namespace

Result<Profile> parseProfile(std::string_view text, const std::string& fileName)
{
    Reader reader;
    try {
        reader.read(toml::parse(text, fileName));
    } catch (const toml::parse_error& error) {
        return failure(ErrorCode::InvalidInput, fileName + ":" + std::to_string(error.source().begin.line) + ": " +
                                                    printable(std::string(error.description())));
    }
    std::string all;
    for (const FileProblem& problem : reader.problems()) {
        all += (all.empty() ? "" : "\n") + fileName + ":" + std::to_string(problem.line) + ": " + problem.text;
    }
    if (!all.empty()) {
        return failure(ErrorCode::InvalidInput, all);
    }
    return reader.profile();
}

Result<Profile> loadProfile(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::NoDevice, path.toStdString() + ": " + file.errorString().toStdString());
    }
    const QByteArray bytes = file.readAll();
    if (file.error() != QFileDevice::NoError) {
        return failure(ErrorCode::Io, path.toStdString() + ": " + file.errorString().toStdString());
    }
    return parseProfile({bytes.constData(), static_cast<std::size_t>(bytes.size())}, path.toStdString());
}

std::string toToml(const Profile& profile)
{
    std::string text =
        "# Boresight mount profile. A key that is left out has its default; an unknown one is an error.\n"
        "# Angles of park and travel are mechanical: 370° is not 10°.\n"
        "version = " +
        std::to_string(kVersion) + "\n";
    std::string table;
    for (const Setting& setting : settings()) {
        const std::size_t dot = setting.key.find('.');
        if (setting.key.substr(0, dot) != table) {
            table = setting.key.substr(0, dot);
            text += "\n[" + table + "]\n";
        }
        text += comment(setting) + setting.key.substr(dot + 1) + " = " + inToml(setting.get(profile)) + "\n";
    }
    return text;
}

Result<> saveProfile(const Profile& profile, const QString& path)
{
    QSaveFile file(path);
    const QByteArray bytes = QByteArray::fromStdString(toToml(profile));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
        return failure(ErrorCode::Io, path.toStdString() + ": " + file.errorString().toStdString());
    }
    return {};
}

}  // namespace boresight::profile
