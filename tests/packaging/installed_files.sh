#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# installed_files.sh CHECK BUILD_FOLDER WITH_WINDOW
#
# Installs the built programs into an empty folder, as a package would be made, and makes one CHECK of what is there.
# Status 0: passed. 77: the tool for the check is missing. Otherwise the reasons are on standard output.

set -euo pipefail

check=$1 build=$2 with_window=$3
programs=(boresightd boresightctl)
[[ $with_window -eq 0 ]] || programs+=(boresight)
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
prefix=$(sed -n 's/^CMAKE_INSTALL_PREFIX:PATH=//p' "$build/CMakeCache.txt")
there=$root$prefix

need() {  # TOOL
    command -v "$1" >/dev/null || {
        echo "$1 is not installed"
        exit 77
    }
}

installed() {
    local file missing=0
    local -a expected=(
        lib/systemd/system/boresightd.service lib/udev/rules.d/70-boresight-fdcanusb.rules
        "${programs[@]/#/bin/}"
    )
    for file in "${programs[@]}"; do
        expected+=("share/man/man1/$file.1")
    done
    [[ $with_window -eq 0 ]] || expected+=(
        share/applications/boresight.desktop share/metainfo/boresight.metainfo.xml
        share/icons/hicolor/scalable/apps/boresight.svg
    )
    for file in "${expected[@]}"; do
        [[ -s $there/$file ]] || {
            echo "missing: $file"
            missing=1
        }
    done
    "$there/bin/boresightd" --version
    grep -qx "ExecStart=$prefix/bin/boresightd .*" "$there/lib/systemd/system/boresightd.service" || {
        echo "the service does not start the installed program"
        missing=1
    }
    return "$missing"
}

# The settings that the program needs: the limits that it requests, the watchdog that it feeds, and a folder for its
# local socket.
service_unit() {
    local unit=$there/lib/systemd/system/boresightd.service line status=0
    # shellcheck disable=SC2016  # systemd expands it
    for line in 'ExecReload=/bin/kill -HUP $MAINPID' 'WatchdogSec=10' 'LimitRTPRIO=20' 'LimitMEMLOCK=infinity' 'Type=notify' \
        'RuntimeDirectory=boresight' 'RuntimeDirectoryMode=0700' 'Environment=XDG_RUNTIME_DIR=%t'; do
        grep -qxF -- "$line" "$unit" || {
            echo "the service has no $line"
            status=1
        }
    done
    ! grep -q '^RestrictRealtime=yes' "$unit" || {
        echo "the service may not have the real-time scheduling that its limits grant"
        status=1
    }
    return "$status"
}

manuals_without_warnings() {
    local page warnings status=0
    need man
    for page in "$there"/share/man/man1/*.1; do
        warnings=$(LC_ALL=C.UTF-8 MANWIDTH=80 MANROFFSEQ='' man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null)
        [[ -z $warnings ]] || {
            echo "${page##*/}: $warnings"
            status=1
        }
    done
    return "$status"
}

# The options of --help, without those of every Qt program.
manuals_name_every_option() {
    local program option options status=0
    for program in "${programs[@]}"; do
        [[ $program != boresightctl ]] || continue
        options=$(QT_QPA_PLATFORM=offscreen "$there/bin/$program" --help |
            grep -o '^ *\(-., \)\?--[a-z-]*' | grep -o -- '--[a-z-]*' | grep -vx -- --help-all)
        for option in $options; do
            grep -qF -- "${option//-/\\-}" "$there/share/man/man1/$program.1" || {
                echo "$program.1 does not name $option"
                status=1
            }
        done
    done
    return "$status"
}

menu_entry() {
    need desktop-file-validate
    desktop-file-validate --no-hints "$there/share/applications/boresight.desktop"
}

# The project has no domain for its id.
metadata() {
    need appstreamcli
    appstreamcli validate --no-net --no-color --override=cid-desktopapp-is-not-rdns=info \
        "$there/share/metainfo/boresight.metainfo.xml"
    grep -q '<launchable type="desktop-id">boresight.desktop<' "$there/share/metainfo/boresight.metainfo.xml"
}

case $check in
    menu_entry | metadata)
        [[ $with_window -ne 0 ]] || {
            echo "built without the window"
            exit 77
        }
        ;;
esac
DESTDIR=$root cmake --install "$build" >/dev/null
"$check"
