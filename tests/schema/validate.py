"""validate.py GLINT SOURCE: checks the schema that `glint schema` prints with an independent validator.

Every scene in assets/scenes must be valid, and every scene in bad_scenes.json must be rejected by the schema and by the program,
or by the program alone if a schema cannot express the condition, which involves several numbers ("beyond": true).
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema


def program_refuses(glint, scene):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(scene, file)
        file.flush()
        return subprocess.run([glint, "info", file.name], capture_output=True).returncode == 1


def main():
    glint, source = sys.argv[1], pathlib.Path(sys.argv[2])
    schema = json.loads(subprocess.run([glint, "schema"], capture_output=True, check=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    wrong = []

    scenes = sorted((source / "assets/scenes").glob("*.json"))
    for path in scenes:
        for error in validator.iter_errors(json.loads(path.read_text())):
            wrong.append(f"{path.name}: {error.json_path}: {error.message}")

    bad = json.loads((source / "tests/schema/bad_scenes.json").read_text())
    for case in bad:
        scene = case["scene"]
        if isinstance(scene, dict) and case.get("version", True):
            scene = {"glint": 1, **scene}
        beyond = case.get("beyond", False)
        if validator.is_valid(scene) != beyond:
            wrong.append(f"the schema {'rejects' if beyond else 'accepts'} {json.dumps(scene)}")
        if not program_refuses(glint, scene):
            wrong.append(f"the program accepts {json.dumps(scene)}")

    counts = f"{len(scenes)} scenes, {len(bad)} bad ones"
    if len(scenes) < 30 or len(bad) < 60:
        wrong.append(f"too few: {counts}")
    print("\n".join(wrong) if wrong else counts)
    sys.exit(1 if wrong else 0)


main()
