# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian packages that Boresight needs, by purpose. need_packages installs the missing ones. Sourced.
#
# Names as in Debian 12. A name with alternatives, "a|b", means the first one this machine knows.
# shellcheck disable=SC2034  # the lists are used by the scripts that source this file

# Compilers, build tools and every library that is linked. Clang takes two thirds of the time of g++, which builds Qwt.
# Google Test and Benchmark are here because one configured folder serves both packaging/run and packaging/test.
readonly build_packages=(
    'clang-16|clang' g++ cmake ninja-build mold 'pkgconf|pkg-config' ca-certificates
    qt6-base-dev 'qt6-svg-dev|libqt6svg6-dev' 'qt6-serialport-dev|libqt6serialport6-dev'
    qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools
    libgl-dev libexpected-dev libtomlplusplus-dev libarchive-dev libeigen3-dev liberfa-dev libmosquitto-dev libssl-dev
    libsdl2-dev libgtest-dev libgmock-dev libbenchmark-dev
)

# Further packages to build Qwt from Debian's source package.
readonly qwt_source_packages=(bzip2 debian-archive-keyring)

# Packages to run the programs of the presets with sanitizers. The runtime of clang-16 names functions only by
# llvm-symbolizer-16. Without names no line of tests/sanitizers/*.supp has an effect.
readonly sanitizer_packages=(libclang-rt-16-dev llvm-16)

# The checker of the sources. It has the version of the compiler, because it uses the precompiled headers of the
# compiler.
readonly tidy_packages=(clang-tidy-16)

# Programs that the tests run: User-Mode Linux for a real SocketCAN interface, can-utils as an independent check there,
# Hamlib's rotctl and rotctld as peers, the fonts of the usual desktops, the formatter, a real MQTT broker with
# certificates made by openssl, and the checkers of shell scripts, man pages, menu entry and metadata.
readonly test_packages=(
    user-mode-linux kmod iproute2 can-utils libhamlib-utils clang-format-14 shellcheck
    fonts-dejavu-core fonts-noto-core fonts-noto-mono fonts-liberation fonts-cantarell
    man-db desktop-file-utils appstream mosquitto openssl "${sanitizer_packages[@]}" "${tidy_packages[@]}"
)

# Further packages to show the window on a real display, with Qt's own texts in other languages.
readonly display_packages=(qt6-wayland libqt6svg6 qt6-translations-l10n fonts-dejavu-core)

# What tests/bench/run needs.
readonly bench_packages=(libhamlib-utils xvfb xauth)

package_is_installed() {
    dpkg-query -W -f '${db:Status-Status}\n' "$1" 2>/dev/null | grep -qx installed
}

package_is_known() {
    apt-cache show --no-all-versions "$1" >/dev/null 2>&1
}

# Prints one name for each missing entry. Of alternatives it prints the first known one.
missing_packages() {
    local entry name names found
    for entry in "$@"; do
        IFS='|' read -ra names <<<"$entry"
        found=
        for name in "${names[@]}"; do
            package_is_installed "$name" && found=yes
        done
        [[ -n $found ]] && continue
        for name in "${names[@]}"; do
            package_is_known "$name" && break
            name=${names[0]}
        done
        printf '%s\n' "$name"
    done
}

as_root() {
    if [[ $EUID -eq 0 ]]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        return 1
    fi
}

apt_get() {
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@"
}

need_packages() {  # PACKAGE…
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        fail "needs Debian or a system based on it (dpkg and apt). On other systems see packaging/README.md, Building by hand"
    fi
    local -a missing
    mapfile -t missing < <(missing_packages "$@")
    [[ ${#missing[@]} -gt 0 ]] || return 0
    [[ $EUID -eq 0 ]] || command -v sudo >/dev/null ||
        fail "packages are missing, and there is no sudo. Run as root: apt-get install ${missing[*]}"
    say "installing ${missing[*]}"
    # An update that fails for one of several archives does not end the script, because the packages may be in the
    # others.
    apt_get update >/dev/null || say "apt-get update reported a problem. The stored package lists are used"
    mapfile -t missing < <(missing_packages "$@")
    apt_get install -y --no-install-recommends "${missing[@]}" >/dev/null ||
        fail "could not install ${missing[*]} (see the lines above)"
}
