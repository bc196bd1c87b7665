// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/preset_bar.h"

#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/kit/touch_combo.h"
#include "ui/link/profile_draft.h"

#include <QHBoxLayout>
#include <QLineEdit>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kLongestName = 64;

QString nameOf(const profile::Preset& preset)
{
    return QString::fromStdString(preset.name);
}

}  // namespace

PresetBar::PresetBar(ProfileDraft& draft, RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_names(
          new TouchCombo(tr("Preset"), tr("A named direction of this mount. Choose one, or type a new name."), this)),
      m_go(new CommandButton(tr("Go to"), tr("Go to this preset by the shortest way (Enter)"), desk, notice, this)),
      m_save(new CommandButton(tr("Save here"), tr("Save the present direction of the mount under this name"), desk,
                               notice, this)),
      m_delete(new CommandButton(tr("Delete"), tr("Delete this preset from the list"), desk, notice, this)),
      m_question(desk, this)
{
    build();
    connect(m_names, &QComboBox::editTextChanged, this, &PresetBar::lookUp);
    connect(m_names->lineEdit(), &QLineEdit::returnPressed, this, &PresetBar::go);
    connect(m_go, &QPushButton::clicked, this, &PresetBar::go);
    connect(m_save, &QPushButton::clicked, this, &PresetBar::save);
    connect(m_delete, &QPushButton::clicked, this, &PresetBar::remove);
    connect(m_delete, &CommandButton::accepted, m_names, &QComboBox::clearEditText);
    connect(&m_question, &DirectionQuestion::answered, this, &PresetBar::showPermissions);
}

void PresetBar::build()
{
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGrid / 2);
    row->addWidget(m_names, 1);
    row->addWidget(m_go);
    row->addWidget(m_save);
    row->addWidget(m_delete);
    m_names->setEditable(true);
    m_names->setMinimumContentsLength(8);
    m_names->lineEdit()->setPlaceholderText(tr("Preset"));
    m_names->lineEdit()->setMaxLength(kLongestName);
    m_names->lineEdit()->setAccessibleName(tr("Name of the preset"));
}

QString PresetBar::typedName() const
{
    return m_names->currentText().trimmed();
}

const profile::Preset* PresetBar::chosen() const
{
    const auto& presets = m_status.profile->presets;
    const auto found = std::ranges::find(presets, typedName(), &nameOf);
    return found == presets.end() ? nullptr : &*found;
}

void PresetBar::showStatus(const StationStatus& status)
{
    const bool newProfile = status.profile != m_status.profile;
    m_status = status;
    if (newProfile) {
        showPresets();
        lookUp();
    }
    if (isVisible()) {
        m_question.showStatus(status);
    }
    showPermissions();
}

void PresetBar::showPresets()
{
    QStringList names;
    std::ranges::transform(m_status.profile->presets, std::back_inserter(names), &nameOf);
    m_names->setLines(names);
}

void PresetBar::lookUp()
{
    const profile::Preset* const preset = chosen();
    if (preset != nullptr) {
        m_question.ask(preset->direction);
    } else {
        m_question.drop();
    }
    m_names->setAccessibleDescription(preset ? directionText(preset->direction) : QString());
    m_go->setCommand(tr("Go to"), preset
                                      ? tr("Go to %1 by the shortest way (Enter)").arg(directionText(preset->direction))
                                      : tr("Go to this preset by the shortest way (Enter)"));
    showPermissions();
}

void PresetBar::showPermissions()
{
    m_go->setBlocked(whyNoGo());
    m_save->setBlocked(whyNoSave());
    m_delete->setBlocked(chosen() ? QString() : tr("There is no preset with this name."));
}

QString PresetBar::whyNoGo() const
{
    const QString reason = m_status.permissions.reason(Action::Point);
    return !reason.isEmpty() ? reason : chosen() ? m_question.whyNot() : tr("There is no preset with this name.");
}

QString PresetBar::whyNoSave() const
{
    if (typedName().isEmpty()) {
        return tr("Type a name first.");
    }
    const bool live =
        freshness(m_status.azimuth.age) == Freshness::Live && freshness(m_status.elevation.age) == Freshness::Live;
    return m_status.actual && live ? QString() : tr("The direction of the mount is unknown.");
}

void PresetBar::go()
{
    if (m_go->isEnabled() && !m_go->isWaiting()) {  // the box reports Enter twice: by its field and by itself
        m_go->ask(request::PointSky{chosen()->direction});
    }
}

void PresetBar::save()
{
    const profile::Preset preset{.name = typedName().toStdString(), .direction = *m_status.actual};
    m_save->await([&](QObject* asker, const RequestDesk::Reply& reply) {
        m_draft.applyAlone(
            [&preset](profile::Profile& profile) {
                const auto old = std::ranges::find(profile.presets, preset.name, &profile::Preset::name);
                if (old == profile.presets.end()) {
                    profile.presets.push_back(preset);
                } else {
                    *old = preset;
                }
            },
            asker, reply);
    });
}

void PresetBar::remove()
{
    m_delete->await([&](QObject* asker, const RequestDesk::Reply& reply) {
        m_draft.applyAlone(
            [name = typedName().toStdString()](profile::Profile& profile) {
                std::erase_if(profile.presets, [&](const profile::Preset& one) { return one.name == name; });
            },
            asker, reply);
    });
}

}  // namespace boresight::ui

#include "moc_preset_bar.cpp"
