// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/stored_mounts.h"

#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/setting.h"
#include "ui/link/setting_words.h"

#include <QFileInfo>

#include <algorithm>
#include <optional>
#include <utility>

namespace boresight::ui {

namespace {

const QString kNameKey = QStringLiteral("mount.name");

// A choice by its name. Every other value stays as it is.
QString shownValue(const std::string& key, const QString& value)
{
    const profile::Setting* const setting = profile::findSetting(key);
    return setting != nullptr ? profile::choiceName(setting->choices, value.toStdString()) : value;
}

// One line for each setting that differs, in the words of the screen.
QString differences(const profile::Profile& from, const profile::Profile& to)
{
    const auto changes = profile::changesBetween(from, to);
    QString text = StoredMounts::tr("Different: %1").arg(changes.size());
    for (const profile::Change& change : changes) {
        const QString line = change.applies == profile::Applies::Now ? StoredMounts::tr("%1: %2 → %3")
                                                                     : StoredMounts::tr("%1: %2 → %3, on reconnect");
        text += QLatin1Char('\n') + line.arg(settingName(change.key), shownValue(change.key, change.before),
                                             shownValue(change.key, change.after));
    }
    return text;
}

Result<> setName(profile::Profile& profile, const QString& name)
{
    return profile::findSetting(kNameKey.toStdString())->set(profile, name.toStdString());
}

QString nameOf(const profile::Profile& profile)
{
    return QString::fromStdString(profile.mount.name);
}

}  // namespace

StoredMounts::StoredMounts(ProfileDraft& draft, const QString& configDir)
    : m_draft(draft),
      m_hasStore(!configDir.isEmpty()),
      m_store(configDir),
      m_inForce(StationStatus().profile->mount.name)
{
    takeList({});
}

void StoredMounts::showStatus(const StationStatus& status)
{
    m_simulated = status.simulated;
    if (status.profile->mount.name != m_inForce) {
        m_inForce = status.profile->mount.name;
        takeList(m_mounts);
        refresh();  // the mount of the station may have its file by now
    }
}

void StoredMounts::refresh()
{
    if (m_hasStore) {
        m_files.run(
            this, [store = m_store] { return store.list(); },
            [this](const std::vector<profile::StoredProfile>& mounts) { takeList(mounts); });
    }
}

void StoredMounts::takeList(std::vector<profile::StoredProfile> mounts)
{
    std::erase_if(mounts, [](const profile::StoredProfile& one) { return one.path.isEmpty(); });
    if (std::ranges::none_of(mounts, [this](const auto& one) { return isInForce(one); })) {
        mounts.insert(mounts.begin(), {.path = {}, .mountName = QString::fromStdString(m_inForce)});
    }
    m_mounts = std::move(mounts);
    Q_EMIT listed();
}

bool StoredMounts::isInForce(const profile::StoredProfile& mount) const
{
    return mount.problem.isEmpty() && mount.mountName.toStdString() == m_inForce;
}

const profile::StoredProfile* StoredMounts::stored(const QString& mountName) const
{
    const auto found = std::ranges::find_if(m_mounts, [&mountName](const profile::StoredProfile& one) {
        return one.problem.isEmpty() && one.mountName == mountName;
    });
    return found == m_mounts.end() ? nullptr : &*found;
}

void StoredMounts::load(const QString& path, const std::function<void(const profile::Profile&)>& then)
{
    m_files.run(
        this, [path] { return profile::loadProfile(path); },
        [this, then](const Result<profile::Profile>& read) {
            if (read) {
                then(*read);
            } else {
                Q_EMIT failed(read.error().text);
            }
        });
}

void StoredMounts::write(const Outcome& work, const QString& outcome)
{
    m_files.run(this, work, [this, outcome](const Result<>& written) {
        if (written) {
            Q_EMIT done(outcome);
        } else {
            Q_EMIT failed(written.error().text);
        }
        refresh();
    });
}

void StoredMounts::ask(const QString& title, const QString& text, const QString& act, const Perform& perform)
{
    Q_EMIT asked({.title = title, .text = text, .act = act, .request = {}, .perform = perform});
}

void StoredMounts::switchTo(const profile::StoredProfile& mount)
{
    load(mount.path, [this](const profile::Profile& other) {
        const QString bus = QString::fromStdString(other.bus);
        const QString lines =
            (m_draft.keepsSimulated() ? tr("Bus: simulated, because Boresight was started with --simulate. The bus of "
                                           "this mount, %1, is not used.")
                                      : tr("Bus: %1"))
                .arg(bus) +
            QLatin1Char('\n') +
            tr("Boresight disconnects from the present mount like at the end of the program. Then it connects to the "
               "other mount. Nothing moves. The window stays open.") +
            QStringLiteral("\n\n") + differences(m_draft.applied(), other);
        Q_EMIT asked({.title = tr("Switch to the mount \"%1\"?").arg(nameOf(other)),
                      .text = lines,
                      .act = tr("Switch"),
                      .request = request::Reconnect{other},
                      .action = Action::Reconnect});
    });
}

void StoredMounts::duplicate(const profile::StoredProfile& mount)
{
    // A simulated mount is not listed as a separate mount.
    const bool asApplied = isInForce(mount) && !m_simulated;
    if (mount.path.isEmpty() && !asApplied) {
        Q_EMIT failed(tr("The simulated mount has no profile to duplicate."));
        return;
    }
    const auto perform = [this, mount, asApplied, applied = m_draft.applied()](const QString& name) {
        const auto work = [mount, applied, name, asApplied, store = m_store]() -> Result<> {
            if (!asApplied) {
                return store.duplicate(mount.path, name).map([](const QString&) {});
            }
            profile::Profile copy = applied;
            return setName(copy, name).and_then([&] { return store.add(copy); }).map([](const QString&) {});
        };
        write(work, tr("The mount \"%1\" is stored.").arg(name));
    };
    Q_EMIT asked(
        {.title = tr("Duplicate the mount \"%1\"?").arg(mount.mountName),
         .text = tr("This makes a new mount with the same settings. The position journal with the cable wraps is not "
                    "copied."),
         .act = tr("Duplicate"),
         .request = {},
         .perform = perform,
         .typedName = tr("Name of the new mount"),
         .typed = tr("%1 copy").arg(mount.mountName)});
}

void StoredMounts::rename(const profile::StoredProfile& mount)
{
    const auto perform = [this, mount](const QString& name) {
        if (isInForce(mount)) {
            profile::Profile renamed = m_draft.edited();
            if (const Result<> fits = setName(renamed, name); !fits) {
                Q_EMIT failed(fits.error().text);
                return;
            }
            m_draft.edit([&renamed](profile::Profile& profile) { profile = renamed; });
            Q_EMIT done(tr("Press Apply to store the new name. Press Reconnect to use it."));
            return;
        }
        const auto work = [mount, name, store = m_store] {
            return profile::loadProfile(mount.path).and_then([&](profile::Profile profile) {
                return setName(profile, name).and_then([&] { return store.save(profile, mount.path); });
            });
        };
        write(work, tr("The mount is now called \"%1\".").arg(name));
    };
    Q_EMIT asked(
        {.title = tr("Rename the mount \"%1\"?").arg(mount.mountName),
         .text = tr("The position journal is kept under the name of the mount. Under a new name Boresight asks for the "
                    "cable wraps again, unless the drives report them."),
         .act = tr("Rename"),
         .request = {},
         .perform = perform,
         .typedName = tr("New name of the mount"),
         .typed = mount.mountName});
}

void StoredMounts::remove(const profile::StoredProfile& mount)
{
    if (isInForce(mount)) {
        Q_EMIT failed(tr("This mount is in use. Switch to another mount first."));
        return;
    }
    ask(tr("Remove the mount \"%1\"?").arg(mount.mountName),
        tr("The mount leaves the list. Its file stays under the name %1.removed.")
            .arg(QFileInfo(mount.path).fileName()),
        tr("Remove"), [this, mount](const QString&) {
            write([mount, store = m_store] { return store.remove(mount.path); },
                  tr("The mount \"%1\" is removed.").arg(mount.mountName));
        });
}

void StoredMounts::importFile(const QString& file)
{
    load(file, [this](const profile::Profile& read) { askImport(read); });
}

void StoredMounts::askImport(const profile::Profile& read)
{
    const profile::StoredProfile* const mount = stored(nameOf(read));
    if (mount == nullptr) {
        ask(tr("Import the mount \"%1\"?").arg(nameOf(read)),
            tr("Boresight stores the mount. Nothing else changes.\n\nBus: %1\nCompared with the mount in use:\n%2")
                .arg(QString::fromStdString(read.bus), differences(m_draft.applied(), read)),
            tr("Import"), [this, read](const QString&) {
                write([read, store = m_store] { return store.add(read).map([](const QString&) {}); },
                      tr("The mount \"%1\" is stored.").arg(nameOf(read)));
            });
    } else if (isInForce(*mount)) {
        ask(tr("Copy this file into \"%1\"?").arg(nameOf(read)),
            tr("This mount is in use. The values become edits on this page. Press Apply to use them.\n\n%1")
                .arg(differences(m_draft.applied(), read)),
            tr("Copy values"),
            [this, read](const QString&) { takeOver(read, profile::changedKeys(m_draft.applied(), read)); });
    } else {
        load(mount->path,
             [this, read, mount = *mount](const profile::Profile& kept) { askOverwrite(read, mount, kept); });
    }
}

void StoredMounts::askOverwrite(const profile::Profile& read, const profile::StoredProfile& mount,
                                const profile::Profile& kept)
{
    if (profile::namesNoBus(read) && !profile::namesNoBus(kept)) {
        Q_EMIT failed(tr(
            "This file is a profile of the simulated mount. It cannot replace the profile of a real mount. To import "
            "it, change mount.name in the file."));
        return;
    }
    ask(tr("Overwrite the mount \"%1\"?").arg(nameOf(read)),
        tr("Undo restores the present version.\n\n%1").arg(differences(kept, read)), tr("Overwrite"),
        [this, read, mount](const QString&) {
            write([read, mount, store = m_store] { return store.save(read, mount.path); },
                  tr("The mount \"%1\" is overwritten.").arg(nameOf(read)));
        });
}

void StoredMounts::takeOver(const profile::Profile& from, const std::vector<std::string>& keys)
{
    m_draft.takeOver(from, keys);
    Q_EMIT done(tr("Edits on this page, not applied yet: %1").arg(m_draft.editedKeys().size()));
}

// For the mount in effect its applied settings are exported, because its file may contain values that the command line
// overrides. Changes made in a simulation are exported without the bus, so that no real mount takes them for its own.
void StoredMounts::exportTo(const QString& file, const profile::StoredProfile& mount)
{
    const profile::Profile& inForce = m_draft.applied();
    const auto work = [file, mount, applied = m_simulated ? profile::withoutBus(inForce) : inForce, store = m_store,
                       asApplied = isInForce(mount)] {
        return asApplied ? profile::saveProfile(applied, file) : store.exportFile(mount.path, file);
    };
    write(work, tr("File written: %1").arg(file));
}

void StoredMounts::takeBack(const profile::StoredProfile& mount)
{
    if (mount.path.isEmpty() || !mount.problem.isEmpty()) {
        Q_EMIT failed(tr("This mount has no earlier version."));
        return;
    }
    if (isInForce(mount) && m_draft.hasEdits()) {
        Q_EMIT failed(tr("Apply or revert the edits first."));
        return;
    }
    load(mount.path, [this, mount](const profile::Profile& now) {
        load(profile::previousOf(mount.path),
             [this, mount, now](const profile::Profile& before) { askTakeBack(mount, now, before); });
    });
}

void StoredMounts::askTakeBack(const profile::StoredProfile& mount, const profile::Profile& now,
                               const profile::Profile& before)
{
    ask(tr("Undo the last saved change of \"%1\"?").arg(mount.mountName),
        tr("A second undo restores the change.\n\n%1").arg(differences(now, before)), tr("Undo change"),
        [this, mount, now, before](const QString&) {
            if (!isInForce(mount)) {
                write([mount, store = m_store] { return store.undo(mount.path).map([](const profile::Profile&) {}); },
                      tr("The last change of \"%1\" is undone.").arg(mount.mountName));
                return;
            }
            takeOver(before, profile::changedKeys(now, before));
            m_draft.apply(this, [this](const std::optional<Error>& error) {
                if (error) {
                    Q_EMIT failed(error->text);
                } else {
                    Q_EMIT done(tr("The last change is undone."));
                }
            });
        });
}

}  // namespace boresight::ui

#include "moc_stored_mounts.cpp"
