#!/usr/bin/env python3
"""gradescope_schema.py RESULTS.json: whether it is what Gradescope documents; a wrong key is named."""
import json
import sys

VISIBLE = {"hidden", "after_due_date", "after_published", "visible"}
FORMATS = {"text", "html", "simple_format", "md", "ansi"}
NUMBER = (int, float)
TEST = {"score": NUMBER, "max_score": NUMBER, "status": {"passed", "failed"}, "name": str, "name_format": FORMATS,
        "number": str, "output": str, "output_format": FORMATS, "tags": list, "visibility": VISIBLE,
        "extra_data": dict}
WHOLE = {"score": NUMBER, "execution_time": NUMBER, "output": str, "output_format": FORMATS,
         "test_output_format": FORMATS, "test_name_format": FORMATS, "visibility": VISIBLE,
         "stdout_visibility": VISIBLE, "extra_data": dict, "tests": list, "leaderboard": list}


def check(values, schema):
    for key, value in values.items():
        wanted = schema.get(key) or sys.exit(f"there is no key {key}")
        fits = value in wanted if isinstance(wanted, set) else isinstance(value, wanted)
        if not fits or isinstance(value, bool):
            sys.exit(f"{key}: {value!r}")


with open(sys.argv[1], encoding="utf-8") as file:
    results = json.load(file)
check(results, WHOLE)
for test in results.get("tests", []):
    check(test, TEST)
    if test.get("score", 0) > test.get("max_score", float("inf")):
        sys.exit(f"more than the most: {test}")
if "score" not in results and not all("score" in test for test in results.get("tests", [])):
    sys.exit("no score")
