#!/usr/bin/env python3
"""benchmark.py ROOT BUILD [COUNT]: how fast a class is graded on this machine.

COUNT (200) made-up submissions of five stages: how many a minute; the processor time against that of
compiling and linking the same files and nothing else; the grader's memory; and how soon a run over ten
times as many, all graded before, is at its end.
"""
import json
import os
import pathlib
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

SAMPLE = 20  # submissions that are compiled alone: two of each of the ten kinds


def spent():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def make_class(root, folder, count):
    script = 'source "$1/tests/grading/class_of.bash" && class_of "$@"'
    subprocess.run(["bash", "-c", script, "_", root, folder, str(count)], check=True)


def peak_kib(pid):
    try:
        words = pathlib.Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return 0
    found = [line.split()[1] for line in words.splitlines() if line.startswith("VmHWM")]
    return int(found[0]) if found else 0


def grade(root, build, folder, output):
    """Seconds, processor seconds, and the most memory of the grader itself in KiB."""
    words = [f"{build}/bin/fos_grade", "--root", root, "--build", build, folder, "--output", output]
    began, before, peak = time.monotonic(), spent(), 0
    with subprocess.Popen(words + ["--seed", "1"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as run:
        while run.poll() is None:
            peak = max(peak, peak_kib(run.pid))
            time.sleep(0.02)
        if run.returncode != 0:
            sys.exit(f"fos_grade ended with {run.returncode}: {run.stderr.read().decode()}")
    return time.monotonic() - began, spent() - before, peak


def compile_words(build, stage, source, program):
    """As the toolkit compiles its own solution of this stage, with its precompiled header."""
    for entry in json.loads(pathlib.Path(build, "compile_commands.json").read_text()):
        if entry["file"].endswith(f"/{stage}.cpp") and f"solution_{stage}.dir" in entry["command"]:
            words = [word for word in shlex.split(entry["command"]) if word != "-Werror"]
            words = words[: words.index("-o")]
            objects = [f"{build}/common/CMakeFiles/fos_stage_main.dir/src/stage_main.cpp.o",
                       f"{build}/common/libfos_common.a", f"{build}/common/libfos_base.a", "-lfmt"]
            return words + [str(source), *objects, "-o", program]
    sys.exit(f"there is no solution of {stage} in {build}/compile_commands.json")


def compile_alone(build, folder, count):
    before = spent()
    for number in range(count):
        for source in pathlib.Path(folder, f"student{number}").iterdir():
            subprocess.run(compile_words(build, source.stem, source, f"{folder}/../program"),
                           stderr=subprocess.DEVNULL, check=False)
    return (spent() - before) / count


def make_tenfold(folder, output, count):
    """The same files by nine more students each, and their results, for a key hangs on no name."""
    for number in range(count, 10 * count):
        old = f"student{number % count}"
        new = f"student{number}"
        shutil.copytree(f"{folder}/{old}", f"{folder}/{new}")
        for kind in ("results", "submissions"):
            if os.path.isdir(f"{output}/{kind}/{old}"):
                shutil.copytree(f"{output}/{kind}/{old}", f"{output}/{kind}/{new}")
        result = pathlib.Path(output, "results", new, "result.json")
        result.write_bytes(result.read_bytes().replace(f'"{old}"'.encode(), f'"{new}"'.encode(), 1))


def main():
    root, build = os.path.realpath(sys.argv[1]), os.path.realpath(sys.argv[2])
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 200
    with tempfile.TemporaryDirectory() as work:
        folder, output = f"{work}/class", f"{work}/results"
        make_class(root, folder, count)
        print(f"processors: {os.cpu_count()}, load before: {os.getloadavg()[0]:.1f}")
        seconds, processor, peak = grade(root, build, folder, output)
        print(f"graded: {count} in {seconds:.0f} s, {60 * count / seconds:.0f} a minute")
        alone = compile_alone(build, folder, min(SAMPLE, count))
        print(f"processor time of each: {processor / count:.2f} s; compiled alone: {alone:.2f} s; "
              f"{processor / count / alone:.2f} times that")
        make_tenfold(folder, output, count)
        grade(root, build, folder, output)  # the others' names are put into their results and pages
        again, _, peak_again = grade(root, build, folder, output)
        print(f"a run over {10 * count} that are all graded: {again:.2f} s")
        print(f"memory of the grader: {peak / 1024:.0f} MiB, and {peak_again / 1024:.0f} MiB in that run")


main()
