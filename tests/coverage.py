"""coverage.py DOCUMENT: reads the JSON of llvm-cov export and writes a table of the program's folders into a document."""
import collections
import datetime
import json
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
layers = ("models", "renderer", "shader", "programs", "diagnose", "lessons", "ui", "app")
folders = collections.defaultdict(lambda: [0, 0, 0, 0])
low = []
for file in json.load(sys.stdin)["data"][0]["files"]:
    path = pathlib.Path(file["filename"])
    if root not in path.parents or path.relative_to(root).parts[0] not in layers:
        continue
    path, lines, branches = path.relative_to(root), file["summary"]["lines"], file["summary"]["branches"]
    counts = (lines["covered"], lines["count"], branches["covered"], branches["count"])
    for folder in {path.parts[0], "/".join(path.parts[:2]) if len(path.parts) > 2 else path.parts[0]}:
        folders[folder] = [a + b for a, b in zip(folders[folder], counts)]
    if lines["count"] >= 20 and lines["covered"] < 0.7 * lines["count"]:
        low.append((path.as_posix(), 100 * lines["covered"] / lines["count"]))


def percent(part, whole):
    return f"{100 * part / whole:.0f} %" if whole else ""


table = "| folder | lines | lines run | branches run |\n|---|---|---|---|\n"
for layer in layers:
    for folder in sorted(f for f in folders if f == layer or f.startswith(layer + "/")):
        run, lines, taken, branches = folders[folder]
        table += f"| `{folder}` | {lines} | {percent(run, lines)} | {percent(taken, branches)} |\n"
table += "\nFiles with less than 70 % of their lines run: " + (", ".join(f"`{p}` ({share:.0f} %)" for p, share in sorted(low)) or "none") + ".\n"
document = pathlib.Path(sys.argv[1])
text = document.read_text()
new = f"<!-- coverage -->\nMeasured by `tests/coverage.sh` on {datetime.date.today():%-d %B %Y}:\n\n{table}<!-- end -->"
document.write_text(re.sub(r"<!-- coverage -->.*?<!-- end -->", lambda _: new, text, flags=re.S))
