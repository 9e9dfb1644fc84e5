"""What the disk refuses ends with one sentence and exit code 4, and leaves what is finished as it was.

usage: disk_full.py CHECKPOINT SERIES FOLDER [LAUNCHER...]      the programs test_store_full and test_table_full
"""
import hashlib
import os
import shutil
import subprocess
import sys

checkpoint_program, series_program, folder, *launch = sys.argv[1:]


def run(*args, program=checkpoint_program):
    command = [*launch, program, *map(str, args)]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, done.stderr


def digest(path):
    with open(path, "rb") as f:
        return hashlib.sha256(f.read()).hexdigest()


def refused(place, why, *limit, mebibytes=4):
    """step_1 stands; step_2 must fail for the reason given and change nothing."""
    checkpoint = os.path.join(place, "checkpoint")
    before = {name: digest(os.path.join(checkpoint, name)) for name in os.listdir(checkpoint)}
    assert sorted(before) == ["latest", "step_1.h5"], before
    code, said = run(place, "step_2", mebibytes, *limit)
    sentences = [line for line in said.splitlines() if line.startswith("frana: ")]
    assert code == 4, (code, said)
    assert len(sentences) == 1 and why in sentences[0] and "step_2.h5: cannot be written" in sentences[0], said
    assert "HDF5-DIAG" not in said, said
    after = {name: digest(os.path.join(checkpoint, name)) for name in os.listdir(checkpoint)}
    assert after == before, (before, after)
    with open(os.path.join(checkpoint, "latest")) as f:
        assert f.read() == "step_1.h5\n"


def fresh(place):
    for name in os.listdir(place):
        shutil.rmtree(os.path.join(place, name))
    os.makedirs(os.path.join(place, "checkpoint"))
    code, said = run(place, "step_1", 4)
    assert code == 0, said


def file_size_limit():
    fresh(folder)
    for limit in (1, 3):
        refused(folder, "File too large", limit)
    # in the middle of a file, within its reserved bytes: no rank may wait for ever for another that could not write
    refused(folder, "File too large", 0.001, "amid", mebibytes=0.05)
    print("refused by the limit on a file's size")


def small_disk():
    """A file system of 7 MiB holds one checkpoint of 4 and not two; then it is made read-only."""
    place = os.path.join(folder, "small")
    os.makedirs(place, exist_ok=True)
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=7m", "tmpfs", place], capture_output=True).returncode != 0:
        print("no small file system can be mounted here: that part is left out")
        return
    try:
        fresh(place)
        refused(place, "No space left on device")
        subprocess.run(["mount", "-o", "remount,ro", place], check=True)
        refused(place, "Read-only file system")
        print("refused by a full and by a read-only disk")
    finally:
        subprocess.run(["umount", place], check=True)


def no_folder():
    code, said = run(os.path.join(folder, "missing"), "step_1", 1)
    assert code == 4 and "No such file or directory" in said, (code, said)
    print("refused without a folder")


def series():
    """A series that cannot grow loses no row; one with other columns is not touched; a resume mends the cut row."""
    path = os.path.join(folder, "series.csv")
    code, said = run(folder, "dp", -1, 100, 500, program=series_program)
    assert code == 4 and "series.csv: cannot be written: File too large" in said, (code, said)
    with open(path) as f:
        lines = f.read().split("\n")
    whole = (500 - len("step,dp\n#1,Pa\n") - 9 * len("1,0.5\n")) // len("10,0.5\n") + 9
    assert lines[2:-1] == [f"{k},0.5" for k in range(1, whole + 1)], lines
    assert lines[-1] != ""  # the truncated row
    before = digest(path)
    code, said = run(folder, "other", 50, 1, program=series_program)
    assert code == 4 and "other columns" in said and digest(path) == before, (code, said)
    code, said = run(folder, "dp", 50, 1, program=series_program)
    assert code == 0, said
    with open(path) as f:
        assert f.read().split("\n")[2:] == [f"{k},0.5" for k in range(1, 52)] + [""]
    os.remove(path)
    print("a series is refused, kept and mended")


shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
series()
file_size_limit()
no_folder()
small_disk()
