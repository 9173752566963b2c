#!/usr/bin/env python3
"""Measures what the tests notice: puts faults into a copy of the program and counts those that make a test fail.

Usage: tests/mutate.py [-n COUNT] [--seed N] [--jobs N] [--seconds N] [FOLDER...]
Samples COUNT one-line statements evenly from the folders (default: the entire program) and compiles a fault into each, all at once, in
build/mutants; GLINT_FAULT=NUMBER in the environment selects one. First, each test that is not [long] runs without a fault to find out
which faults it reaches. Then, for each fault, the tests that reach it run until one fails, one takes ten times as long as usual, or N
seconds (300) have passed. Tests of the fault's layer, quick ones, and ones that reach few faults run first. Judge by hand which
unnoticed faults change nothing."""
import argparse, collections, concurrent.futures, os, pathlib, random, re, subprocess, sys, tempfile, time

ROOT = pathlib.Path(__file__).resolve().parent.parent
COPY = ROOT / 'build/mutants'
PRODUCT = ['ui', 'lessons', 'programs', 'renderer', 'models', 'diagnose', 'shader', 'app']
TESTS = [*(f'tests/{layer}_tests' for layer in PRODUCT), 'tests/programs/written_program_tests']
FAULTS = [  # typical errors: (name, pattern, replacement), in code without comments and strings
    *(('comparison', f' {a} ', f' {b} ') for a, b in ('<>', '><', ('==', '!='), ('!=', '=='), ('<', '<='), ('<=', '<'), ('>', '>='), ('>=', '>'))),
    ('sign', r' \+ ', ' - '), ('sign', r' - ', ' + '), ('sign', r' \+= ', ' -= '), ('sign', r'([=(,] ?)-(?=\w)', r'\1'),
    ('factor', r' \* (?=[\w(])', ' / '), ('factor', r' / (?=[\w(])', ' * '), ('constant', r'(?<![\w.])(\d+\.\d+f?)(?!\w)', r'2 * \1'),
    ('constant', r'(?<![\w.<])(\d+)(?![\w.>])', r'(\1 + 1)'), ('condition', r'(?<=[( ])!(?=\w)', ''),
    *(('condition', a, b) for a, b in ((' && ', ' || '), (r' \|\| ', ' && '), (r'\btrue\b', 'false'), (r'\bfalse\b', 'true'))),
    ('arguments', r'(?<=\w)\((\w+), (\w+)(?=[,)])', r'(\2, \1'), ('component', r'\.x\b', '.y'), ('component', r'\.y\b', '.z'),
    ('reset', r'^[\w.\->\[\]]+( = [^;{]*|\.(?:clear|reset|push_back|erase)\(.*\));$', ';'),
]
WARNINGS = ('conversion float-conversion parentheses unused-variable unused-but-set-variable unused-parameter unused-function sign-compare unused-value '
            'dangling-else bool-operation bool-compare int-in-bool-context type-limits empty-body logical-not-parentheses maybe-uninitialized').split()
CHOSEN = """#pragma once
#include <fcntl.h>
#include <sys/mman.h>
#include <cstdlib>
inline const int glint_fault = std::getenv("GLINT_FAULT") ? std::atoi(std::getenv("GLINT_FAULT")) : 0;
inline char* const glint_reached = static_cast<char*>(std::getenv("GLINT_REACHED")
    ? mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, open(std::getenv("GLINT_REACHED"), O_RDWR), 0) : std::calloc(1, 4096));
#define GLINT_CHOSEN(k) (glint_reached[k] = 1, glint_fault == (k))
""" + ''.join(f'#pragma GCC diagnostic ignored "-W{warning}"\n' for warning in WARNINGS)
PARENTHESES = r'\((?:[^()]|\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\))*\)'
IF = re.compile(rf'if ((?!\((?:const )?[\w:<>*& ]+ \w+ = |\(.*; ){PARENTHESES}) ?(.*)$')  # the condition defines nothing
LOOP = re.compile(r'(for \([^;]*; )([^;]*)(; .*)$')  # here and below, the second group changes
DEFINITION = re.compile(r'((?!static|constexpr|using|return)[\w:<>, ]+?[*&]? [*&]?\w+ = )([^{\[].*)(;)$')
OTHER = re.compile(r'(?!const |auto |static |else|case |for |while )(?:[\w.\->\[\]*:]+(?: [-+*/|&^]?= .*|\(.*\)|\+\+|--);$|(?:\+\+|--)[\w.\->]+;$)')


