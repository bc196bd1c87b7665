# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Configuring and building a preset of CMakePresets.json. Sourced after qwt.sh.

# One job per core, but no more than the memory permits: a compiler on Qt code takes up to 1 GB, with sanitizers 1.5 GB.
parallel_jobs() {
    local cores memory
    cores=$(nproc)
    memory=$(awk '$1 == "MemAvailable:" { print int($2 / 1500000) }' /proc/meminfo)
    [[ $memory -ge 1 ]] || memory=1
    echo $((cores < memory ? cores : memory))
}

# Ninja decides what to build, and runs CMake again when a CMakeLists.txt has changed.
build_preset() {  # PRESET [TARGET…]
    step "building build/$1"
    local preset=$1 folder=$BORESIGHT_TOP/build/$1 wanted compiler=()
    shift
    mkdir -p "$folder"
    command -v clang++-16 >/dev/null || compiler=(-DCMAKE_CXX_COMPILER=clang++)  # of another Debian
    wanted="${QWT_ARGUMENTS[*]} $(cksum <"$BORESIGHT_TOP/CMakePresets.json")"
    if [[ ! -f $folder/build.ninja || $(cat "$folder/configured-with" 2>/dev/null) != "$wanted" ]]; then
        say "configuring build/$preset"
        (cd "$BORESIGHT_TOP" &&
            quietly "$folder/configure.log" cmake --fresh --preset "$preset" "${QWT_ARGUMENTS[@]}" "${compiler[@]}") ||
            fail "could not configure the preset $preset (build/$preset/configure.log)"
        printf '%s\n' "$wanted" >"$folder/configured-with"
    fi
    (cd "$BORESIGHT_TOP" && NINJA_STATUS=$(ninja_status) cmake --build --preset "$preset" --parallel "$(parallel_jobs)" ${1:+--target "$@"}) >&2 ||
        fail "could not build the preset $preset"
}
