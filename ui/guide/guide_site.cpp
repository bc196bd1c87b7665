// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_site.h"

#include "core/targets/locator.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/guide_fields.h"
#include "ui/kit/value_label.h"
#include "ui/link/host_desk.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QSignalBlocker>

namespace boresight::ui {

namespace {

QString stationText(const profile::GpredictStation& station)
{
    return station.location.isEmpty() ? station.name : QStringLiteral("%1 (%2)").arg(station.name, station.location);
}

QString daysText(UtcTime from, UtcTime to)
{
    const double days = std::chrono::duration<double, std::chrono::days::period>(to - from).count();
    return days < 1.0 ? GuideSite::tr("less than a day") : GuideSite::tr("%1 days").arg(days, 0, 'f', 1);
}

QString satellitesText(const profile::GpredictFiles& found, UtcTime now)
{
    const profile::GpredictSatellites& satellites = found.satellites;
    if (satellites.files == 0) {
        return found.stations.empty()
                   ? GuideSite::tr("%1: No Gpredict settings found. Choose its folder.").arg(found.folder)
                   : GuideSite::tr("%1: no satellite data").arg(found.folder);
    }
    return satellites.newest ? GuideSite::tr("%1: satellites %2, the newest elements %3 old")
                                   .arg(found.folder)
                                   .arg(satellites.files)
                                   .arg(daysText(*satellites.newest, now))
                             : GuideSite::tr("%1: satellites %2, none with elements that can be read")
                                   .arg(found.folder)
                                   .arg(satellites.files);
}

}  // namespace

GuideSite::GuideSite(ProfileChange& change, RequestDesk& desk, HostDesk& host, QWidget* parent)
    : QWidget(parent),
      m_change(change),
      m_host(host),
      m_notice(new ValueLabel(tr("What is wrong"), fonts::label(), {}, this)),
      m_gpredictNote(new ValueLabel(tr("Sites found in Gpredict"), fonts::label(), {}, this)),
      m_latitude(makeField({.name = tr("Latitude"),
                            .help = tr("Degrees, north positive"),
                            .min = -90.0,
                            .max = 90.0,
                            .decimals = 5,
                            .unit = QStringLiteral("°")},
                           this)),
      m_longitude(makeField({.name = tr("Longitude"),
                             .help = tr("Degrees, east positive"),
                             .min = -180.0,
                             .max = 180.0,
                             .decimals = 5,
                             .unit = QStringLiteral("°")},
                            this)),
      m_height(makeField({.name = tr("Height"),
                          .help = tr("Above sea level"),
                          .min = -500.0,
                          .max = 9000.0,
                          .decimals = 0,
                          .unit = QStringLiteral(" m")},
                         this)),
      m_locator(new QLineEdit(this)),
      m_gpredict(new QComboBox(this)),
      m_choose(new CommandButton(tr("Folder …"), tr("Where Gpredict keeps its files, if not at the usual place"), desk,
                                 *m_notice, this)),
      m_set(new CommandButton(tr("Set the site"), tr("Store this place in the profile"), desk, *m_notice, this))
{
    build();
    for (QDoubleSpinBox* const field : {m_latitude, m_longitude}) {
        connect(field, &QDoubleSpinBox::valueChanged, this, &GuideSite::writeLocator);
    }
    connect(m_locator, &QLineEdit::textEdited, this, &GuideSite::readLocator);
    connect(m_gpredict, &QComboBox::activated, this, &GuideSite::take);
    connect(&m_host, &HostDesk::gpredictFound, this, &GuideSite::showGpredict);
    connect(m_choose, &QPushButton::clicked, this, &GuideSite::chooseFolder);
    connect(m_set, &QPushButton::clicked, this, [this] { m_change.ask(*m_set, edit()); });
}

void GuideSite::build()
{
    m_locator->setFont(fonts::label());
    m_locator->setMaxLength(10);
    m_locator->setMinimumHeight(m_latitude->minimumHeight());
    m_locator->setAccessibleName(tr("Maidenhead locator"));
    m_locator->setToolTip(tr("4 to 10 characters, for example JN58td. The place is the middle of this square."));
    m_gpredict->setFont(fonts::label());
    m_gpredict->setMinimumHeight(m_latitude->minimumHeight());
    m_gpredict->setAccessibleName(tr("Station of Gpredict"));
    m_gpredict->setToolTip(tr("Ground stations of Gpredict on this computer. Choose one to fill in the fields."));
    m_gpredictNote->setStretching(true);
    m_gpredictNote->setLines(3);
    m_notice->setStretching(true);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    const auto add = [&](int row, int column, const QString& text, QWidget* field) {
        grid->addWidget(makeCaption(text, *field), row, column);
        grid->addWidget(field, row, column + 1);
    };
    add(0, 0, tr("Latitude (north +)"), m_latitude);
    add(1, 0, tr("Longitude (east +)"), m_longitude);
    add(0, 2, tr("Height"), m_height);
    add(1, 2, tr("Locator"), m_locator);
    add(2, 0, tr("From Gpredict"), m_gpredict);
    grid->addWidget(m_choose, 2, 2, 1, 2);
    grid->addWidget(m_gpredictNote, 3, 0, 1, 4);
    grid->addWidget(m_set, 4, 2, 1, 2);
    grid->addWidget(m_notice, 5, 0, 1, 4);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    grid->setRowStretch(6, 1);
}

void GuideSite::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    lookForGpredict();
}