def either(old, new, chosen):
    """Returns a statement that acts as `new` if the fault is chosen, or None if this form of statement is not supported."""
    if (a := IF.match(old)) and (b := IF.match(new)):
        if a[2] == b[2]:
            return f'if ({chosen} ? bool{b[1]} : bool{a[1]}) {a[2]}'
        inner = either(a[2], b[2], chosen) if a[1] == b[1] and old.endswith(';') else None
        return inner and f'if {a[1]} {{ {inner} }}'
    if old.startswith('return '):
        return f'{{ if ({chosen}) {new} {old} }}'
    if OTHER.match(old):
        return f'if ({chosen}) {{ {new} }} else {{ {old} }}'
    for form in (LOOP, DEFINITION):
        if (a := form.match(old)) and (b := form.match(new)) and (a[1], a[3]) == (b[1], b[3]):
            return f'{a[1]}{chosen} ? ({b[2]}) : ({a[2]}){a[3]}'
    return None


def faults_of(lines, number):
    """Returns all (name, changed statement) of a line that is a complete statement inside a function."""
    line, before = lines[number], lines[number - 1].strip() if number else ''
    whole = line.endswith((';', '{', ')')) and line.count('(') == line.count(')') and line.count('{') - line.count('}') in (0, 1)
    if not line.startswith('    ') or '//' in line or not whole or not re.match(r'$|//|.*[;{}:]$', before):
        return []
    old = line.strip()
    code = re.sub(r'"(\\.|[^"\\])*"|\'.*?\'', lambda m: '\0' * len(m[0]), old)
    found = [(name, old[:m.start()] + m.expand(changed) + old[m.end():]) for name, pattern, changed in FAULTS
             for m in re.finditer(pattern, code) if '\0' not in (code if name == 'sign' else m[0])]
    return [(name, new) for name, new in found if new != old and either(old, new, 'true')]


def succeeds(test, seconds, **environment):
    """Returns whether a test, (program, name), passes within the time."""
    return subprocess.run(['timeout', str(seconds), test[0], re.sub(r'([\\,\[])', r'\\\1', test[1])], cwd=COPY, stdin=subprocess.DEVNULL,
                          capture_output=True, env={**os.environ, **environment, 'GLINT_WALK_STEPS': '300'}).returncode == 0


def seen_by(test):
    """Runs a test without a fault: (seconds, faults that it reaches, test). Reports no faults if it fails or takes a minute."""
    with tempfile.NamedTemporaryFile() as reached:
        os.truncate(reached.name, 4096)
        began = time.monotonic()
        passed = succeeds(test, 60, GLINT_REACHED=reached.name)
        return time.monotonic() - began, {k for k, mark in enumerate(reached.read()) if mark and passed}, test


def noticed(fault, layer, known, seconds):
    """Returns the result for a fault; `known` contains the results of seen_by() in order."""
    order = sorted((seen for seen in known if fault in seen[1]), key=lambda seen: f'/{layer}' not in seen[2][0])
    end = time.monotonic() + seconds
    for tried, (usual, _, test) in enumerate(order):
        if time.monotonic() > end:
            return f'UNNOTICED by {tried} of {len(order)} tests'
        if not succeeds(test, int(20 + 10 * usual), GLINT_FAULT=str(fault)):
            return f'noticed by {test[0].rsplit("/")[-1]} "{test[1]}"'
    return f'UNNOTICED by {len(order)} tests'


