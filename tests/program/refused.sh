#!/usr/bin/env bash
# Faults of the system during a run: a limit on the size of files, a full disk, a read-only folder, a deleted folder.
# Exit code 4 and one sentence with the name of the file; finished files are intact; the resumed run ends with the same
# results.
# usage: refused.sh FRANA SOURCE WORK LOOK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
look=$(realpath "$4")
scene | sed -e '/name: flow/s/steps: [0-9]*/steps: 220/; /name: settle/s/steps: [0-9]*/steps: 20/' \
  -e '/name: fracture/s/steps: [0-9]*/steps: 20/' \
  -e 's/fields_every: .*/fields_every: 200/; s/checkpoint_every: .*/checkpoint_every: 100/' >scene.yaml
code 0 ranks 2 run scene.yaml --out whole

# begin FOLDER [COMMAND...]: starts a run of two ranks in the background and stops it (SIGSTOP) at its first checkpoint,
# a hundred steps before all ranks write a file again.
# The caller can then change the folder before the run ends, however busy the machine is.
begin() {
  local folder=$1
  said=$PWD/${1//\//_}; shift
  while :; do
    "$@" mpiexec -n 2 "$frana" run "$PWD/scene.yaml" --out "$folder" >"$said.out" 2>"$said.err" &
    mpiexec=$!
    await "$mpiexec" test -f "$folder/checkpoint/latest" ||
      { cat "$said.out" "$said.err" >&2; fail "$folder: no checkpoint"; }
    # shellcheck disable=SC2207 # numbers
    pids=($(ranks_of "$mpiexec" || true))
    ((${#pids[@]} == 2)) && kill -STOP "${pids[@]}" && ! grep -q '"status": *"done"' "$folder/run.json" && return
    ((${#pids[@]} == 0)) || kill -CONT "${pids[@]}" 2>/dev/null || true
    wait "$mpiexec" || true # it was done before: once more
    find "$folder" -mindepth 1 -delete
  done
}
# After frana has ended with code 4, the launcher may fail in its own finalize.
refused() { # FOLDER WHY
  local got=0
  kill -CONT "${pids[@]}"
  wait "$mpiexec" || got=$?
  [ "$got" = 4 ] || grep -q 'with errorcode 4' "$said.err" || { cat "$said.err" >&2; fail "$2: exit code $got"; }
  [ "$(grep -c '^frana: ' "$said.err")" = 1 ] || { cat "$said.err" >&2; fail "$2: not one sentence"; }
  grep -Eq "^frana: (rank 0: )?$1/[a-z0-9_/.]+: cannot be written: $2" "$said.err" ||
    { cat "$said.err" >&2; fail "$2: not what was to be said"; }
  echo "$(grep '^frana: ' "$said.err")"
}
whole() { # FOLDER [COMMAND...]: no file is damaged, and the run can be resumed
  local folder=$1; shift
  "$look" "$folder" >found || { cat found >&2; fail "$folder: damaged"; }
  code 0 "$@" mpiexec -n 2 "$frana" run "$PWD/scene.yaml" --out "$folder" --resume
  same whole/series.csv "$folder/series.csv"
  [ "$("$look" "$folder" | tail -n 1)" = "$("$look" whole | tail -n 1)" ] ||
    fail "$folder: other files than of the uninterrupted run"
}

# a limit on the size of files: of the growing series; of checkpoints and fields
begin limit
for pid in "${pids[@]}"; do prlimit --pid "$pid" --fsize=1000:1000; done
refused limit 'File too large'
whole limit

# the folder is deleted, then made again
begin gone
mv gone away
refused gone 'No such file or directory'
mv away gone
whole gone

# read-only, for a user other than root
user=()
if [ "$(id -u)" = 0 ]; then
  user=(setpriv --reuid=65534 --regid=65534 --clear-groups env "HOME=$PWD/readonly.home"
    "XDG_CACHE_HOME=$PWD/readonly.home")
  mkdir readonly.home && chown 65534:65534 readonly.home
fi
if "${user[@]}" "$frana" --version >/dev/null 2>&1 && "${user[@]}" test -r "$PWD/scene.yaml"; then
  mkdir readonly && [ ${#user[@]} = 0 ] || chown 65534:65534 readonly
  begin readonly "${user[@]}"
  chmod a-w readonly/checkpoint readonly/fields readonly
  refused readonly 'Permission denied'
  chmod u+w readonly/checkpoint readonly/fields readonly
  whole readonly "${user[@]}"
else
  echo "no other user can run frana here: the read-only folder is left out"
fi

# a full disk
mkdir small
if mount -t tmpfs -o size=24m tmpfs small 2>/dev/null; then
  trap 'umount -l "$work/small"' EXIT
  begin small/run
  cat /dev/zero >small/ballast 2>/dev/null || true
  refused small/run 'No space left on device'
  rm small/ballast
  whole small/run
else
  echo "no small file system can be mounted here: the full disk is left out"
fi
echo ok
