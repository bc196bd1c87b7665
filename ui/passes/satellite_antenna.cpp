// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/satellite_antenna.h"

#include "ui/kit/value_label.h"
#include "ui/link/profile_draft.h"

#include <QAbstractItemView>

namespace boresight::ui {

SatelliteAntenna::SatelliteAntenna(ProfileDraft& draft, ValueLabel& notice, QWidget* parent)
    : TouchCombo(tr("Antenna for the satellite"), tr("The antenna that this satellite is tracked with"), parent),
      m_draft(draft),
      m_notice(notice)
{
    constexpr int kNameLength = 16;  // characters
    setMinimumContentsLength(kNameLength);
    connect(this, &QComboBox::activated, this, &SatelliteAntenna::store);
    hide();
}

void SatelliteAntenna::show(const std::optional<int>& satellite, const profile::Profile& profile)
{
    QStringList names{QString()};
    for (const pointing::Antenna& one : profile.allAntennas()) {
        names << QString::fromStdString(one.name);
    }
    if (names != m_names) {
        m_names = names;
        names.front() = tr("as chosen by hand");
        setLines(names);
        setRoom(m_hasRoom);
    }
    m_satellite = satellite;
    m_stored = satellite ? QString::fromStdString(orbit::antennaOf(profile.satellites, *satellite)) : QString();
    setEnabled(satellite.has_value());
    if (!view()->isVisible()) {  // otherwise the list would move away below the finger
        showStored();
    }
}

void SatelliteAntenna::setRoom(bool has)
{
    m_hasRoom = has;
    constexpr qsizetype kMainAlone = 2;
    setVisible(has && m_names.size() > kMainAlone);
}

void SatelliteAntenna::showStored()
{
    setCurrentIndex(static_cast<int>(m_names.indexOf(m_stored)));
}

// Until the station has answered, the box keeps showing the stored antenna.
void SatelliteAntenna::store(int index)
{
    const QString name = m_names.value(index);
    showStored();
    if (!m_satellite || name == m_stored) {
        return;
    }
    m_draft.applyAlone(
        [satellite = *m_satellite, name](profile::Profile& profile) {
            orbit::setAntenna(profile.satellites, satellite, name.toStdString());
        },
        this,
        [this](const std::optional<Error>& error) {
            m_notice.setValue(error ? tr("Antenna: %1").arg(error->text) : QString(),
                              error ? Tone::Warning : Tone::Normal, error ? Symbol::Warning : Symbol::None);
        });
}

}  // namespace boresight::ui

#include "moc_satellite_antenna.cpp"
