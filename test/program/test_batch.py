# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of cscd-batch: results for good and bad inputs, and the remaining files after an interruption.

Usage: test_batch.py CSCD_BATCH [option of unittest...]"""

import csv
import importlib.machinery
import importlib.util
import json
import math
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

BATCH = os.path.abspath(sys.argv.pop(1))
CSCD = os.path.join(os.path.dirname(BATCH), "cscd")
SLOWLY = ["--", "--method", "published", "--separators", "100000"]  # a torus takes many seconds


def load_module():
    loader = importlib.machinery.SourceFileLoader("cscd_batch", BATCH)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


class Test_batch(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def write_torus(self, name, around=30, across=12):
        points, quads = [], []
        for i in range(around):
            for j in range(across):
                u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
                points.append(f"{(3 + math.cos(v)) * math.cos(u)} {(3 + math.cos(v)) * math.sin(u)} {math.sin(v)}")
                corners = [(i + a) % around * across + (j + b) % across for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                quads.append("4 " + " ".join(map(str, corners)))
        self.write(name, "\n".join([f"OFF\n{len(points)} {len(quads)} 0", *points, *quads]) + "\n")

    def write(self, name, text):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(text)

    def run_batch(self, *arguments, **options):
        return subprocess.run([sys.executable, BATCH, *arguments], cwd=self.folder, capture_output=True, text=True,
                              timeout=600, check=False, **options)

    def rows(self, manifest):
        """The rows by the names of their inputs; each input has one."""
        with open(self.folder / manifest, newline="") as file:
            rows = list(csv.DictReader(file))
        result = {row["input"]: row for row in rows}
        self.assertEqual(len(rows), len(result))
        for row in rows:
            self.assertEqual(16, len(row))
            self.assertNotIn(None, row.values())
        return result

    def files_in(self, folder):
        return sorted(str(file.relative_to(self.folder / folder)) for file in (self.folder / folder).rglob("*") if file.is_file())

    def content(self, name):
        return (self.folder / name).read_text()

    def expect_refusal(self, status, parts, *arguments):
        outcome = self.run_batch(*arguments)
        self.assertEqual((status, ""), (outcome.returncode, outcome.stdout), outcome.stderr)
        self.assertRegex(outcome.stderr, r"\Acscd-batch: [^\n]*\n\Z")
        for part in parts:
            self.assertIn(part, outcome.stderr)

    def test_bad_inputs_do_not_stop_the_others(self):
        self.write_torus("a.off")
        self.write("b.off", "")
        self.write_torus("d.off", 36, 14)
        outcome = self.run_batch("a.off", "b.off", "c.off", "d.off", "--output-dir", "out", "--jobs", "2")
        self.assertEqual((2, "4 inputs, 2 done, 2 failed\n", ""), (outcome.returncode, outcome.stdout, outcome.stderr))
        self.assertEqual(["a.graph", "d.graph", "manifest.csv"], self.files_in("out"))
        manifest = self.rows("out/manifest.csv")
        self.assertEqual(["a.off", "b.off", "c.off", "d.off"], sorted(manifest))
        done = manifest["a.off"]
        self.assertEqual(("done", "360", "1", "1", "0"), tuple(done[column] for column in (
            "status", "number_of_sites", "genus", "betti_number", "number_of_edges_outside")))
        self.assertEqual(done["number_of_nodes"], done["number_of_edges"])  # of a cycle
        self.assertLess(0, float(done["seconds"]))
        self.assertLess(1, float(done["megabytes"]))
        self.assertIn("polygons", done["message"])  # which were cut into triangles
        self.assertEqual("failed", manifest["b.off"]["status"])
        self.assertTrue(manifest["b.off"]["message"].startswith("b.off: "))
        self.assertIn("cannot be opened", manifest["c.off"]["message"])
        subprocess.run([CSCD, "skeletonize", "a.off", "-q", "-o", "alone.graph"], cwd=self.folder, check=True)
        self.assertEqual(self.content("alone.graph"), self.content("out/a.graph"))

    def test_results_lie_as_the_inputs_do(self):
        self.write_torus("meshes/cat/1.off")
        self.write_torus("meshes/dog/1.off")
        names = "meshes/cat/1.off\r\n\nmeshes/dog/1.off\nmeshes/cat/../cat/1.off\n"
        self.write("list", names)
        options = ["--output-dir", "out", "--", "-o", "{}.json", "-o", "{}.swc", "--detail", "0.3"]
        self.assertEqual(0, self.run_batch("--list", "list", *options).returncode)
        self.assertEqual(["cat/1.json", "cat/1.swc", "dog/1.json", "dog/1.swc", "manifest.csv"], self.files_in("out"))
        self.assertEqual(2, len(self.rows("out/manifest.csv")))
        outcome = self.run_batch("--list", "-", "--output-dir", "again", "--quiet", input=names)
        self.assertEqual((0, ""), (outcome.returncode, outcome.stdout))
        self.assertEqual(["cat/1.graph", "dog/1.graph", "manifest.csv"], self.files_in("again"))

    def test_what_takes_too_long_is_stopped(self):
        self.write_torus("slow.off", 200, 80)
        self.assertEqual(2, self.run_batch("slow.off", "--output-dir", "out", "--timeout", "0.3", *SLOWLY).returncode)
        self.assertEqual("timeout", self.rows("out/manifest.csv")["slow.off"]["status"])
        self.assertEqual(["manifest.csv"], self.files_in("out"))

    def test_what_needs_too_much_memory_is_stopped(self):
        self.write_torus("large.off", 600, 200)
        self.write_torus("small.off")
        inputs = ["large.off", "small.off"]
        self.assertEqual(2, self.run_batch(*inputs, "--output-dir", "out", "--memory", "40").returncode)
        manifest = self.rows("out/manifest.csv")
        self.assertEqual("memory", manifest["large.off"]["status"], manifest["large.off"]["message"])
        self.assertEqual("done", manifest["small.off"]["status"], manifest["small.off"]["message"])
        self.assertEqual(0, self.run_batch(*inputs, "--output-dir", "more", "--memory", "2G").returncode)
        self.expect_refusal(1, ["--memory", "2X", "2G"], "small.off", "--output-dir", "none", "--memory", "2X")

    def test_goes_on_where_a_manifest_ends(self):
        names = ["1.off", "2.off", "3.off", "4.off"]
        for name in names:
            self.write_torus(name)
        self.write("5.off", "")
        self.assertEqual(2, self.run_batch("1.off", "2.off", "5.off", "--output-dir", "out").returncode)
        self.expect_refusal(1, ["out/manifest.csv", "--resume"], *names, "--output-dir", "out")
        before = self.rows("out/manifest.csv")
        self.write("out/manifest.csv", self.content("out/manifest.csv") + "3.off,timeout,,,,,,,,1.5,20,too slow\n4.off,do")
        (self.folder / "out/1.graph").unlink()
        outcome = self.run_batch(*names, "5.off", "--output-dir", "out", "--resume")
        self.assertEqual((0, "5 inputs, 3 in the manifest already, 2 done\n"), (outcome.returncode, outcome.stdout))
        after = self.rows("out/manifest.csv")
        self.assertEqual(sorted([*names, "5.off"]), sorted(after))
        self.assertEqual(before, {name: after[name] for name in before})
        self.assertEqual(["done", "done"], [after[name]["status"] for name in ("3.off", "4.off")])
        self.assertEqual(["2.graph", "3.graph", "4.graph", "manifest.csv"], self.files_in("out"))
        self.write("out/manifest.csv", "x,y\n1,2\n")
        self.expect_refusal(1, ["is not a manifest"], "1.off", "--output-dir", "out", "--resume")
        self.assertEqual("x,y\n1,2\n", self.content("out/manifest.csv"))

    def test_leaves_nothing_half_done_when_it_is_interrupted(self):
        self.write_torus("quick.off")
        self.write_torus("slow.off", 200, 80)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            folder = f"out_{number.name}"
            batch = subprocess.Popen([sys.executable, BATCH, "slow.off", "quick.off", "--jobs", "1", "--output-dir", folder,
                                      *SLOWLY, "-o", "{}.graph"], cwd=self.folder)
            with self.assertRaises(subprocess.TimeoutExpired):
                batch.wait(1.5)
            batch.send_signal(number)
            self.assertEqual(-number, batch.wait(60))
            if number != signal.SIGKILL:
                self.assertEqual(["manifest.csv"], self.files_in(folder))
                self.assertFalse((self.folder / folder / ".cscd_batch").exists())
            self.assertEqual({}, self.rows(f"{folder}/manifest.csv"))
            # No process has it open.
            self.assertEqual(0, self.run_batch("quick.off", "slow.off", "--resume", "--output-dir", folder).returncode)
            self.assertEqual(["manifest.csv", "quick.graph", "slow.graph"], self.files_in(folder))

    def test_parts_together_are_the_whole(self):
        names = [f"{i}.off" for i in range(7)]
        for i, name in enumerate(names):
            self.write_torus(name, 20 + 2 * i, 10)
        self.assertEqual(0, self.run_batch(*names, "--output-dir", "whole").returncode)
        for part, size in ((1, 3), (2, 2), (3, 2)):
            self.assertEqual(0, self.run_batch(*names, "--output-dir", "parts", "--part", f"{part}/3").returncode)
            self.assertEqual(size, len(self.rows(f"parts/manifest_{part}_of_3.csv")))
        for name in self.files_in("whole"):
            if name != "manifest.csv":
                self.assertEqual(self.content(f"whole/{name}"), self.content(f"parts/{name}"))

    def test_names_are_read_back(self):
        name = 'a, "b"\n.off'
        self.write_torus(name)
        command = [name, "--output-dir", "out"]
        self.assertEqual(0, self.run_batch(*command).returncode)
        self.assertEqual("1 input, 1 in the manifest already\n", self.run_batch(*command, "--resume").stdout)
        self.assertIn('\n"a, ""b""\n.off",done,360,', self.content("out/manifest.csv"))

    def test_any_bytes_are_a_manifest_or_refused(self):
        module = load_module()
        header = ",".join(module.COLUMNS) + "\n"
        row = 'a.off,done,1,2,3,4,5,6,7,0.5,8,"of, ""two""\nlines"\n'
        texts = ["", header, header + row, header + row + row, header + row[:20], header + 'a.off,"open\n' + row, "\0" * 99,
                 header[:30], "other,file\n", "1\n"]
        randomness = random.Random(7)
        for _ in range(500):
            text = list(header + row * 2)
            for _ in range(3):
                text[randomness.randrange(len(header), len(text))] = chr(randomness.randrange(256))
            texts.append("".join(text))
        path = self.folder / "manifest.csv"
        for text in texts:
            path.write_bytes(text.encode("latin-1"))
            try:
                manifest = module.Manifest(path, True)
                manifest.append({"input": "new, \"x\".off", "status": "done"})
                os.close(manifest.file)
            except module.Refusal as refusal:
                self.assertIn(str(path), str(refusal))
                self.assertEqual(text.encode("latin-1"), path.read_bytes())
                continue
            written = path.read_bytes()
            again = module.Manifest(path, True)
            self.assertEqual(manifest.inputs | {'new, "x".off'}, again.inputs, text)
            self.assertEqual(written, path.read_bytes())
            os.close(again.file)

    def test_two_batches_do_not_write_one_manifest(self):
        module = load_module()
        first = module.Manifest(self.folder / "manifest.csv", False)
        with self.assertRaisesRegex(module.Refusal, "another cscd-batch"):
            module.Manifest(self.folder / "manifest.csv", True)
        os.close(first.file)

    def test_refuses_what_it_cannot_do(self):
        self.write_torus("a.off")
        self.write("a.obj", "")
        a_to_out = ["a.off", "--output-dir", "out"]
        self.expect_refusal(1, ["no inputs", "--list"], "--output-dir", "out")
        self.expect_refusal(1, ["--output-dir"], "a.off")
        self.expect_refusal(1, ["a.off and a.obj", "ending"], "a.off", "a.obj", "--output-dir", "out")
        self.expect_refusal(1, ["--part", "3/2"], *a_to_out, "--part", "3/2")
        self.expect_refusal(1, ["--part", "x/2"], *a_to_out, "--part", "x/2")
        self.expect_refusal(1, ["{}"], *a_to_out, "--", "-o", "one.graph")
        self.expect_refusal(1, ["--branches", "{}"], *a_to_out, "--", "-o", "{}.graph", "--branches=all.csv")
        self.expect_refusal(1, ["--report"], *a_to_out, "--", "--report", "r.json")
        self.expect_refusal(1, ["--timeout"], *a_to_out, "--timeout", "0")
        self.expect_refusal(1, ["--jobs"], *a_to_out, "--jobs", "0")
        self.expect_refusal(1, ["--program"], *a_to_out, "--program", "nothing")
        self.expect_refusal(2, ["nothing", "check the name"], "--list", "nothing", "--output-dir", "out")
        self.expect_refusal(2, ["a.obj"], "a.off", "--output-dir", "a.obj")
        self.assertFalse((self.folder / "out/manifest.csv").exists())

    def test_help_names_all_options(self):
        outcome = self.run_batch("--help")
        self.assertEqual(0, outcome.returncode)
        for option in re.findall(r'add\("(--[a-z-]+)"', pathlib.Path(BATCH).read_text()):
            self.assertIn(option, outcome.stdout)


if __name__ == "__main__":
    unittest.main()
