# The common part of the scripts in ci/: the places of the tools, and messages. Scripts source this
# file. shellcheck shell=bash

set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$top"

ppc64=powerpc64-unknown-linux-gnu
# Static programs for the console.
musl=powerpc64-unknown-linux-musl
ppc=powerpc-unknown-linux-gnu
# build.rs looks for the SPU tools here, too, after the variables and PATH.
spu_binutils=${XDG_CACHE_HOME:-$HOME/.cache}/cellray/spu-binutils
# The SPU compiler that ci/spu-gcc builds.
spu_gcc=${XDG_CACHE_HOME:-$HOME/.cache}/cellray/spu-gcc
# The distribution's kernel, unpacked, for the machine that ci/fbdev runs.
linux=${XDG_CACHE_HOME:-$HOME/.cache}/cellray/linux
out=$top/target/ci

report() { printf '== %s\n' "$*" >&2; }
die() { printf 'error: %s\n' "$*" >&2; exit 1; }
have() { command -v "$1" >/dev/null 2>&1; }

# Prints the path of the SPU tool NAME (as, ld, objdump, ...): from its variable, from PATH, or
# from the cache.
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

# Prints the path of the kernel in $linux.
linux_image() {
    local image
    image=$(ls "$linux"/boot/vmlinuz-* 2>/dev/null | tail -1)
    [ -n "$image" ] && printf '%s\n' "$image"
}

# put NAME TABLE: replaces a table in the document that has lines for it. The rest of the document
# stays.
put() {
    local name=$1 table=$2 document
    document=$(grep -l "^<!-- $name: written by" README.md docs/*.md play/browser/README.md) || die "no document has lines for the table $name"
    awk -v name="$name" -v table="$table" '
        index($0, "<!-- " name ": written by") == 1 {
            print; print ""
            while ((getline line < table) > 0) print line
            print ""; inside = 1; next
        }
        inside && /^<!-- end of what is written -->/ { inside = 0 }
        !inside { print }' "$document" >"$out/document"
    grep -q . "$out/document" || die "$document would be empty"
    cat "$out/document" >"$document"
    report "written to $document: $name"
}

# Whether checks that take long and seldom find anything are run, too: ci/full asks for them.
full() { [ -n "${CELLRAY_FULL:-}" ]; }

# Runs a step and reports how long it took.
step() {
    local what=$1 start=$SECONDS
    shift
    report "$what"
    "$@"
    report "$what: $((SECONDS - start)) s"
}

# Begins a step that runs beside those that follow. Its output goes to a file, so that it is not
# mixed with theirs; `join` waits for it, and prints that. If another step fails before, the
# script's end ends it.
beside() {
    local what=$1
    shift
    mkdir -p "$out"
    beside_what=$what beside_log=$out/beside-${0##*/}.txt
    report "$what, beside what follows: $beside_log"
    # In a process group of its own, with all that it starts.
    set -m
    step "$what" "$@" </dev/null >"$beside_log" 2>&1 &
    beside_step=$!
    set +m
    trap 'kill -- -$beside_step 2>/dev/null || true; wait $beside_step || true' EXIT
}
join() {
    local failed=
    wait "$beside_step" || failed=yes
    trap - EXIT
    cat "$beside_log" >&2
    [ -z "$failed" ] || die "failed: $beside_what"
}

# The host's programs from the tests' build, so that nothing is built twice.
host=${CARGO_TARGET_DIR:-$top/target}/debug
# Incremental builds make the first one slower, and write 20 GB. Only a folder that has such files
# already gets more.
[ -d "$host/incremental" ] || export CARGO_INCREMENTAL=0
build_for_host() { step "build for the host" cargo test --quiet --workspace --no-run; }

# The console's programs, and all else that is run under QEMU.
packages_for_ppc64=(-p cellray -p cellray-play -p shader-example -p libspe2 -p ps3fb -p spufs)
! full || packages_for_ppc64+=(-p accuracy)
build_for_ppc64() { cargo build --release --quiet --target "$ppc64" "${packages_for_ppc64[@]}"; }
