#!/usr/bin/env bash
# tools/layers.sh: every #include must go to the same layer or to a lower one, and only base/ may use MPI.
#
# Rooms, then the folders of each room, from the lowest layer to the highest. Folders on one line are one layer: they do
# not include each other. A file is named where it stands in another layer than its folder. In a room, files that no
# line names (those beside the folders) are the highest layer.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
layers() {
    cat <<'TABLE'
rooms
    base
    base/files physics stokes
    scene
    fluid solid meshless
    ibm cracks
    coupling
    program/bench postproc
    program/study
    program
scene
    scene.h
    text
    turn.h turn.c
    outline.h outline.c shape.h shape.c medium.h medium.c notch.h notch.c
    keys
    check
fluid
    grid/grid.h fluid.h internal.h
    poisson
    grid
    momentum
    measure
solid
    input.h state.h
    geometry voxels
    law
    body
    bonds
    imposed
    contact
    force
    step
    measure
    surface
    build.h build.c
    refine
    snapshot_items.h snapshot_items.c state_table.h state_table.c snapshot.h snapshot.c
meshless
    arrange
    galerkin nonlocal
    problem
ibm
    kernel.h row.h cell.h ibm.h state.h
coupling
    medium setup
    interface/markers.h interface/wall_probes.h load/load.h control/step_control.h control/origins.h
    control/settle.h control/trend.h control/trend.c control/steady.h control/momentum.h control/sample_watch.h
    control/probe_watch.h control/probe_energy.h control/watch.h
    run.h
    interface
    run_state.h run_state.c
    control
    load
postproc
    options.h facts.h gnuplot.h gnuplot.c
    data
    draw
    charts
    sections
program
    command
    output
    check
    run
    calibrate permeability
program/study
    text.h text.c expression.h expression.c
    file
    runs
    result
    report
TABLE
}
files=$(git ls-files '*.c' '*.h')
# shellcheck disable=SC2086 # a list
{
    layers
    echo end
    grep -Hn '^#include ["<]' $files
} | awk '
    /^end$/ { reading = 1; next }
    !reading && /^[a-z]/ { room = $1; depth = 0; next }
    !reading {
        depth++
        for (i = 1; i <= NF; i++) {
            layer[room, $i] = depth
            known[room]
            if (room == "rooms") is_room[$i]
        }
        highest[room] = depth + 1
        next
    }
    function first_of(path) { return substr(path, 1, index(path, "/") - 1) }
    # Two folders deep where the table has such a room.
    function room_of(path, first, second) {
        first = first_of(path)
        second = first "/" first_of(substr(path, length(first) + 2))
        return second in is_room ? second : first
    }
    # Place in the room: what the table names, the file itself or its folder.
    function place_of(path, room, rest) {
        rest = substr(path, length(room) + 2)
        if ((room, rest) in layer) return rest
        return index(rest, "/") ? first_of(rest) : rest
    }
    function layer_of(room, place) { return (room, place) in layer ? layer[room, place] : highest[room] }
    function wrong(text) { print where ": " text; mistakes++ }
    {
        split($0, part, ":")
        where = part[1] ":" part[2]
        from = part[1]
        a = room_of(from)
        if (!(a in is_room)) next
        if ($0 ~ /<mpi\.h>/ && a != "base") wrong("only base/ may include mpi.h")
        if (!match($0, /"[^"]*"/) || $0 ~ /"frana_(version|cases|scene_page)\.h"/) next # made by the build
        to = substr($0, RSTART + 1, RLENGTH - 2)
        b = room_of(to)
        if (b == "" || !(b in is_room)) { wrong(to " is in no room: write the path from the top"); next }
        if (a != b && layer["rooms", a] <= layer["rooms", b]) wrong("room " a " must not include room " b)
        if (a != b || !(a in known)) next
        p = place_of(from, a)
        q = place_of(to, a)
        if (p == q) next
        if (layer_of(a, p) < layer_of(a, q)) wrong(a "/" p " is a lower layer than " a "/" q)
        else if (layer_of(a, p) == layer_of(a, q) && p !~ /\./ && q !~ /\./)
            wrong(a "/" p " and " a "/" q " are one layer")
    }
    END {
        if (mistakes) printf "layers: %d arrows against the grain\n", mistakes
        exit mistakes > 0
    }'
