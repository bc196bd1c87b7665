# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# need_qwt: stores in QWT_ARGUMENTS the arguments with which CMake finds a Qwt for Qt 6. Sourced after packages.sh.
#
# It uses the package of the distribution if there is one. Debian 12 and 13 and Ubuntu 24.04 have Qwt only for Qt 5.
# There it builds Qwt 6.3.0 once from Debian's source package into the user's cache. The script names no host: it uses
# the archive of this machine's apt. apt checks signatures and sums, and the script checks the sum of the tarball, too.
# Environment: QWT_ROOT=PREFIX uses another Qwt, QWT_TARBALL=FILE builds from this tarball (offline).

readonly qwt_version=6.3.0
readonly qwt_sha256=dcb085896c28aaec5518cbc08c0ee2b4e60ada7ac929d82639f6189851a6129a

# shellcheck disable=SC2034  # QWT_ARGUMENTS is read by build_preset
need_qwt() {
    QWT_ARGUMENTS=()
    step "Qwt, the library of the plots"
    if [[ -n ${QWT_ROOT:-} ]]; then
        QWT_ARGUMENTS=("-DQwt_ROOT=$QWT_ROOT")
    elif qwt_of_the_distribution; then
        return 0
    else
        local prefix
        prefix=$(qwt_cache)/qwt-$qwt_version
        [[ $(cat "$prefix/stamp" 2>/dev/null) == "$(qwt_stamp)" ]] || build_qwt "$prefix"
        QWT_ARGUMENTS=("-DQwt_ROOT=$prefix")
    fi
}

# A Qwt that is installed where FindQwt.cmake looks, or one that apt offers.
qwt_of_the_distribution() {
    if ! package_is_installed libqwt-qt6-dev && package_is_known libqwt-qt6-dev; then
        need_packages libqwt-qt6-dev
    fi
    # Only the library's name distinguishes a Qwt for Qt 6 from a Qwt for Qt 5.
    /sbin/ldconfig -p 2>/dev/null | grep -qE 'libqwt6?-qt6\.so'
}

# The things that the library depends on. Another Qt, another compiler or other parts need another build.
qwt_stamp() {
    printf 'qwt %s qt %s g++ %s parts %s\n' "$qwt_version" \
        "$(dpkg-query -W -f '${Version}' qt6-base-dev)" "$(g++ -dumpfullversion)" \
        "$(cksum <"$BORESIGHT_TOP/packaging/qwt/CMakeLists.txt")"
}

# The user's cache, so that several checkouts share one build. Without a home folder, the folder of the checkout.
qwt_cache() {
    local cache=${XDG_CACHE_HOME:-${HOME:+$HOME/.cache}}
    if [[ -n $cache ]] && mkdir -p "$cache/boresight" 2>/dev/null && [[ -w $cache/boresight ]]; then
        printf '%s\n' "$cache/boresight"
    else
        mkdir -p "$BORESIGHT_TOP/.cache"
        printf '%s\n' "$BORESIGHT_TOP/.cache"
    fi
}

build_qwt() {  # PREFIX
    local prefix=$1 work tarball
    # shellcheck disable=SC2154  # defined in packages.sh
    need_packages "${qwt_source_packages[@]}"
    say "building Qwt $qwt_version for Qt 6 (once, less than a minute)"
    work=$(mktemp -d)
    # shellcheck disable=SC2064  # the folder's name is wanted as it is now
    trap "rm -rf '$work'" EXIT
    tarball=${QWT_TARBALL:-}
    if [[ -z $tarball ]]; then
        fetch_qwt "$work/fetch"
        tarball=$(find "$work/fetch" -name 'qwt_*.orig.tar.*' -print -quit)
    fi
    [[ $(sha256sum <"$tarball") == "$qwt_sha256  -" ]] ||
        fail "$tarball is not the tarball of Qwt $qwt_version: its sha256 differs"
    mkdir "$work/source"
    tar -xf "$tarball" --no-same-owner --strip-components=1 -C "$work/source"
    compile_qwt "$work" "$prefix"
    rm -rf "$work"
    trap - EXIT
}

compile_qwt() {  # WORK PREFIX
    local work=$1 prefix=$2
    quietly "$work/configure.log" cmake -S "$BORESIGHT_TOP/packaging/qwt" -B "$work/build" -G Ninja \
        -DCMAKE_BUILD_TYPE=Release -DQWT_SOURCE="$work/source" -DCMAKE_INSTALL_PREFIX="$prefix" ||
        fail "could not configure Qwt"
    NINJA_STATUS=$(ninja_status) cmake --build "$work/build" --parallel "$(parallel_jobs)" >&2 || fail "could not build Qwt"
    rm -rf "$prefix"
    quietly "$work/install.log" cmake --install "$work/build" || fail "could not write $prefix"
    qwt_stamp >"$prefix/stamp"
}

# The address of the Debian archive in this machine's apt configuration. apt lists only what it has fetched.
debian_archive() {
    # shellcheck disable=SC2016  # apt's own variables
    apt-get indextargets --format '$(LABEL)|$(COMPONENT)|$(REPO_URI)' 'Created-By: Packages' 2>/dev/null |
        awk -F'|' '$1 == "Debian" && $2 == "main" && !found { found = $3 } END { print found }'
}

# Fetches the upstream tarball of Debian's source package into FOLDER. apt gets its own list, index and cache there, so
# the apt state of the machine does not change. Only the tarball is fetched. Debian's patches are not needed. A mirror
# with an old index may have removed the files that name the Debian revision. An old index is accepted, too, because the
# sum of the tarball is known.
fetch_qwt() {  # FOLDER
    local folder=$1 archive suite private version
    archive=$(debian_archive)
    if [[ -z $archive ]]; then
        apt_get update >/dev/null || true
        archive=$(debian_archive)
    fi
    [[ -n $archive ]] || fail "apt knows no Debian archive with Qwt. Set QWT_TARBALL=FILE to a tarball of Qwt $qwt_version"
    for suite in sid forky; do
        mkdir -p "$folder/$suite/lists/partial" "$folder/$suite/cache/archives/partial" "$folder/$suite/tarball"
        printf 'deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] %s %s main\n' \
            "$archive" "$suite" >"$folder/$suite/sources.list"
        private=(-q -o "Dir::Etc::SourceList=$folder/$suite/sources.list" -o Dir::Etc::SourceParts=-
            -o "Dir::State::Lists=$folder/$suite/lists" -o "Dir::Cache=$folder/$suite/cache"
            -o "APT::Sandbox::User=$(id -un)" -o Acquire::Languages=none -o Acquire::Retries=3
            -o Acquire::Check-Valid-Until=false -o Acquire::Check-Date=false)
        quietly "$folder/$suite/log" apt-get "${private[@]}" update || continue
        version=$(apt-cache "${private[@]}" showsrc --only-source qwt 2>/dev/null |
            awk -v wanted="$qwt_version-" '$1 == "Version:" && index($2, wanted) == 1 { found = $2 } END { print found }')
        [[ -n $version ]] || continue
        (cd "$folder/$suite/tarball" &&
            quietly "$folder/$suite/log" apt-get "${private[@]}" source --download-only --tar-only "qwt=$version") &&
            return 0
    done
    fail "Debian's archive does not have the source of Qwt $qwt_version. Set QWT_TARBALL=FILE to its tarball"
}
