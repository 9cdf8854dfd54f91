#!/usr/bin/env python3
"""Does each source compile alone, without those of its batch and without precompiled headers?

The release compiles sixteen sources together, where one may use what another includes or declares. The sanitizers,
clang-tidy and the fuzzers compile each alone. This parses every source of the program, the tests, the examples and the
benchmarks, with the warnings of the project, and generates no code; and every header, but those that a source of the same
name includes first, which it checks by that.

    tools/each_alone.py [--compiler clang++] [--jobs N] [PART...]      PART: of a path, such as apps/ or src/run/store/
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import resource
import shlex
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent


def configured(compiler):
    """The commands of a build in which each source is compiled alone; headers that the build writes are there."""
    build = root / "build" / f"alone-{pathlib.Path(compiler).name}"
    subprocess.run(["cmake", "-S", root, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug", "-DMATRIGRATE_TESTS=ON",
                    "-DMATRIGRATE_BENCHMARKS=ON", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON",
                    f"-DCMAKE_CXX_COMPILER={compiler}"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build, "--target", "matrigrate_build_info"], check=True, stdout=subprocess.DEVNULL)
    return json.loads((build / "compile_commands.json").read_text())


def header_of(file):
    """The header that CMake's check of headers includes alone, by its path from the folder above its library."""
    match = re.search(r"_verify_interface_header_sets/(.*)\.cxx$", file)
    return match and match[1]


def checked_by_a_source(sources):
    """The headers that a source of the same name includes first."""
    headers = set()
    for source in sources:
        first = re.search(r'^#include "([^"]*)"', pathlib.Path(source).read_text(), re.M)
        if first and pathlib.Path(first[1]).stem == pathlib.Path(source).stem:
            headers.add(first[1])
    return headers


def chosen(commands, parts):
    """One command for each source, and for each header that no source checks; all those of which a part names."""
    ours = {c["file"]: c for c in reversed(commands) if not c["file"].startswith(str(root / "build"))}
    checked = checked_by_a_source(ours)
    headers = {header_of(c["file"]): c for c in commands if header_of(c["file"])}
    all_of_them = {str(pathlib.Path(f).relative_to(root)): c for f, c in ours.items()}
    all_of_them |= {name: c for name, c in headers.items() if name not in checked}
    return {name: c for name, c in sorted(all_of_them.items()) if not parts or any(part in name for part in parts)}


def parsed(name, command):
    """(the name, what the compiler complains of)"""
    words, arguments = iter(shlex.split(command["command"])), []
    for word in words:
        if word == "-o":
            next(words)
        elif word != "-c" and not word.startswith("-O") and pathlib.Path(word).name != "ccache":
            arguments.append(word)
    done = subprocess.run([*arguments, "-fsyntax-only"], cwd=command["directory"], text=True, capture_output=True)
    return name, done.stderr if done.returncode else ""


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--compiler", default="g++")
    arguments.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments.add_argument("parts", nargs="*")
    options = arguments.parse_args()
    commands = chosen(configured(options.compiler), options.parts)
    if not commands:
        sys.exit("no source has such a path")
    faulty = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for name, complaint in pool.map(parsed, commands, commands.values()):
            if complaint:
                faulty += 1
                print(f"{name} does not compile alone:\n{complaint}", flush=True)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{len(commands) - faulty} of {len(commands)} files compile alone; {used.ru_utime + used.ru_stime:.0f} s of CPU time")
    sys.exit(faulty > 0)


if __name__ == "__main__":
    main()
