// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/setting_tree.h"

#include "core/base/text.h"
#include "ui/kit/theme.h"
#include "ui/link/setting_words.h"
#include "ui/profile/setting_picture.h"

#include <QBrush>
#include <QFont>

#include <algorithm>

namespace boresight::ui {

namespace {

// The internal id of a group. The id of a line is the number of its group plus one.
constexpr quintptr kIsGroup = 0;

QString tableOf(const std::string& key)
{
    return QString::fromStdString(key.substr(0, key.find('.')));
}

// Whole phrases, because English is shown without a translator that would choose the plural.
QString counted(std::size_t count, const QString& one, const QString& many)
{
    return count == 1 ? one : many.arg(count);
}

bool contains(const std::vector<std::string>& keys, const std::string& key)
{
    return std::ranges::find(keys, key) != keys.end();
}

std::vector<profile::SettingChoice> choicesOf(const profile::Setting* setting)
{
    return setting != nullptr ? setting->choices : std::vector<profile::SettingChoice>{};
}

// With their words in the file: "Hold position (hold), Brake (brake)".
QString choicesText(const profile::Setting& setting)
{
    QStringList texts;
    for (const profile::SettingChoice& one : setting.choices) {
        texts << QStringLiteral("%1 (%2)").arg(Text::of(one.title), QString::fromStdString(one.word));
    }
    return texts.join(QStringLiteral(", "));
}

QString capitalised(const QString& text)
{
    return text.left(1).toUpper() + text.mid(1);
}

}  // namespace

SettingTree::SettingTree(ProfileDraft& draft, QObject* parent) : QAbstractItemModel(parent), m_draft(draft)
{
    for (const profile::Setting& setting : profile::settings()) {
        addLine(tableOf(setting.key),
                {.key = setting.key, .comparedAs = setting.isGiven ? "site" : setting.key, .setting = &setting});
    }
    for (const auto& [table, key] :
         {std::pair("mount", profile::kAntennaKey), std::pair("limits", profile::kHorizonKey),
          std::pair("limits", profile::kKeepOutKey), std::pair("park", profile::kPresetKey)}) {
        addLine(QLatin1String(table), {.key = std::string(key), .comparedAs = std::string(key)});
    }
    connect(&m_draft, &ProfileDraft::changed, this, &SettingTree::followDraft);
}

void SettingTree::addLine(const QString& table, const Line& line)
{
    const QString title = groupTitle(table);
    auto group = std::ranges::find(m_groups, title, &Group::title);
    if (group == m_groups.end()) {
        group = m_groups.insert(m_groups.end(), {title, {}});
    }
    group->lines.push_back(line);
}

void SettingTree::followDraft()
{
    m_editedKeys = m_draft.editedKeys();
    for (int group = 0; group < rowCount(); ++group) {
        const QModelIndex parent = index(group, 0);
        Q_EMIT dataChanged(parent, index(group, ColumnCount - 1));
        Q_EMIT dataChanged(index(0, 0, parent), index(rowCount(parent) - 1, ColumnCount - 1, parent));
    }
}

QModelIndex SettingTree::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent)) {
        return {};
    }
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : kIsGroup);
}

QModelIndex SettingTree::parent(const QModelIndex& child) const
{
    if (!child.isValid() || child.internalId() == kIsGroup) {
        return {};
    }
    return createIndex(static_cast<int>(child.internalId()) - 1, 0, kIsGroup);
}

int SettingTree::rowCount(const QModelIndex& parent) const
{
    if (!parent.isValid()) {
        return static_cast<int>(m_groups.size());
    }
    const bool isGroup = parent.internalId() == kIsGroup && parent.column() == 0;
    return isGroup ? static_cast<int>(m_groups[static_cast<std::size_t>(parent.row())].lines.size()) : 0;
}

int SettingTree::columnCount(const QModelIndex&) const
{
    return ColumnCount;
}

const SettingTree::Line* SettingTree::lineOf(const QModelIndex& index) const
{
    if (!index.isValid() || index.internalId() == kIsGroup) {
        return nullptr;
    }
    return &m_groups[index.internalId() - 1].lines[static_cast<std::size_t>(index.row())];
}

SettingTree::State SettingTree::stateOf(const Line& line) const
{
    return {.wrong = m_draft.problem(line.key).isEmpty() ? 0 : 1,
            .edited = contains(m_editedKeys, line.comparedAs) ? 1 : 0,
            .waiting = contains(m_draft.waitingKeys(), line.comparedAs) ? 1 : 0};
}