void GuideSite::lookForGpredict()
{
    const QString folder = profile::gpredictFolder(m_change.applied().gpredict);
    if (isVisible() && folder != m_folder) {
        m_folder = folder;
        Q_EMIT m_host.gpredictWanted(folder);
    }
}

void GuideSite::chooseFolder()
{
    const QFileDialog* const dialog = askForFolder(*this, tr("Where Gpredict keeps its files"), m_folder);
    connect(dialog, &QFileDialog::fileSelected, this, &GuideSite::takeFolder);
}

// The usual folder is not stored, because it differs between computers and users.
void GuideSite::takeFolder(const QString& folder)
{
    const bool usual = folder == profile::gpredictFolder({});
    m_change.ask(*m_choose, [path = usual ? std::string() : folder.toStdString()](profile::Profile& profile) {
        profile.gpredict.folder = path;
    });
}

void GuideSite::showStatus(const StationStatus& status)
{
    m_status = status;
    const profile::SiteSettings& site = m_change.applied().site;
    if (m_shown != site) {
        m_shown = site;
        if (site.known) {
            fill(site);
        }
    }
    lookForGpredict();
    showButton();
}

void GuideSite::fill(const profile::SiteSettings& site)
{
    m_latitude->setValue(site.latitude.degrees());
    m_longitude->setValue(site.longitude.degrees());
    m_height->setValue(site.heightMetres);
    writeLocator();
}

void GuideSite::writeLocator()
{
    const auto locator = targets::toLocator(
        {.latitude = Angle::fromDegrees(m_latitude->value()), .longitude = Angle::fromDegrees(m_longitude->value())});
    m_locator->setText(locator ? QString::fromStdString(*locator) : QString());
    m_notice->setValue({});
    showButton();
}

void GuideSite::readLocator()
{
    const auto place = targets::fromLocator(m_locator->text().trimmed().toStdString());
    if (!place) {
        m_notice->setValue(place.error().text, Tone::Warning, Symbol::Warning);
        return;
    }
    const QSignalBlocker latitudeQuiet(m_latitude);  // the text that is being typed stays
    const QSignalBlocker longitudeQuiet(m_longitude);
    m_latitude->setValue(place->latitude.degrees());
    m_longitude->setValue(place->longitude.degrees());
    m_notice->setValue({});
    showButton();
}

void GuideSite::showGpredict(const profile::GpredictFiles& found)
{
    if (found.folder != m_folder) {
        return;  // the answer to an older request
    }
    m_stations = found.stations;
    m_gpredict->clear();
    for (const profile::GpredictStation& station : m_stations) {
        m_gpredict->addItem(stationText(station));
    }
    m_gpredict->setEnabled(!m_stations.empty());
    m_gpredict->setCurrentIndex(-1);
    m_gpredict->setPlaceholderText(m_stations.empty() ? tr("none found") : tr("choose …"));
    m_gpredictNote->setValue(
        (QStringList(satellitesText(found, m_status.utc)) + found.problems).join(QLatin1Char('\n')), Tone::Secondary);
}

void GuideSite::take(int row)
{
    if (row >= 0 && row < static_cast<int>(m_stations.size())) {
        fill(m_stations[static_cast<std::size_t>(row)].site);
    }
}

ProfileChange::Edit GuideSite::edit() const
{
    return [latitude = m_latitude->value(), longitude = m_longitude->value(),
            height = m_height->value()](profile::Profile& profile) {
        profile.site = {.known = true,
                        .latitude = Angle::fromDegrees(latitude),
                        .longitude = Angle::fromDegrees(longitude),
                        .heightMetres = height};
    };
}

void GuideSite::showButton()
{
    const bool entered = m_latitude->value() != 0.0 ||
                         m_longitude->value() != 0.0;  // 0°, 0° is in the sea, so it means that nothing was entered
    m_choose->setBlocked(m_change.whyNot(m_status, [](profile::Profile&) {}));
    m_set->setBlocked(!entered                     ? tr("enter the site of the mount first")
                      : m_change.isAlready(edit()) ? tr("this is the site in the profile")
                                                   : m_change.whyNot(m_status, edit()));
}

}  // namespace boresight::ui

#include "moc_guide_site.cpp"
