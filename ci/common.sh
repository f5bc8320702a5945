# What the scripts of ci/ share: where the tools are, and how a script speaks. Sourced, not run.
# shellcheck shell=bash

set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$top"

ppc64=powerpc64-unknown-linux-gnu
# build.rs looks for the SPU tools here too, after the variables and PATH.
spu_binutils=${XDG_CACHE_HOME:-$HOME/.cache}/cellray/spu-binutils
# A kernel of the distribution, unpacked, for the machine that ci/fbdev runs.
linux=${XDG_CACHE_HOME:-$HOME/.cache}/cellray/linux
out=$top/target/ci

say() { printf '== %s\n' "$*" >&2; }
die() { printf 'error: %s\n' "$*" >&2; exit 1; }
have() { command -v "$1" >/dev/null 2>&1; }

# The SPU tool NAME (as, ld, objdump, ...): by variable, by name on PATH, or from the cache.
spu_tool() {
    local name=$1 variable candidate
    variable=SPU_$(printf '%s' "$name" | tr '[:lower:]' '[:upper:]')
    for candidate in "${!variable:-}" "spu-elf-$name" "spu-$name" "$spu_binutils/bin/spu-elf-$name"; do
        if [ -n "$candidate" ] && have "$candidate"; then
            command -v "$candidate"
            return
        fi
    done
    return 1
}

# The kernel in $linux.
linux_image() {
    local image
    image=$(ls "$linux"/boot/vmlinuz-* 2>/dev/null | tail -1)
    [ -n "$image" ] && printf '%s\n' "$image"
}

# Runs a step and says how long it took.
step() {
    local what=$1 start=$SECONDS
    shift
    say "$what"
    "$@"
    say "$what: $((SECONDS - start)) s"
}

# This machine's programs as the tests have them: optimised, too, and built with the tests, once.
host=${CARGO_TARGET_DIR:-$top/target}/debug
build_for_host() { step "build for the host" cargo test --quiet --workspace --no-run; }