SettingTree::State SettingTree::stateOf(const Group& group) const
{
    State sum;
    for (const Line& line : group.lines) {
        const State one = stateOf(line);
        sum.wrong += one.wrong;
        sum.edited += one.edited;
        sum.waiting += one.waiting;
    }
    return sum;
}

Qt::ItemFlags SettingTree::flags(const QModelIndex& index) const
{
    const Line* const line = lineOf(index);
    const bool editable = line != nullptr && line->setting != nullptr && index.column() == Value;
    return QAbstractItemModel::flags(index) | (editable ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

QVariant SettingTree::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    const QString names[] = {tr("Setting"), tr("Value"), tr("Range"), tr("Applies")};
    return names[section];
}

QVariant SettingTree::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const Line* const line = lineOf(index);
    return line == nullptr ? groupData(index, role) : lineData(*line, index.column(), role);
}

QVariant SettingTree::groupData(const QModelIndex& index, int role) const
{
    const Group& group = m_groups[static_cast<std::size_t>(index.row())];
    const State state = stateOf(group);
    const bool isValue = index.column() == Value;
    switch (role) {
        case Qt::DisplayRole:
            if (index.column() == Name) {
                return group.title;
            }
            return !isValue            ? QVariant()
                   : state.wrong > 0   ? tr("▲ %1 wrong").arg(state.wrong)
                   : state.edited > 0  ? tr("%1 changed").arg(state.edited)
                   : state.waiting > 0 ? tr("%1 waiting").arg(state.waiting)
                                       : QVariant();
        case Qt::ForegroundRole:
            return QBrush(!isValue           ? currentTheme().secondary
                          : state.wrong > 0  ? currentTheme().warning
                          : state.edited > 0 ? currentTheme().accent
                                             : currentTheme().advisory);
        case Qt::FontRole: {
            QFont font = fonts::label();
            font.setBold(index.column() == Name);
            font.setCapitalization(index.column() == Name ? QFont::AllUppercase : QFont::MixedCase);
            font.setPointSizeF(font.pointSizeF() * 0.9);
            return font;
        }
        case SearchRole:
            return group.title;
        case ExplanationRole:
            return tr("%1: %2 settings. Enter opens the group.").arg(group.title).arg(group.lines.size());
        default:
            return {};
    }
}

QVariant SettingTree::lineData(const Line& line, int column, int role) const
{
    const State state = stateOf(line);
    switch (role) {
        case Qt::DisplayRole:
            return text(line, column);
        case Qt::EditRole:
            return line.setting != nullptr ? typedText(*line.setting, m_draft.edited()) : QString();
        case Qt::ForegroundRole:
            return QBrush(column == Value && state.wrong > 0    ? currentTheme().warning
                          : column == Value && state.edited > 0 ? currentTheme().accent
                          : column != Name && state.waiting > 0 ? currentTheme().advisory
                          : column == Name || column == Value   ? currentTheme().text
                                                                : currentTheme().secondary);
        case Qt::DecorationRole:
            return column == Name ? QVariant(SettingPicture(line.key).icon()) : QVariant();
        case Qt::ToolTipRole:
            return explanation(line) + QLatin1Char('\n') + tr("In the file: %1").arg(QString::fromStdString(line.key));
        case ExplanationRole:
            return meaning(line).join(QLatin1Char(' '));
        case KeyRole:
            return QString::fromStdString(line.key);
        case SearchRole:
            return QStringList(
                       {QString::fromStdString(line.key), text(line, Name), text(line, Value), explanation(line)})
                .join(QLatin1Char(' '));
        case ChangedRole:
            return state.wrong + state.edited + state.waiting > 0;
        case ChoicesRole: {
            QStringList words;
            for (const profile::SettingChoice& one : choicesOf(line.setting)) {
                words << QString::fromStdString(one.word);
            }
            return words;
        }
        case ChoiceNamesRole: {
            QStringList names;
            for (const profile::SettingChoice& one : choicesOf(line.setting)) {
                names << Text::of(one.title);
            }
            return names;
        }
        case SecretRole:
            return line.setting != nullptr && line.setting->secret;
        case ShareRole:
        case DefaultShareRole: {
            const auto share = line.setting == nullptr ? std::nullopt
                               : role == ShareRole     ? shareOfRange(*line.setting, m_draft.edited())
                                                       : shareOfRange(*line.setting, profile::Profile());
            return share ? QVariant(*share) : QVariant();
        }
        default:
            return {};
    }
}

