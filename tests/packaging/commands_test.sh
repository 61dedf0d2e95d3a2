#!/usr/bin/env bash
# packaging/setup, run and test, with dpkg-query, apt-get, sudo, cmake and ctest replaced by recorders: what they decide, ask for and say.
# usage: commands_test.sh SOURCE_DIR
set -uo pipefail

scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
tree="$scratch/a clone with spaces"
tools=$scratch/tools
record=$scratch/record
mkdir -p "$tree" "$tools"
cp -R "$1/packaging" "$1/.ci" "$tree/"
failures=0

check() { # WHAT CONDITION...
  local what=$1
  shift
  if "$@"; then
    printf 'ok      %s\n' "$what"
  else
    printf 'FAILED  %s\n' "$what"
    printf '        exit %s; output:\n%s\n        recorded:\n%s\n' "$status" "$output" "$(cat "$record")"
    failures=$((failures + 1))
  fi
}
says() { grep -qF -- "$1" <<<"$output"; }
recorded() { grep -qE -- "$1" "$record"; }
not() { ! "$@"; }

# run_tool COMMAND...: from a foreign folder, without git or a display unless the caller sets one.
run_tool() {
  : >"$record"
  output=$(cd / && PATH=$tools:/usr/bin:/bin "$@" 2>&1)
  status=$?
}

tool() { # NAME BODY: a replacement that records how it was called
  printf '#!/bin/bash\nprintf "%%s\\n" "%s $*" >>"%s"\n%s\n' "$1" "$record" "$2" >"$tools/$1"
  chmod +x "$tools/$1"
}
tool sudo '[[ $1 == -n ]] && exit 0; exec "$@"'
tool apt-get 'exit 0'
tool git 'exit 1'
# Knows every package but the one named in $MISSING.
tool dpkg-query 'for p in "$@"; do [[ $p == -* || $p == "${MISSING:-}" ]] || echo "installed $p"; done; [[ -z ${MISSING:-} ]]'
tool cmake 'if [[ $1 == --build ]]; then
  mkdir -p build/release
  printf "#!/bin/bash\necho program started with: \$*.\nexit ${PROGRAM_STATUS:-0}\n" >build/release/vallecula
  chmod +x build/release/vallecula
  exit ${BUILD_STATUS:-0}
fi'
tool ctest 'echo "slow=${VALLECULA_SLOW:-}"; exit ${CTEST_STATUS:-0}'
unset DISPLAY WAYLAND_DISPLAY VALLECULA_SLOW

for command in setup run test; do
  run_tool "$tree/packaging/$command" --help
  check "$command --help tells its usage" test "$status" -eq 0
  check "$command --help says which command" says "usage: packaging/$command"
  run_tool "$tree/packaging/$command" --nonsense
  check "$command refuses an unknown option with exit code 2" test "$status" -eq 2
  check "$command names the unknown option" says "'--nonsense'"
  check "$command starts nothing then" not recorded 'cmake|apt-get|dpkg'
done

run_tool "$tree/packaging/setup"
check "setup is content when nothing is missing" test "$status" -eq 0
check "setup does not call apt-get when nothing is missing" not recorded 'apt-get|sudo'

MISSING=libgdcm-dev run_tool "$tree/packaging/setup"
check "setup installs what is missing" test "$status" -eq 0
check "setup installs that alone, without recommended packages" recorded 'apt-get .*install --yes --no-install-recommends libgdcm-dev$'
check "setup reads the package lists before" recorded 'apt-get .*update$'

MISSING=libgtest-dev run_tool "$tree/packaging/setup" --program
check "setup --program leaves out what only tests need" not recorded 'apt-get'

tool apt-get '[[ $* != *install* ]]'
MISSING=libgdcm-dev run_tool "$tree/packaging/setup"
check "setup fails when apt-get fails" test "$status" -eq 1
check "setup names the package then" says "could not install: libgdcm-dev"
check "setup says how to mend it" says "To mend:"
MISSING=libgdcm-dev run_tool "$tree/packaging/run"
check "run stops when setup fails" test "$status" -eq 1
check "run builds nothing then" not recorded '^cmake'
tool apt-get 'exit 0'

run_tool "$tree/packaging/run"
check "run without a display runs the demo" says "program started with: demo."
check "run succeeds with the demo" test "$status" -eq 0
check "run builds without tests" recorded 'cmake --preset release -DVALLECULA_TESTS=OFF'
check "run asks git for nothing" not recorded '^git'
DISPLAY=:99 run_tool "$tree/packaging/run"
check "run with a display opens the trainer" says "program started with: ."
DISPLAY=:99 run_tool "$tree/packaging/run" --demo
check "run --demo runs the demo all the same" says "program started with: demo."
PROGRAM_STATUS=1 run_tool "$tree/packaging/run"
check "run hands on the demo's failure" test "$status" -eq 1
BUILD_STATUS=1 run_tool "$tree/packaging/run"
check "run fails when building fails" test "$status" -eq 1
check "run starts nothing when building fails" not says "program started"
check "run says how to mend the build" says "To mend:"

printf 'CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n' >"$tree/build/release/CMakeCache.txt"
run_tool "$tree/packaging/run"
check "a clone that was moved is configured afresh" recorded 'cmake --preset release --fresh'

run_tool "$tree/.ci/run"
check "the CI command runs the tests" recorded '^ctest --preset release'
check "test builds with tests" recorded 'cmake --preset release .*-DVALLECULA_TESTS=ON'
run_tool "$tree/packaging/test" --slow
check "test --slow asks for the long forms" says "slow=1"
CTEST_STATUS=8 run_tool "$tree/packaging/test"
check "test fails when a test fails" test "$status" -eq 1

run_tool "$tree/packaging/setup" --list
check "setup does not ask for the fuzzer's compiler" not says "clang-14"
run_tool "$tree/packaging/setup" --fuzz --list
check "setup --fuzz does" says "clang-14"
mkdir -p "$tree/build/fuzz"
for target in fuzz_seeds fuzz_ct_parse fuzz_ct_reader fuzz_falcon_packets fuzz_spacemouse_report; do
  printf '#!/bin/bash\nprintf "%%s\\n" "%s $*" >>"%s"\n[[ %s == fuzz_seeds ]] || exit ${FUZZ_STATUS:-0}\n' "$target" "$record" "$target" >"$tree/build/fuzz/$target"
  chmod +x "$tree/build/fuzz/$target"
done
run_tool "$tree/packaging/test" --fuzz 30
check "test --fuzz builds the targets" recorded 'cmake --build --preset fuzz .*--target fuzz_seeds fuzz_ct_parse fuzz_ct_reader fuzz_falcon_packets fuzz_spacemouse_report'
check "test --fuzz builds the helper program" recorded 'cmake --build --preset release .*--target vallecula-ct$'
check "test --fuzz runs each for its share of the time" recorded '^fuzz_ct_reader .*-max_total_time=8 '
check "test --fuzz runs no tests" not recorded '^ctest'
check "test --fuzz is content when nothing is found" test "$status" -eq 0
run_tool "$tree/packaging/test" --fuzz
check "test --fuzz has a time of its own" recorded '^fuzz_ct_parse .*-max_total_time=15 '
FUZZ_STATUS=77 run_tool "$tree/packaging/test" --fuzz 2
check "test --fuzz fails when a target finds something" test "$status" -eq 1

printf '%s checks failed\n' "$failures"
exit $((failures > 0))
