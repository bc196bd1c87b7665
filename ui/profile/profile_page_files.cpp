// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ProfilePage for what is done with whole profiles: switch, duplicate, import, take back …
#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/setting.h"
#include "ui/kit/file_dialog.h"
#include "ui/profile/profile_page.h"

#include <QFileInfo>

#include <utility>

namespace boresight::ui {

namespace {

const QString kNameKey = QStringLiteral("mount.name");

// One line for each setting that differs, as the operator reads it.
QString differences(const profile::Profile& from, const profile::Profile& to)
{
    const auto changes = profile::changesBetween(from, to);
    QString text = ProfilePage::tr("Different: %1").arg(changes.size());
    for (const profile::Change& change : changes) {
        const QString line = change.applies == profile::Applies::Now ? ProfilePage::tr("%1: %2 → %3")
                                                                     : ProfilePage::tr("%1: %2 → %3, on reconnect");
        text += QLatin1Char('\n') + line.arg(QString::fromStdString(change.key), QString::fromStdString(change.before),
                                             QString::fromStdString(change.after));
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

QString text(const Error& error)
{
    return QString::fromStdString(error.text);
}

}  // namespace

void ProfilePage::load(const QString& path, const std::function<void(const profile::Profile&)>& then)
{
    m_files.run(
        this, [path] { return profile::loadProfile(path); },
        [this, then](const Result<profile::Profile>& read) {
            if (read) {
                then(*read);
            } else {
                warn(text(read.error()));
            }
        });
}

void ProfilePage::write(const Outcome& work, const QString& done)
{
    m_files.run(this, work, [this, done](const Result<>& written) {
        if (written) {
            tell(done);
        } else {
            warn(text(written.error()));
        }
        refresh();
    });
}

void ProfilePage::ask(const QString& title, const QString& text, const QString& act, const Perform& perform)
{
    askFirst({.title = title, .text = text, .act = act, .request = {}, .perform = perform}, m_status);
}

void ProfilePage::switchTo()
{
    load(chosen().path, [this](const profile::Profile& other) {
        const QString bus = QString::fromStdString(other.bus);
        const QString lines =
            (m_draft.keepsSimulated() ? tr("Bus: simulated, because Boresight was started with --simulate. That of "
                                           "this mount, %1, is not used.")
                                      : tr("Bus: %1"))
                .arg(bus) +
            QLatin1Char('\n') +
            tr("The mount of now is left as at the end of the program, and the other one is connected as at a start. "
               "Nothing moves; the window stays.") +
            QStringLiteral("\n\n") + differences(m_draft.applied(), other);
        askFirst({.title = tr("Switch to the mount \"%1\"?").arg(nameOf(other)),
                  .text = lines,
                  .act = tr("Switch"),
                  .request = request::Reconnect{other},
                  .action = Action::Reconnect},
                 m_status);
    });
}

void ProfilePage::duplicate()
{
    const profile::StoredProfile mount = chosen();
    // What was found in a simulation is no mount of its own.
    const bool asApplied = isInForce(mount) && !m_status.simulated;
    if (mount.path.isEmpty() && !asApplied) {
        warn(tr("The simulated mount has no profile that can be duplicated"));
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
        write(work, tr("\"%1\" is kept as a mount of its own").arg(name));
    };
    askFirst(
        {.title = tr("Duplicate the mount \"%1\"?").arg(mount.mountName),
         .text = tr("A new mount with the same settings. What this one remembers, such as the turns of its axes, is "
                    "not copied."),
         .act = tr("Duplicate"),
         .request = {},
         .perform = perform,
         .typedName = tr("Name of the new mount"),
         .typed = tr("%1 copy").arg(mount.mountName)},
        m_status);
}

void ProfilePage::rename()
{
    const profile::StoredProfile mount = chosen();
    const auto perform = [this, mount](const QString& name) {
        if (isInForce(mount)) {
            profile::Profile renamed = m_draft.edited();
            if (const Result<> fits = setName(renamed, name); !fits) {
                warn(text(fits.error()));
                return;
            }
            m_draft.edit([&renamed](profile::Profile& profile) { profile = renamed; });
            tell(tr("Apply keeps the new name; Reconnect puts it in force"));
            return;
        }
        const auto work = [mount, name, store = m_store] {
            return profile::loadProfile(mount.path).and_then([&](profile::Profile profile) {
                return setName(profile, name).and_then([&] { return store.save(profile, mount.path); });
            });
        };
        write(work, tr("The mount is called \"%1\" now").arg(name));
    };
    askFirst(
        {.title = tr("Rename the mount \"%1\"?").arg(mount.mountName),
         .text = tr("What a mount remembers is kept under its name: under a new one the turns of the axes are asked "
                    "for again, unless the drives can tell them."),
         .act = tr("Rename"),
         .request = {},
         .perform = perform,
         .typedName = tr("New name of the mount"),
         .typed = mount.mountName},
        m_status);
}

void ProfilePage::remove()
{
    const profile::StoredProfile mount = chosen();
    if (isInForce(mount)) {
        warn(tr("This mount is in force: switch to another one first"));
        return;
    }
    ask(tr("Remove the mount \"%1\"?").arg(mount.mountName),
        tr("It leaves the list. Its file is kept under the name %1.removed.").arg(QFileInfo(mount.path).fileName()),
        tr("Remove"), [this, mount](const QString&) {
            write([mount, store = m_store] { return store.remove(mount.path); },
                  tr("\"%1\" is removed").arg(mount.mountName));
        });
}

void ProfilePage::chooseImport()
{
    const QFileDialog* const dialog = askForFile(*this, tr("Import the profile of a mount"), QFileDialog::AcceptOpen,
                                                 {tr("Profile (*.toml)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &ProfilePage::import);
}

void ProfilePage::import(const QString& file)
{
    load(file, [this](const profile::Profile& read) { askImport(read); });
}

void ProfilePage::askImport(const profile::Profile& read)
{
    const profile::StoredProfile* const mount = stored(nameOf(read));
    if (mount == nullptr) {
        ask(tr("Import the mount \"%1\"?").arg(nameOf(read)),
            tr("It is kept as a mount of its own; nothing else changes.\n\nBus: %1\nBeside the mount in force:\n%2")
                .arg(QString::fromStdString(read.bus), differences(m_draft.applied(), read)),
            tr("Import"), [this, read](const QString&) {
                write([read, store = m_store] { return store.add(read).map([](const QString&) {}); },
                      tr("\"%1\" is kept").arg(nameOf(read)));
            });
    } else if (isInForce(*mount)) {
        ask(tr("Take this file over into \"%1\"?").arg(nameOf(read)),
            tr("This mount is in force. The values come into the page as edits; Apply puts them in force.\n\n%1")
                .arg(differences(m_draft.applied(), read)),
            tr("Take over"),
            [this, read](const QString&) { takeOver(read, profile::changedKeys(m_draft.applied(), read)); });
    } else {
        load(mount->path, [this, read, mount = *mount](const profile::Profile& kept) {
            if (profile::namesNoBus(read) && !profile::namesNoBus(kept)) {
                warn(
                    tr("This file is a profile of the simulated mount. It cannot replace the profile of a real mount. "
                       "To import it, change mount.name in the file."));
                return;
            }
            ask(tr("Overwrite the mount \"%1\"?").arg(nameOf(read)),
                tr("The version of now is kept as the one before.\n\n%1").arg(differences(kept, read)), tr("Overwrite"),
                [this, read, mount](const QString&) {
                    write([read, mount, store = m_store] { return store.save(read, mount.path); },
                          tr("\"%1\" is overwritten").arg(nameOf(read)));
                });
        });
    }
}

void ProfilePage::takeOver(const profile::Profile& from, const std::vector<std::string>& keys)
{
    m_draft.takeOver(from, keys);
    tell(tr("In the page, not applied: %1").arg(m_draft.editedKeys().size()));
}

void ProfilePage::chooseExport()
{
    QFileDialog* const dialog = askForFile(*this, tr("Export the profile of \"%1\"").arg(chosen().mountName),
                                           QFileDialog::AcceptSave, {tr("Profile (*.toml)")});
    dialog->selectFile(chosen().mountName + QStringLiteral(".toml"));
    connect(dialog, &QFileDialog::fileSelected, this, &ProfilePage::exportTo);
}

// Of the mount in force as it is applied: its file may hold what the command line overrides. What was changed in a
// simulation goes without the bus, so that no real mount takes it for its own.
void ProfilePage::exportTo(const QString& file)
{
    const profile::Profile& inForce = m_draft.applied();
    const auto work = [file, mount = chosen(), applied = m_status.simulated ? profile::withoutBus(inForce) : inForce,
                       store = m_store, asApplied = isInForce(chosen())] {
        return asApplied ? profile::saveProfile(applied, file) : store.exportFile(mount.path, file);
    };
    write(work, tr("Written: %1").arg(file));
}

void ProfilePage::takeBack()
{
    const profile::StoredProfile mount = chosen();
    if (mount.path.isEmpty() || !mount.problem.isEmpty()) {
        warn(tr("This mount has no file with a version before"));
        return;
    }
    if (isInForce(mount) && m_draft.hasEdits()) {
        warn(tr("Apply or revert the edits first"));
        return;
    }
    load(mount.path, [this, mount](const profile::Profile& now) {
        load(profile::previousOf(mount.path),
             [this, mount, now](const profile::Profile& before) { askTakeBack(mount, now, before); });
    });
}

void ProfilePage::askTakeBack(const profile::StoredProfile& mount, const profile::Profile& now,
                              const profile::Profile& before)
{
    ask(tr("Take back the last saved change of \"%1\"?").arg(mount.mountName),
        tr("Taking it back can be taken back too.\n\n%1").arg(differences(now, before)), tr("Take back"),
        [this, mount, now, before](const QString&) {
            if (!isInForce(mount)) {
                write([mount, store = m_store] { return store.undo(mount.path).map([](const profile::Profile&) {}); },
                      tr("The last change of \"%1\" is taken back").arg(mount.mountName));
                return;
            }
            takeOver(before, profile::changedKeys(now, before));
            m_draft.apply(this, [this](const std::optional<Error>& error) {
                if (error) {
                    warn(text(*error));
                } else {
                    tell(tr("The last change is taken back"));
                }
            });
        });
}

}  // namespace boresight::ui
