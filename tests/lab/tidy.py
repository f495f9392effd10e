#!/usr/bin/env python3
"""tidy.py COMPILE_COMMANDS FOLDER: every source of ours before clang-tidy, once; 1 if it finds something.

Nearly all of its time goes into the headers, so the sources of one folder are looked at together: each
unit, a file in FOLDER, includes up to two dozen of them. Two that have a helper of the same name stand in
two units. Where the names do not show that files get in each other's way, the unit does not compile, and
its halves are looked at.
"""

import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

MOST_FILES = 24
OF_UNITS = ["-Wno-shadow", "-Wno-return-type"]  # a name of one file in another's sight, and main_0
UNNAMED = re.compile(r"^namespace \{$.*?^\}  // namespace$", re.M | re.S)
# What is named at the beginning of a line: types, macros, and the word before a bracket, a brace or =.
NAMES = re.compile(
    r"^(?:#define|struct|class|enum class|using|concept) (?:\w+::)*(\w+)"
    r"|^(?!\s|using|namespace|return|TEST_CASE|template)[\w:<>,&*\[\] ]+?[ &*](\w+)(?:\[[^\]]*\])?(?: =|[({;])",
    re.M)


def own_names(path):
    """Those that another source of the unit must not have too."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    names = {word for part in UNNAMED.findall(text) for pair in NAMES.findall(part) for word in pair}
    names |= set(re.findall(r"^#define (\w+)", text, re.M))
    return names - {""}


def definitions(options):
    return dict(option[2:].partition("=")[::2] for option in options if option.startswith("-D"))


class Unit:
    def __init__(self):
        self.entries, self.names, self.options = [], set(), []

    def takes(self, options, names):
        own, its = definitions(self.options), definitions(options)
        return (len(self.entries) < MOST_FILES and not self.names & names
                and all(own.get(name, value) == value for name, value in its.items()))

    def add(self, entry, options, names):
        self.entries.append(entry)
        self.names |= names
        self.options += [option for option in options if option not in self.options]


def units_of(commands):
    """Each source once, as its first target compiles it."""
    entries, units = {}, {}
    for entry in commands:
        if "/build/" not in entry["file"] and "/submissions/" not in entry["file"]:
            entries.setdefault(entry["file"], entry)
    for path, entry in entries.items():
        words = shlex.split(entry["command"])[1:]
        options = [word for last, word in zip([""] + words, words)
                   if word not in ("-o", "-c", path) and last != "-o"]
        names = own_names(path)
        if "-include-pch" in words:  # stages: each defines the same two functions
            names.add("trace_ray")
        folder = units.setdefault((os.path.dirname(path), "-include-pch" in words), [])
        unit = next((unit for unit in folder if unit.takes(options, names)), None)
        if unit is None:
            folder.append(unit := Unit())
        unit.add(entry, options, names)
    return [unit for folder in units.values() for unit in folder]


def tidy(folder, path):
    run = subprocess.run(["clang-tidy", "-quiet", "-checks=-bugprone-suspicious-include", "-p", folder, path],
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    words = "".join(line for line in run.stdout.splitlines(True) if "warnings generated" not in line)
    return run.returncode, words


def write_unit(path, entries):
    with open(path, "w", encoding="utf-8") as file:
        for own, entry in enumerate(entries):
            file.write(f'#define main main_{own}\n#include "{entry["file"]}"\n#undef main\n')


def look_at(folder, path, entries):
    """Where a unit does not compile, its halves are looked at."""
    if len(entries) == 1:
        return [tidy(folder, entries[0]["file"])]
    write_unit(path, entries)
    status, words = tidy(folder, path)
    if "[clang-diagnostic-" not in words:
        return [(status, words)]
    half = len(entries) // 2
    return look_at(folder, path, entries[:half]) + look_at(folder, path, entries[half:])


def main():
    folder = os.path.abspath(sys.argv[2])
    os.makedirs(folder, exist_ok=True)
    with open(sys.argv[1], encoding="utf-8") as file:
        units = units_of(json.load(file))
    seen = [entry for unit in units for entry in unit.entries]
    paths = [os.path.join(folder, f"unit{number}.cpp") for number in range(len(units))]
    for path, unit in zip(paths, units):
        seen.append({"directory": unit.entries[0]["directory"], "file": path,
                     "arguments": ["clang++", *unit.options, *OF_UNITS, "-c", path]})
    with open(os.path.join(folder, "compile_commands.json"), "w", encoding="utf-8") as file:
        json.dump(seen, file, indent=1)
    by_size = sorted(zip(paths, units), key=lambda pair: -len(pair[1].entries))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = [each for found in pool.map(lambda pair: look_at(folder, pair[0], pair[1].entries), by_size)
                   for each in found]
    for status, words in results:
        if status != 0:
            print(words, end="")
    sys.exit(any(status != 0 for status, _ in results))


if __name__ == "__main__":
    main()
