// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/kept_profile.h"
#include "app/next_profile.h"
#include "app/options.h"
#include "core/profile/profile.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_store.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <map>

namespace boresight::app {

inline profile::Profile realMount(const char* name = "Roof")
{
    profile::Profile real;
    real.mount.name = name;
    real.bus = "fdcanusb:/dev/mount";
    real.pointing.azimuthOffset = 12_deg;
    real.azimuth.geometry.offset = 3_deg;
    return real;
}

// The objects that the worker of a ProfileSaver has, here without a worker.
struct Profiles
{
    explicit Profiles(const Options& options) : kept(options), choosing(options, kept), first(take(choosing.first())) {}

    profile::Profile next(const profile::Profile& wanted) { return take(choosing.next(wanted)); }
    void save(const profile::Profile& wanted)
    {
        if (const Result<> saved = kept.save(wanted); !saved) {
            reason = saved.error().text;
        }
    }
    profile::Profile take(const NextProfile::Choice& choice)
    {
        if (!choice.problems.isEmpty()) {
            reason = choice.problems.constLast();
        }
        return choice.profile;
    }

    QString reason;  // why it was not saved, or why it is not the wanted one
    KeptProfile kept;
    NextProfile choosing;
    profile::Profile first;
};

// The folders of a program and its options.
struct ProfileRig
{
    QTemporaryDir folder;
    Options options = {.profile = {}, .profilePath = {}, .configDir = config(), .stateDir = state()};

    [[nodiscard]] QString config() const { return folder.filePath(QStringLiteral("config")); }
    [[nodiscard]] QString state() const { return folder.filePath(QStringLiteral("state")); }
    [[nodiscard]] profile::ProfileStore store() const { return profile::ProfileStore(config()); }
    [[nodiscard]] profile::Profile loaded() const { return *profile::loadProfile(options.profilePath); }

    // Stores the profile as the current mount, and starts the program with it.
    void keep(const profile::Profile& profile)
    {
        options.profilePath = *store().add(profile);
        ASSERT_TRUE(store().setCurrent(options.profilePath));
        options.profile = profile;
    }
    void simulate()  // by the command line
    {
        options.simulation = Simulation::Reference;
    }
    // The profile at the start of the program with these options.
    [[nodiscard]] profile::Profile first() const { return Profiles(options).first; }

    // Saves with a program that was started with these options. Returns why it was not saved.
    [[nodiscard]] QString save(const profile::Profile& wanted) const
    {
        Profiles profiles(options);
        profiles.save(wanted);
        return profiles.reason;
    }

    // Every file of the real mounts, byte for byte.
    [[nodiscard]] std::map<QString, QByteArray> realFiles() const
    {
        std::map<QString, QByteArray> all;
        QDirIterator files(config(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            EXPECT_TRUE(file.open(QIODevice::ReadOnly));
            all[file.fileName()] = file.readAll();
        }
        return all;
    }
};

}  // namespace boresight::app