QString SettingTree::text(const Line& line, int column) const
{
    const State state = stateOf(line);
    switch (column) {
        case Name:
            return line.setting != nullptr ? Text::of(line.setting->title) : capitalised(settingName(line.key));
        case Value:
            return valueColumn(line);
        case Range:
            return line.setting != nullptr ? rangeText(*line.setting) : QString();
        default:
            return state.waiting > 0                                                                   ? tr("● waits")
                   : line.setting != nullptr && line.setting->applies == profile::Applies::OnReconnect ? tr("reconnect")
                                                                                                       : tr("at once");
    }
}

QString SettingTree::heldText(const Line& line, const profile::Profile& profile) const
{
    if (line.setting != nullptr) {
        return valueText(*line.setting, profile);
    }
    if (line.key == profile::kHorizonKey) {
        return counted(profile.limits.horizon.size(), tr("1 point"), tr("%1 points"));
    }
    if (line.key == profile::kKeepOutKey) {
        return counted(profile.limits.keepOuts.size(), tr("1 sector"), tr("%1 sectors"));
    }
    if (line.key == profile::kAntennaKey) {
        return counted(profile.allAntennas().size(), tr("1 antenna"), tr("%1 antennas"));
    }
    return counted(profile.presets.size(), tr("1 direction"), tr("%1 directions"));
}

QString SettingTree::valueColumn(const Line& line) const
{
    const QString held = heldText(line, m_draft.edited());
    const State state = stateOf(line);
    if (state.wrong > 0) {
        return tr("▲ %1").arg(held);
    }
    const QString before = heldText(line, m_draft.applied());
    return state.edited > 0 && before != held ? tr("%1 (was %2)").arg(held, before) : held;
}

QStringList SettingTree::meaning(const Line& line) const
{
    QStringList sentences;
    if (const QString problem = m_draft.problem(line.key); !problem.isEmpty()) {
        sentences << tr("▲ %1.").arg(problem);
    }
    if (line.setting == nullptr) {
        sentences << (line.key == profile::kPresetKey ? tr("Your own directions. The panel Jog (Ctrl+1) changes them.")
                      : line.key == profile::kAntennaKey
                          ? tr("Antennas with name, beam width and two offsets. Press Enter to edit them.")
                          : tr("The panel Limits (Ctrl+3) and the sky change them."));
        return sentences;
    }
    const profile::Setting& setting = *line.setting;
    sentences << Text::of(setting.text);
    sentences << tr("Default %1.").arg(valueText(setting, profile::Profile()));
    if (const QString inForce = valueText(setting, m_draft.inForce());
        inForce != valueText(setting, m_draft.edited())) {
        sentences << tr("In force: %1.").arg(inForce);
    }
    return sentences;
}

QString SettingTree::explanation(const Line& line) const
{
    QStringList sentences = meaning(line);
    if (line.setting != nullptr) {
        const profile::Setting& setting = *line.setting;
        if (!setting.choices.empty()) {
            sentences << tr("One of %1.").arg(choicesText(setting));
        } else if (const QString range = rangeText(setting); !range.isEmpty()) {
            sentences << tr("Range %1.").arg(range);
        }
        sentences << (setting.applies == profile::Applies::Now ? tr("Applies at once.") : tr("Applies on reconnect."));
    }
    return sentences.join(QLatin1Char(' '));
}

bool SettingTree::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const Line* const line = lineOf(index);
    if (role != Qt::EditRole || line == nullptr || line->setting == nullptr) {
        return false;
    }
    if (value.toString() == data(index, Qt::EditRole).toString()) {
        return true;  // leaving the editor without a change must not set the site to zeros
    }
    profile::Profile edited = m_draft.edited();
    const Result<> taken = putTyped(*line->setting, value.toString(), edited);
    Q_EMIT refused(taken ? QString() : taken.error().text);
    if (taken) {
        m_draft.edit([&edited](profile::Profile& profile) { profile = edited; });
    }
    return taken.has_value();
}

}  // namespace boresight::ui

#include "moc_setting_tree.cpp"
