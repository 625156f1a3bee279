#!/usr/bin/env python3
"""Engines that are asked by a command: usage: command_test.py ECODS_FUZZ [ECODS_CHECK]"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

FUZZ, *CHECK = sys.argv[1:]
NAIVE = pathlib.Path(__file__).with_name("naive_engine.py")

# An engine that goes wrong at every query, in the way that the environment names.
FAULTY = """
import json, os, sys, time
for line in sys.stdin:
    message = json.loads(line)
    if "query" not in message:
        continue
    with open(os.environ["PIDS"], "a") as pids:
        print(os.getpid(), file=pids)
    kind = os.environ["FAULT"]
    if kind == "hangs once": kind = "hangs" if len(open(os.environ["PIDS"]).readlines()) == 1 else "no"
    if kind == "dies": sys.exit(3)
    if kind == "aborts": os.abort()
    if kind == "hangs": time.sleep(1000)
    if kind == "nonsense": print("yes", flush=True)
    if kind == "number": print(json.dumps({"query": message["query"] + 1, "intersects": True}), flush=True)
    if kind == "type": print(json.dumps({"query": message["query"], "intersects": 1}), flush=True)
    if kind == "no": print(json.dumps({"query": message["query"], "intersects": False}), flush=True)
"""


class Command(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def fuzz(self, command, *options, **environment):
        figures = self.path / "figures.json"
        done = subprocess.run([FUZZ, "--engine-command", command, "--json", figures, *options], capture_output=True,
                              text=True, timeout=100, env=os.environ | environment)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout, json.loads(figures.read_text())["results"]

    def faulty(self, fault):
        engine = self.path / "engine.py"
        engine.write_text(FAULTY)
        self.pids = self.path / "pids"
        return self.fuzz(f"{sys.executable} {engine}", "--runs", "2", "--limit", "1", "--family", "boxes, axis-aligned",
                         FAULT=fault, PIDS=str(self.pids))

    def test_the_example_is_right_where_floats_suffice(self):
        out, results = self.fuzz(f"{sys.executable} {NAIVE}", "--runs", "4", "--family", "boxes, axis-aligned")
        self.assertIn("command: none of 4 answers wrong", out)
        self.assertEqual([r["hits"] for r in results], [4])

    def test_the_example_is_wrong_at_coplanar_triangles_and_its_scenes_can_be_read(self):
        wrong = self.path / "wrong"
        out, results = self.fuzz(f"{sys.executable} {NAIVE}", "--runs", "12", "--family", "triangles, coplanar", "--dump",
                                 wrong, "--pictures", "0")
        self.assertGreater(results[0]["false_negatives"], 0)
        scenes = sorted(wrong.glob("*.json"))
        self.assertEqual(len(scenes), len(results[0]["wrong_queries"]))
        for scene in scenes if CHECK else []:
            truth = json.loads(scene.read_text())["_truth"]
            answer = subprocess.run([CHECK[0], scene], capture_output=True, text=True, check=True).stdout
            self.assertEqual("a | b" in answer, truth == "they share a point", answer)

    def test_no_to_everything_is_wrong(self):
        out, results = self.faulty("no")
        self.assertEqual((results[0]["answered"], results[0]["false_negatives"]), (2, 2))

    def test_a_wrong_answer_is_named_before_a_hang(self):
        out, results = self.faulty("hangs once")
        self.assertEqual((results[0]["answered"], results[0]["hung"]), (1, 1))
        self.assertIn("the first wrong answer: query 1 of 'boxes, axis-aligned', of two that share a point", out)

    def test_what_dies_or_talks_nonsense_is_counted(self):
        for fault, words in (("dies", "ended without an answer"), ("aborts", "ended without an answer"),
                             ("nonsense", 'is no {"query": 0'), ("number", 'is no {"query": 0'),
                             ("type", 'is no {"query": 0')):
            with self.subTest(fault):
                out, results = self.faulty(fault)
                self.assertEqual((results[0]["answered"], results[0]["crashed"], results[0]["hung"]), (0, 2, 0))
                self.assertIn(words, results[0]["first_failure"])
                self.assertIn("2 of 2 queries without an answer", out)

    def test_what_hangs_is_counted_and_ended(self):
        _, results = self.faulty("hangs")
        self.assertEqual((results[0]["answered"], results[0]["crashed"], results[0]["hung"]), (0, 0, 2))
        for pid in self.pids.read_text().split():
            for _ in range(100):
                if not os.path.exists(f"/proc/{pid}"):
                    break
                time.sleep(0.05)
            self.assertFalse(os.path.exists(f"/proc/{pid}"), "the engine lives on")

    def test_a_command_that_is_none_is_counted(self):
        _, results = self.fuzz("/nosuch/engine", "--runs", "1", "--family", "plates")
        self.assertEqual(results[0]["crashed"], 1)


unittest.main(argv=sys.argv[:1])
