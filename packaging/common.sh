# What the packaging commands share. Sourced by them, never run: bash, no git needed, any working directory, any clone path.
set -euo pipefail

source_dir=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
build_dir=$source_dir/build/release

say() { printf '%s\n' "== $*"; }

# fail CODE WHAT MEND: one message, then out. Codes as the program's own: 1 the work failed, 2 wrong usage.
fail() {
  printf '%s\n' "packaging/$(basename -- "$0"): $2" "  To mend: $3" >&2
  exit "$1"
}

# As many compilers at once as there are processors, but never more than memory holds: a VTK and Qt file takes about 1 GB.
build_jobs() {
  local processors gigabytes
  processors=$(nproc)
  gigabytes=$(awk '/^MemAvailable:/ { print int($2 / 1048576) }' /proc/meminfo 2>/dev/null || true)
  if [[ -n $gigabytes && $gigabytes -lt $processors ]]; then
    processors=$((gigabytes > 1 ? gigabytes : 1))
  fi
  printf '%s\n' "$processors"
}

# build ON|OFF [TARGET...]: the release preset, with or without the tests ("": as they were). Only what changed is built again.
build() { build_preset release "$@"; }

# build_preset PRESET ON|OFF|"" [TARGET...]
build_preset() {
  local preset=$1 tests=${2:+-DVALLECULA_TESTS=$2} targets=("${@:3}") fresh=()
  local build_dir=$source_dir/build/$preset
  cd -- "$source_dir"
  if [[ -e $source_dir/build && ! -w $source_dir/build ]] || [[ ! -e $source_dir/build && ! -w $source_dir ]]; then
    fail 1 "cannot write to $source_dir/build" "give this user the folder (it may have been made by root), or clone to a place of your own"
  fi
  # A tree that was moved or copied takes its old paths along in the cache; CMake refuses them.
  if [[ -f $build_dir/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$source_dir" "$build_dir/CMakeCache.txt"; then
    fresh=(--fresh)
  fi
  say "Configuring ($preset)"
  # CMake's words go to a file: GDCM's package complains at length of programs that nobody asked it for.
  mkdir -p "$build_dir"
  cmake --preset "$preset" "${fresh[@]}" ${tests:+"$tests"} > "$build_dir/configure.log" 2>&1 || {
    cat "$build_dir/configure.log" >&2
    fail 1 "configuring failed; the first error above names what is missing" \
      "run packaging/setup; if it persists, remove $source_dir/build and run this again"
  }
  say "Building ($preset), $(build_jobs) at a time"
  cmake --build --preset "$preset" --parallel "$(build_jobs)" ${targets[@]:+--target "${targets[@]}"} ||
    fail 1 "building failed; the first error above names the file and the line" \
      "mend that file; if the compiler was killed, memory ran out: close other programs and run this again; a full disk shows in 'df -h'"
}
