#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tests; called by ./Alltest, which see for the options, with
etc/bashrc sourced and everything built.

A test is a name, a command, the folder to run it in, and a time limit. Every
kind of test speaks TAP: each line 'ok - text' or 'not ok - text' counts as one
test, a non-zero exit status or no such line at all as one failure."""

import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUN = ROOT / "tests" / "run"
TIERS = ("quick", "verification", "benchmark")
LIMIT = {"quick": 900, "verification": 4 * 3600, "benchmark": 24 * 3600}
SOURCE = (".C", ".H")
# Process groups that run now, to end with us
RUNNING = set()
CORES = os.cpu_count() or 1
# Tests at once, never more than two: memory, and timings that mean something
JOBS = min(2, CORES)


class Test:
    """One test. run() returns its TAP lines and writes its log."""

    def __init__(self, name, tier):
        self.name = name
        self.tier = tier
        self.folder = RUN / name
        self.jobs = JOBS

    @property
    def log(self):
        return RUN / f"log.{self.name.replace('/', '.')}"

    def shell(self, command, folder, log, limit=None):
        """Exit status of a command; its output goes to the open file log."""
        threads = max(1, CORES // self.jobs)
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads),
                           LPF_TEST_JOBS=str(self.jobs), LPF_QUIET="1",
                           # a thread that waits leaves its core to another
                           OMP_WAIT_POLICY="passive",
                           # OpenFOAM warns where it is not the true folder
                           PWD=str(folder))
        process = subprocess.Popen(
            command, cwd=folder, stdin=subprocess.DEVNULL, stdout=log,
            stderr=subprocess.STDOUT, env=environment, start_new_session=True)
        RUNNING.add(process.pid)
        try:
            return process.wait(limit or LIMIT[self.tier])
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            log.write(b"\nnot ok - ended within %d s\n"
                      % (limit or LIMIT[self.tier]))
            return 0
        finally:
            RUNNING.discard(process.pid)

    def fresh(self, source=None):
        """An empty folder to run in, or a copy of source."""
        if self.folder.exists():
            shutil.rmtree(self.folder)
        if source:
            shutil.copytree(source, self.folder, symlinks=True)
        else:
            self.folder.mkdir(parents=True)

    def readTap(self, status):
        lines = re.findall(r"^(?:not )?ok\b.*",
                           self.log.read_text(errors="replace"), re.M)
        if status:
            lines.append(f"not ok - exit status {status}")
        return lines or ["not ok - printed no line 'ok - text'"]


class CaseTest(Test):
    """A folder of tests/cases/<tier>: its executable 'test', in a copy."""

    def __init__(self, source, tier):
        super().__init__(f"{tier}/{source.name}", tier)
        self.source = source

    def run(self):
        self.fresh(self.source)
        with self.log.open("wb") as log:
            status = self.shell(["./test"], self.folder, log)
        return self.readTap(status)


class UnitTest(Test):
    """tests/unit: one line for each TEST_CASE, not for each assertion."""

    def __init__(self):
        super().__init__("unit", "quick")

    def run(self):
        self.fresh()
        with self.log.open("wb") as log:
            status = self.shell(["lpfUnitTests", "-r", "tap"], self.folder,
                                log)
        good, order, case = {}, [], "?"
        for line in self.log.read_text(errors="replace").splitlines():
            if line.startswith("# "):
                case = line[2:].strip()
                if case not in good:
                    good[case] = True
                    order.append(case)
            elif line.startswith("not ok"):
                good[case] = False
        lines = [("ok - " if good[c] else "not ok - ") + c for c in order]
        if status and all(good.values()):
            lines.append(f"not ok - exit status {status}")
        return lines or ["not ok - no unit test has run"]


class MessageTest(Test):
    """A folder of tests/messages: malformed input, and what must be said."""

    BASE = ROOT / "tests" / "messages" / "base"
    prepared = threading.Lock()
    ready = None

    def __init__(self, source):
        super().__init__(f"messages/{source.name}", "quick")
        self.source = source

    def base(self, log):
        """The base case, prepared once for all messages."""
        with MessageTest.prepared:
            if MessageTest.ready is None:
                copy = RUN / "messages.base"
                if copy.exists():
                    shutil.rmtree(copy)
                shutil.copytree(self.BASE, copy)
                script = copy / "prepare"
                status = 0
                if script.exists():
                    status = self.shell(["./prepare"], copy, log)
                    script.unlink()
                if status:
                    raise RuntimeError(f"base/prepare: exit status {status}")
                MessageTest.ready = copy
        return MessageTest.ready

    def checksums(self):
        return {
            str(p.relative_to(self.folder)):
                hashlib.sha256(p.read_bytes()).hexdigest()
                if p.is_file() else "folder"
            for p in self.folder.rglob("*")
        }

    def run(self):
        with self.log.open("wb") as log:
            self.fresh(self.base(log))
            for path in sorted(self.source.rglob("*")):
                target = self.folder / path.relative_to(self.source)
                if path.is_dir():
                    target.mkdir(exist_ok=True)
                elif path.name not in ("command", "expect", "edit") \
                        or path.parent != self.source:
                    shutil.copy2(path, target)
            edit = self.source / "edit"
            if edit.exists() and self.shell(
                    ["bash", "-eu", str(edit)], self.folder, log):
                return ["not ok - the script edit"]
            before = self.checksums()
            log.flush()
            start = log.tell()
            status = self.shell(
                ["bash", "-eu", str(self.source / "command")], self.folder,
                log, 120)
        output = self.log.read_bytes()[start:].decode(errors="replace")
        return self.judge(status, output, before == self.checksums())

    def judge(self, status, output, unchanged):
        wanted = (self.source / "expect").read_text().splitlines()
        plain = "#!plain" in wanted
        flat = " ".join(output.split())
        lines = []

        def check(good, text):
            lines.append(("ok - " if good else "not ok - ") + text)

        check(status == 1, f"exit status 1 (is {status})")
        if not plain:
            check("--> FOAM FATAL IO ERROR" in flat, "--> FOAM FATAL IO ERROR")
            check(re.search(r"file: .+ (at line|from line) \d+", flat),
                  "names file and line")
        for line in wanted:
            if line.strip() and not line.startswith("#"):
                check(" ".join(line.split()) in flat, f"says: {line.strip()}")
        check(unchanged, "case unchanged")
        with self.log.open("a") as log:
            log.write("\n" + "\n".join(lines) + "\n")
        return lines


class CommandCheck(Test):
    """A check that is one command: it passes when its exit status is 0."""

    def __init__(self, name, text, command):
        super().__init__(f"checks/{name}", "quick")
        self.text = text
        self.command = command

    def run(self):
        with self.log.open("wb") as log:
            status = self.shell(self.command, ROOT, log)
        return [("not ok - " if status else "ok - ") + self.text]


class FileCheck(Test):
    """A check of many files, one line each."""

    def __init__(self, name, files, command):
        super().__init__(f"checks/{name}", "quick")
        self.files = files
        self.command = command

    def run(self):
        lines = []
        with self.log.open("wb") as log:
            for path in self.files:
                status = self.shell([*self.command, str(path)], ROOT, log)
                lines.append(("not ok - " if status else "ok - ")
                             + str(path.relative_to(ROOT)))
        return lines


class TidyCheck(Test):
    """clang-tidy of the files of one Make folder. A file that has passed with
    the same content, headers, flags and rules is not read again."""

    PASSED = ROOT / "platforms" / "clang-tidy"

    def __init__(self, folder, files, headers):
        relative = folder.relative_to(ROOT)
        super().__init__("checks/tidy." + str(relative).replace("/", "."),
                         "quick")
        self.source = folder
        self.files = files
        self.headers = headers

    def flags(self):
        make = str(ROOT / "bin" / "tools" / "compileFlags.mk")
        text = subprocess.run(
            ["make", "-s", "-f", make], cwd=self.source, check=True,
            capture_output=True, text=True,
            env={k: v for k, v in os.environ.items() if k != "MAKEFLAGS"},
        ).stdout
        omp = subprocess.run(["g++", "-print-file-name=include"], check=True,
                             capture_output=True, text=True).stdout.strip()
        # omp.h is found with GCC only; clang 14 refuses OpenFOAM's deprecated
        # typedefs, which are not ours to judge
        return [*text.split(), "-idirafter", omp, "-Ddeprecated(x)="]

    def key(self, path, flags):
        """Checksum of all that the result depends on."""
        total = hashlib.sha256("\0".join(flags).encode())
        total.update((ROOT / ".clang-tidy").read_bytes())
        todo, seen = [path], set()
        while todo:
            current = todo.pop()
            if current in seen:
                continue
            seen.add(current)
            text = current.read_text()
            total.update(text.encode())
            for name in re.findall(r'#\s*include\s*"([^"]+)"', text):
                header = self.headers.get(name.rsplit("/", 1)[-1])
                if header:
                    todo.append(header)
        return total.hexdigest()

    def run(self):
        self.PASSED.mkdir(parents=True, exist_ok=True)
        flags = self.flags()
        lines = []
        with self.log.open("wb") as log:
            for path in self.files:
                stamp = self.PASSED / self.key(path, flags)
                status = 0
                if not stamp.exists():
                    status = self.shell(
                        ["clang-tidy", "--quiet", str(path), "--", *flags],
                        self.source, log)
                    if not status:
                        stamp.touch()
                lines.append(("not ok - " if status else "ok - ")
                             + str(path.relative_to(ROOT)))
        return lines


def ourSource():
    for top in ("src", "applications", "tests/unit"):
        for path in sorted((ROOT / top).rglob("*")):
            if path.suffix in SOURCE and path.is_file() \
                    and "lnInclude" not in path.parts \
                    and not path.is_symlink():
                yield path


def scripts():
    """Our bash scripts: by suffix or first line."""
    skip = ("ThirdParty", "platforms", "run", ".git", "lnInclude")
    for path in sorted(ROOT.rglob("*")):
        parts = path.relative_to(ROOT).parts
        if any(p in skip or p.startswith("linux64") for p in parts) \
                or not path.is_file() or path.is_symlink():
            continue
        with path.open("rb") as file:
            if re.match(rb"#!/bin/(ba)?sh|#!/usr/bin/env bash",
                        file.readline()):
                yield path


def tidyChecks(source):
    headers = {p.name: p for p in source if p.suffix == ".H"}
    # A file that several Make folders compile is checked with the first
    done = set()
    for files in sorted(p for top in ("src", "applications", "tests/unit")
                        for p in (ROOT / top).rglob("Make/files")):
        folder = files.parent.parent
        listed = []
        for line in files.read_text().split():
            for place in (folder / line, folder.parent / line):
                path = place.resolve()
                if line.endswith(".C") and path.exists() and path not in done:
                    done.add(path)
                    listed.append(path)
                    break
        if listed:
            yield TidyCheck(folder, listed, headers)


def allTests():
    for tier in TIERS:
        for script in sorted((ROOT / "tests/cases" / tier).glob("*/test")):
            yield CaseTest(script.parent, tier)
    source = list(ourSource())
    yield from tidyChecks(source)
    for folder in sorted((ROOT / "tests/messages").glob("*")):
        if (folder / "command").exists():
            yield MessageTest(folder)
    yield UnitTest()
    yield FileCheck("format", source,
                    ["clang-format", "--dry-run", "-Werror"])
    yield FileCheck("shell", list(scripts()), ["shellcheck", "-x"])
    yield CommandCheck("layers", "the libraries keep to doc/design.md",
                       ["lpfCheckLayers"])
    yield CommandCheck("tags", "equation tags of theory and source agree",
                       ["lpfCheckTags"])


def execute(test):
    start = time.time()
    test.log.parent.mkdir(parents=True, exist_ok=True)
    try:
        lines = test.run()
    except Exception as problem:  # a broken test is a failed test
        lines = [f"not ok - {type(problem).__name__}: {problem}"]
    return test, lines, time.time() - start


def report(test, lines, seconds):
    failed = [line for line in lines if line.startswith("not ok")]
    name = f"{test.name} {'.' * max(2, 48 - len(test.name))}"
    if failed:
        print(f"{name} FAILED {len(failed)} of {len(lines)} ({seconds:.1f} s)"
              f" {test.log.relative_to(ROOT)}")
        for line in failed[:10]:
            print(f"    {line}")
        if len(failed) > 10:
            print(f"    and {len(failed) - 10} more")
    else:
        print(f"{name} {len(lines)} passed ({seconds:.1f} s)")
    sys.stdout.flush()
    return len(lines) - len(failed), len(failed)


def interrupted(number, _):
    for group in list(RUNNING):
        try:
            os.killpg(group, signal.SIGKILL)
        except ProcessLookupError:
            pass
    print("interrupted")
    sys.stdout.flush()
    os._exit(128 + number)


def main():
    signal.signal(signal.SIGINT, interrupted)
    signal.signal(signal.SIGTERM, interrupted)
    parser = argparse.ArgumentParser(prog="Alltest", add_help=False)
    parser.add_argument("-tier", choices=(*TIERS, "all"))
    parser.add_argument("-case", nargs="+", action="extend", default=[])
    parser.add_argument("-list", action="store_true")
    options = parser.parse_args()
    tier = options.tier or ("all" if options.case else "quick")
    words = options.case or [""]

    tests = [t for t in allTests()
             if tier in ("all", t.tier)
             and any(word in t.name for word in words)]
    if not tests:
        print(f"no test with '{' or '.join(words)}' in its name in "
              f"tier {tier}")
        print("0 passed, 1 failed")
        return 1
    if options.list:
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # as in `| head`
        print("\n".join(t.name for t in tests))
        return 0

    passed = failed = 0
    together = [t for t in tests if t.tier != "benchmark"]
    jobs = min(JOBS, max(1, len(together)))  # one alone has all cores
    for test in together:
        test.jobs = jobs
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for result in concurrent.futures.as_completed(
                [pool.submit(execute, t) for t in together]):
            good, bad = report(*result.result())
            passed += good
            failed += bad
    for test in tests:
        if test.tier == "benchmark":
            test.jobs = 1
            good, bad = report(*execute(test))
            passed += good
            failed += bad
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
