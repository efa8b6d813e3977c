#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Skeletonizes many inputs, each by a process of its own, and records the outcome of each in a manifest.

  cscd-batch meshes/*.off --output-dir skeletons --timeout 60 --memory 2G
  cscd-batch --list names.txt --output-dir out --resume -- -o {}.json -o {}.html --detail 0.3

Options of cscd skeletonize follow --; {} stands for the name of the results without ending. The default is
-o {}.graph --threads 1. Exit status: 0 all inputs of this run have a skeleton, 1 bad usage, 2 an input has none or a
file cannot be read or written."""

import argparse
import collections
import concurrent.futures
import contextlib
import csv
import fcntl
import io
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import sys
import threading
import time

COUNTS = ("number_of_sites", "number_of_surface_components", "genus", "number_of_nodes", "number_of_edges",
          "number_of_skeleton_components", "betti_number", "number_of_tips", "number_of_junctions",
          "number_of_nodes_outside", "number_of_edges_outside")  # members of the report
COLUMNS = ("input", "status", *COUNTS, "seconds", "megabytes", "message")
FINISHED = ("done", "failed")  # not tried again by --resume
OUTPUT_OPTIONS = ("-o", "--output", "--branches", "--nodes", "--cylinders", "--correspondence")
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Refusal(Exception):
    """A message that names the fault and the remedy, and the exit status."""

    def __init__(self, message, status=1):
        super().__init__(message)
        self.status = status


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Refusal(message)


class Manifest:
    """A table as CSV that grows by one row at a time, and is locked while this process runs."""

    def __init__(self, path, resumes):
        try:
            self.file = os.open(path, os.O_RDWR | os.O_APPEND | os.O_CREAT | (0 if resumes else os.O_EXCL), 0o666)
            fcntl.flock(self.file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except FileExistsError:
            raise Refusal(f"{path}: exists already; add --resume to continue it, or name another folder") from None
        except BlockingIOError:
            raise Refusal(f"{path}: another cscd-batch writes it; wait for its end, or name another folder", 2) from None
        header = ",".join(COLUMNS).encode() + b"\n"
        old = path.read_bytes()
        try:
            if old[:len(header)] != header[:len(old)]:
                raise ValueError
            # A process that was killed may leave half a row.
            rows = self.read(old[len(header):old.rfind(b"\n") + 1].decode(errors="surrogateescape"))
            finished = {row["input"]: row for row in reversed(rows) if row["status"] in FINISHED}
            new = header + b"".join(map(self.line, reversed(finished.values())))
        except (csv.Error, ValueError, KeyError, TypeError):
            raise Refusal(f"{path}: is not a manifest of this version; name another folder") from None
        self.inputs = set(finished)
        same = len(os.path.commonprefix([old, new]))
        os.ftruncate(self.file, same)
        os.write(self.file, new[same:])

    def read(self, text):
        return [dict(zip(COLUMNS, row)) for row in csv.reader(io.StringIO(text, newline="")) if len(row) == len(COLUMNS)]

    def line(self, row):
        text = io.StringIO(newline="")
        csv.DictWriter(text, COLUMNS, lineterminator="\n").writerow(row)
        return text.getvalue().encode(errors="surrogateescape")

    def append(self, row):
        os.write(self.file, self.line(row))


def memory_size(text):
    match = re.fullmatch(r"(\d+\.?\d*)([KMGT]?)", text.upper())
    size = int(float(match[1]) * 1024 ** (1 + "KMGT".index(match[2] or "M"))) if match else 0
    if not 0 < size < 2 ** 63:
        raise argparse.ArgumentTypeError(f"must be a number of megabytes, or a size such as 800M or 2G, not {text}")
    return size


def positive(text):
    if not re.fullmatch(r"\d*\.?\d+", text) or not 0 < float(text) < threading.TIMEOUT_MAX:
        raise argparse.ArgumentTypeError(f"must be a number above 0, not {text}")
    return float(text)


def part(text):
    match = re.fullmatch(r"(\d+)/(\d+)", text)
    if not match or not 1 <= int(match[1]) <= int(match[2]):
        raise argparse.ArgumentTypeError(f"must be I/N with I from 1 to N, such as 3/8, not {text}")
    return int(match[1]), int(match[2])


def parse_arguments(arguments):
    end = arguments.index("--") if "--" in arguments else len(arguments)
    parser = Parser("cscd-batch", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)
    add = parser.add_argument
    add("inputs", nargs="*", metavar="INPUT", help="files of meshes, points or volumes")
    add("--list", metavar="FILE", help="file that names further inputs, one a line, or - for standard input")
    add("--output-dir", metavar="DIR", type=pathlib.Path, required=True, help="folder for the results and the manifest")
    add("--part", metavar="I/N", type=part, default=(1, 1), help="only the I-th of N parts, with a manifest of its own")
    add("--jobs", metavar="J", type=positive, default=os.cpu_count(), help="processes at once; default: one for each core")
    add("--timeout", metavar="S", type=positive, help="seconds after which a process is stopped")
    add("--memory", metavar="SIZE", type=memory_size, help="memory of each process: megabytes, or a size such as 2G")
    add("--resume", action="store_true", help="skip inputs that the manifest lists as done or failed")
    add("--program", metavar="FILE", help="the program cscd; default: the one next to this file, or in PATH")
    add("-q", "--quiet", action="store_true", help="print errors only")
    options = parser.parse_args(arguments[:end])
    beside = pathlib.Path(__file__).resolve().with_name("cscd")
    options.program = shutil.which(options.program or (beside if beside.exists() else "cscd"))
    if not options.program:
        raise Refusal("the program cscd is not found; name it by --program")
    if options.memory and not hasattr(resource, "prlimit"):
        raise Refusal("--memory: needs Linux; leave it out")
    options.command = check_command(arguments[end + 1:])
    return options


def check_command(command):
    """Checks the options of cscd skeletonize, which must give each input its own files."""
    names = [option.split("=")[0] for option in command]
    if "--report" in names:
        raise Refusal("--report: the manifest has the counts; leave it out")
    for i, name in enumerate(names):
        value = command[i] if name != command[i] else "".join(command[i + 1:i + 2])
        if name in OUTPUT_OPTIONS and "{}" not in value:
            raise Refusal(f"{name}: names one file for all inputs; write {{}} for the name of each, such as -o {{}}.swc")
    outputs = [] if any("{}" in option for option in command) else ["-o", "{}.graph"]
    return command + outputs + ([] if "--threads" in names else ["--threads", "1"])


def make_tasks(options):
    """The inputs, each once, and the names of their results, in the same arrangement of folders."""
    inputs = list(options.inputs)
    if options.list:
        with open(0 if options.list == "-" else options.list, encoding="utf-8", errors="surrogateescape") as lines:
            inputs += filter(None, lines.read().splitlines())
    if not inputs:
        raise Refusal("there are no inputs; name files, or a list of them by --list")
    paths = list(map(os.path.abspath, inputs))
    folder = os.path.commonpath(list(map(os.path.dirname, paths)))
    tasks = {}
    for name, path in zip(inputs, paths):
        first = tasks.setdefault(os.path.splitext(os.path.relpath(path, folder))[0], (name, path))
        if first[1] != path:
            raise Refusal(f"{first[0]} and {name}: differ in the ending only, so that their results would have one name; "
                          "use two folders")
    index, number = options.part
    return [(name, output) for output, (name, _) in tasks.items()][index - 1::number]


def kill(process):
    with contextlib.suppress(ProcessLookupError):
        os.kill(process, signal.SIGKILL)


class Batch:
    """Runs tasks in processes, several at once."""

    def __init__(self, options):
        self.options = options
        suffix = "_{}_of_{}".format(*options.part) if options.part[1] > 1 else ""
        options.output_dir.mkdir(parents=True, exist_ok=True)
        self.manifest = Manifest(options.output_dir / f"manifest{suffix}.csv", options.resume)
        self.work = options.output_dir / f".cscd_batch{suffix}"  # in the same file system: results are moved
        shutil.rmtree(self.work, ignore_errors=True)  # of a batch that was killed
        self.work.mkdir()
        # On Linux, no process outlives a batch that is killed.
        setpriv = sys.platform == "linux" and shutil.which("setpriv")
        self.prefix = [setpriv, "--pdeathsig", "KILL"] if setpriv else []
        self.lock, self.processes, self.is_stopped = threading.Lock(), set(), False
        self.numbers = collections.Counter()

    def run(self, tasks):
        pool = concurrent.futures.ThreadPoolExecutor(max(1, int(self.options.jobs)))
        try:
            for future in [pool.submit(self.process, i, *task) for i, task in enumerate(tasks)]:
                future.result()
        finally:
            with self.lock:
                self.is_stopped = True
                for process in self.processes:
                    kill(process)
            pool.shutdown(cancel_futures=True)
            shutil.rmtree(self.work, ignore_errors=True)

    def process(self, number, name, output):
        folder = self.work / str(number)
        (folder / "files").mkdir(parents=True)
        results = str(folder / "files" / os.path.basename(output))
        command = [*self.prefix, self.options.program, "skeletonize", "--quiet", "--report", str(folder / "report"),
                   *(option.replace("{}", results) for option in self.options.command), "--", name]
        begin = time.monotonic()
        with self.lock:
            if self.is_stopped:
                return
            process = self.start(command, folder / "messages")
            self.processes.add(process)
        timer = threading.Timer(self.options.timeout or threading.TIMEOUT_MAX, kill, [process])
        timer.start()
        _, status, usage = os.wait4(process, 0)
        timer.cancel()
        is_overdue = bool(self.options.timeout) and time.monotonic() - begin >= self.options.timeout
        with self.lock:
            self.processes.remove(process)
            if self.is_stopped:  # it may have ended by the same signal, which is not a fault of the input
                return
        row = self.outcome(os.waitstatus_to_exitcode(status), is_overdue, folder)
        if row["status"] == "done":
            target = self.options.output_dir / os.path.dirname(output)
            target.mkdir(parents=True, exist_ok=True)
            for file in (folder / "files").iterdir():
                file.replace(target / file.name)
        shutil.rmtree(folder)
        row |= {"input": name, "seconds": round(time.monotonic() - begin, 3),
                "megabytes": round(usage.ru_maxrss / (1024 if sys.platform == "linux" else 1024 ** 2), 3),
                "message": re.sub(r"[\x00-\x1f\x7f]", lambda c: f"\\x{ord(c[0]):02x}", row["message"])}
        with self.lock:
            self.manifest.append({column: row.get(column) for column in COLUMNS})
            self.numbers[row["status"]] += 1

    def start(self, command, messages):
        """Starts a process in a group of its own, so that the signals of a terminal do not reach it."""
        files = [(os.POSIX_SPAWN_OPEN, i, os.devnull, os.O_RDWR, 0) for i in (0, 1)]
        files.append((os.POSIX_SPAWN_OPEN, 2, str(messages), os.O_WRONLY | os.O_CREAT, 0o600))
        process = os.posix_spawn(command[0], command, os.environ, file_actions=files, setpgroup=0)
        if self.options.memory:  # what the process writes to counts, not what it only reserves
            with contextlib.suppress(ProcessLookupError):
                resource.prlimit(process, resource.RLIMIT_DATA, (self.options.memory, self.options.memory))
        return process

    @staticmethod
    def outcome(code, is_overdue, folder):
        """Status, message and counts of a process that ended."""
        if code == 0:
            report = json.loads((folder / "report").read_text())
            return {"status": "done", "message": "; ".join(report.get("repairs", []) + report["warnings"]), **report}
        if is_overdue:
            return {"status": "timeout", "message": "no skeleton within the time of --timeout"}
        if code < 0:
            return {"status": "crashed", "message": f"ended by signal {-code} ({signal.strsignal(-code)})"}
        lines = (folder / "messages").read_text(errors="surrogateescape").splitlines() or [""]
        message = lines[-1].removeprefix("cscd: ")
        is_memory = code == 3 and message.startswith("not enough memory")
        return {"status": "memory" if is_memory else "failed" if code < 3 else "crashed", "message": message}


def stop(number, _):
    for other in SIGNALS:
        signal.signal(other, signal.SIG_IGN)
    raise SystemExit(-number)


def run(options):
    tasks = make_tasks(options)
    batch = Batch(options)
    new_tasks = [task for task in tasks if task[0] not in batch.manifest.inputs]
    for number in SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:  # as of nohup
            signal.signal(number, stop)
    try:
        batch.run(new_tasks)
    except SystemExit as end:  # ends by the signal, so that the parent process knows the cause
        signal.signal(-end.code, signal.SIG_DFL)
        os.kill(os.getpid(), -end.code)
    if not options.quiet:
        earlier = [f"{len(tasks) - len(new_tasks)} in the manifest already"] if len(new_tasks) < len(tasks) else []
        counts = [f"{number} {status}" for status, number in sorted(batch.numbers.items())]
        print(", ".join([f"{len(tasks)} input{'s' if len(tasks) != 1 else ''}", *earlier, *counts]))
    return 0 if batch.numbers["done"] == len(new_tasks) else 2


def main():
    try:
        return run(parse_arguments(sys.argv[1:]))
    except Refusal as refusal:
        print(f"cscd-batch: {refusal}" + ("; see cscd-batch --help" if refusal.status == 1 else ""), file=sys.stderr)
        return refusal.status
    except OSError as error:
        print(f"cscd-batch: {error.filename}: {error.strerror}; check the name, the permissions and the disk", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
