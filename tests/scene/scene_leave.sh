#!/bin/sh
# scene_leave.sh SCENES COMMAND...: all the command's ranks exit with code 2 on a scene with mistakes, and each mistake
# is reported once.
scenes=$1
shift
expect() { # code, expected lines (one for each mistake), arguments...
    code=$1 want=$2
    shift 2
    said=$("$@" 2>&1 >/dev/null)
    got=$?
    said=$(printf '%s\n' "$said" | grep '^frana: ')
    if [ "$got" != "$code" ] || [ "$said" != "$want" ]; then
        printf 'code %s, should be %s; said:\n%s\nshould be:\n%s\n' "$got" "$code" "$said" "$want"
        exit 1
    fi
}
expect 0 'frana: 3 stages' "$@" "$scenes/coupled.yaml"
expect 2 "frana: --set fluid.density = 0: must be greater than 0
frana: --set stages.flow.stepz: unknown key; did you mean steps?" \
    "$@" "$scenes/coupled.yaml" fluid.density=0 stages.flow.stepz=1
expect 2 "frana: $scenes/none.yaml: the scene cannot be read: No such file or directory" "$@" "$scenes/none.yaml"