def build(faults):
    """Writes the copy and builds it; removes faults that do not compile. Unchanged files keep their timestamps."""
    listed = subprocess.run(['git', 'ls-files', '-co', '--exclude-standard'], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    files = [file for file in listed.splitlines() if (ROOT / file).exists()]
    for removed in {str(path.relative_to(COPY)) for path in COPY.glob('[!b]*/**/*.*')} - {*files}:
        (COPY / removed).unlink()
    for file in [*files, 'chosen.h']:
        text, at = CHOSEN.encode() if file == 'chosen.h' else (ROOT / file).read_bytes(), COPY / file
        if here := {number: (k, new) for k, (path, number, _, new) in faults.items() if str(path) == file}:
            lines = text.decode().split('\n')
            for number, (k, new) in here.items():
                lines[number] = either(lines[number].strip(), new, f'GLINT_CHOSEN({k})')
            text = '\n'.join(['#include "chosen.h"', f'#line 1 "{at}"', *lines]).encode()
        at.parent.mkdir(parents=True, exist_ok=True)
        if not at.exists() or at.read_bytes() != text:
            at.write_bytes(text)
            at.chmod(0o755)
    subprocess.run(['cmake', '--preset', 'ci', '-DGLINT_TESTS=ON'], cwd=COPY, stdout=subprocess.DEVNULL, check=True)
    done = subprocess.run(['ninja', '-k0', '-C', 'build/ci', 'glint', *TESTS], cwd=COPY, capture_output=True, text=True)
    if done.returncode != 0:
        wrong = re.findall(rf'{COPY}/([\w/.]+):(\d+):\d+: (?:error|  required)', done.stdout)
        for k in [k for k, f in faults.items() if (str(f[0]), str(f[1] + 1)) in wrong] or sys.exit(done.stdout[-4000:]):
            del faults[k]
        build(faults)


options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
for name, usual in ('-n', 200), ('--seed', 1), ('--jobs', os.cpu_count()), ('--seconds', 300):
    options.add_argument(name, type=int, default=usual)
options.add_argument('folders', nargs='*', default=PRODUCT)
given = options.parse_args()
places, chance = [], random.Random(given.seed)
for path in sorted(p for folder in given.folders for p in (ROOT / folder).rglob('*.*')
                   if p.suffix == '.cpp' or p.suffix == '.h' and '<Number F' in p.read_text()):  # few files include those headers
    lines = path.read_text().split('\n')
    places += [(path.relative_to(ROOT), number, lines) for number in range(len(lines)) if faults_of(lines, number)]
step = max(1, len(places) // given.n)
faults = {k: (file, number, *chance.choice(faults_of(lines, number)))
          for k, (file, number, lines) in enumerate(places[chance.randrange(step)::step], 1)}
build(faults)
tests = [(f'build/ci/{program}', name) for program in TESTS for name in subprocess.run(
    [f'build/ci/{program}', '--list-test-names-only', '~[long]'], cwd=COPY, capture_output=True, text=True).stdout.splitlines()]
seen = collections.defaultdict(list)
with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
    known = sorted(pool.map(seen_by, tests), key=lambda seen: seen[0] * len(seen[1]))
    results = pool.map(lambda k: noticed(k, faults[k][0].parts[0], known, given.seconds), faults)
    for (k, (file, number, name, new)), result in zip(faults.items(), results):
        print(f'{k} {file}:{number + 1} {name}: {new}\n    {result}', flush=True)
        for folder in (str(file.parent), 'all'):
            seen[folder].append(result.startswith('noticed'))
for folder, each in sorted(seen.items(), key=lambda item: (item[0] == 'all', item[0])):
    print(f'{folder:30} {sum(each):3} of {len(each):3}, {100 * sum(each) / len(each):.0f} %')
