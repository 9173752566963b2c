#!/usr/bin/env python3
"""Measures what the tests notice: puts faults into a copy of the product, one a run, and counts those that a test fails for.

Usage: tests/mutate.py [-n COUNT] [--seed N] [--jobs N] [FOLDER...]
COUNT lines are sampled evenly from the one-line statements of the folders (all product folders if none is named). All faults are
compiled at once, into build/mutants, and the environment variable GLINT_FAULT chooses one. A fault that does not compile is left out.
The tests nearest to the line run first, then all unit tests; a run that exceeds its time counts as noticed. Prints each fault that no
test noticed, and the rate per folder. Judge by hand which of them change nothing."""
import argparse, collections, concurrent.futures, os, pathlib, random, re, shutil, subprocess, sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
COPY = ROOT / 'build/mutants'
PRODUCT = ['ui', 'lessons', 'programs', 'renderer', 'models', 'diagnose', 'app']
FAULTS = [  # what someone gets wrong: (name, pattern, replacement), in code without comments and strings
    *(('comparison', f' {a} ', f' {b} ') for a, b in ('<>', '><', ('==', '!='), ('!=', '=='))),
    *(('boundary', f' {a} ', f' {b} ') for a, b in (('<', '<='), ('<=', '<'), ('>', '>='), ('>=', '>'))),
    ('sign', r' \+ ', ' - '), ('sign', r' - ', ' + '), ('sign', r' \+= ', ' -= '), ('sign', r'([=(,] ?)-(?=\w)', r'\1'),
    ('factor', r' \* (?=[\w(])', ' / '), ('factor', r' / (?=[\w(])', ' * '), ('constant', r'(?<![\w.])(\d+\.\d+f?)(?!\w)', r'2 * \1'),
    ('constant', r'(?<![\w.<])(\d+)(?![\w.>])', lambda m: str(int(m[1]) + 1)), ('condition', r'(?<=[( ])!(?=\w)', ''),
    *(('condition', a, b) for a, b in ((' && ', ' || '), (r' \|\| ', ' && '), (r'\btrue\b', 'false'), (r'\bfalse\b', 'true'))),
    ('arguments', r'(?<=\w)\((\w+), (\w+)(?=[,)])', r'(\2, \1'), ('component', r'\.x\b', '.y'), ('component', r'\.y\b', '.z'),
    ('reset', r'^[\w.\->\[\]]+( = [^;{]*|\.(?:clear|reset|push_back|erase)\(.*\));$', ';'),
]
CHOSEN = '#pragma once\nextern int glint_fault;\n#define GLINT_CHOSEN(k) (glint_fault == (k))\n' + ''.join(
    f'#pragma GCC diagnostic ignored "-W{warning}"\n' for warning in 'conversion float-conversion parentheses unused-variable unused-but-set-variable unused-parameter '
    'unused-function sign-compare unused-value dangling-else bool-operation bool-compare int-in-bool-context type-limits empty-body logical-not-parentheses'.split())
LOOP = re.compile(r'(for \([^;]*; )([^;]*)(; .*)$')
SIMPLE = re.compile(r'[\w.\->\[\]*:]+(?: [-+*/|&^]?= .*|\(.*\)|\+\+|--);$|(?:\+\+|--)[\w.\->]+;$')
DEFINED = re.compile(r'((?:const )?[\w:<>, ]+?[*&]? [*&]?\w+ = )([^{\[].*);$')


def closing(text, start):
    """The place of the parenthesis that closes the one before `start`, or -1."""
    return next((i for i in range(start, len(text)) if text[start - 1:i + 1].count('(') == text[start - 1:i + 1].count(')')), -1)


def either(old, new, chosen):
    """One statement that is `new` if the fault is chosen, or None if this form of statement is not known."""
    if old.startswith('if (') and 'if constexpr' not in old and new.startswith('if ('):
        end, new_end = closing(old, 4), closing(new, 4)
        if end < 0 or new_end < 0 or re.match(r'(const )?[\w:<>*& ]+ \w+ = |.*; ', old[4:end]):
            return None
        if old[end:] == new[new_end:]:
            return f'if ({chosen} ? bool({new[4:new_end]}) : bool({old[4:end]}){old[end:]}'
        rest = either(old[end + 2:], new[new_end + 2:], chosen) if old[:end] == new[:new_end] and old.endswith(';') else None
        return rest and f'{old[:end]}) {{ {rest} }}'
    loop, changed = LOOP.match(old), LOOP.match(new)
    if loop and changed and (loop[1], loop[3]) == (changed[1], changed[3]):
        return f'{loop[1]}{chosen} ? bool({changed[2]}) : bool({loop[2]}){loop[3]}'
    if old.startswith('return '):
        return f'{{ if ({chosen}) {new} {old} }}'
    if not old.startswith(('const ', 'auto ', 'static ', 'else', 'case ', 'for ', 'while ')) and SIMPLE.match(old):
        return f'if ({chosen}) {{ {new} }} else {{ {old} }}'
    defined, changed = DEFINED.match(old), DEFINED.match(new)
    if defined and changed and defined[1] == changed[1] and not re.match('static|constexpr|using|return', old):
        return f'{defined[1]}{chosen} ? {changed[2]} : {defined[2]};'
    return None


def faults_of(lines, number):
    """All (name, changed statement) of a line that is a whole statement inside a function."""
    line, before = lines[number], lines[number - 1].strip() if number else ''
    whole = line.endswith((';', '{', ')')) and line.count('(') == line.count(')') and line.count('{') - line.count('}') in (0, 1)
    if not line.startswith('    ') or '//' in line or not whole or not re.match(r'$|//|.*[;{}:]$', before):
        return []
    found, old = [], line.strip()
    code = re.sub(r'"(\\.|[^"\\])*"|\'.*?\'', lambda m: '\0' * len(m[0]), old)
    for name, pattern, replacement in FAULTS:
        for match in (m for m in re.finditer(pattern, code) if '\0' not in m[0]):
            text = match.expand(replacement) if isinstance(replacement, str) else replacement(match)
            found.append((name, old[:match.start()] + text + old[match.end():]))
    return [(name, new) for name, new in found if new != old and either(old, new, 'GLINT_CHOSEN(0)')]


def succeeds(program, tests, seconds, fault):
    """Whether these tests pass within the time."""
    return subprocess.run(['timeout', '-k', '5', str(seconds), f'build/ci/tests/{program}_tests', '-a', *tests], cwd=COPY, capture_output=True,
                          env={**os.environ, 'GLINT_FAULT': str(fault), 'GLINT_WALK_STEPS': '300'}).returncode == 0


def noticed(file, fault):
    """'near' or 'all': the tests that fail; '' if none does."""
    tests = sorted((ROOT / 'tests' / file.parts[0]).rglob('*_test.cpp'))
    near = [t for t in tests if t.parent.name in file.parts[1:]] or [t for t in tests if file.stem.split('_')[0] in t.stem]
    chosen = ','.join(f'[#{test.stem}]~[long]' for test in near)
    if near and not succeeds(file.parts[0], ['--filenames-as-tags', chosen], 300, fault):
        return 'near'
    order = [file.parts[0], *(layer for layer in PRODUCT if layer != file.parts[0])]
    return '' if all(succeeds(layer, ['~[long]'], 1200, fault) for layer in order) else 'all'


def write(faults):
    """Writes the copy with these faults; files that stay the same keep their time."""
    for file in subprocess.run(['git', 'ls-files'], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines():
        text, at = (ROOT / file).read_bytes(), COPY / file
        here = {number: (k, new) for k, (path, number, _, new) in faults.items() if str(path) == file}
        if here:
            lines = text.decode().split('\n')
            for number, (k, new) in here.items():
                lines[number] = '    ' + either(lines[number].strip(), new, f'GLINT_CHOSEN({k})')
            text = '\n'.join(['#include "chosen.h"', f'#line 1 "{at}"', *lines]).encode()
        if file == 'models/io/file.cpp':
            text += b'\n#include <cstdlib>\nint glint_fault = std::atoi(std::getenv("GLINT_FAULT") ? std::getenv("GLINT_FAULT") : "0");\n'
        at.parent.mkdir(parents=True, exist_ok=True)
        if not at.exists() or at.read_bytes() != text:
            at.write_bytes(text)
            shutil.copymode(ROOT / file, at)
    (COPY / 'chosen.h').exists() or (COPY / 'chosen.h').write_text(CHOSEN)


def build(faults):
    """Builds the copy, and removes those faults that do not compile."""
    while faults:
        write(faults)
        subprocess.run(['cmake', '--preset', 'ci', '-DGLINT_TESTS=ON'], cwd=COPY, stdout=subprocess.DEVNULL, check=True)
        done = subprocess.run(['ninja', '-k0', '-C', 'build/ci', *(f'{layer}_tests' for layer in PRODUCT)], cwd=COPY, capture_output=True, text=True)
        if done.returncode == 0:
            return
        wrong = re.findall(rf'{COPY}/([\w/.]+):(\d+):\d+: (?:error|  required)', done.stdout)
        for k in [k for k, f in faults.items() if (str(f[0]), str(f[1] + 1)) in wrong] or sys.exit(done.stdout[-4000:]):
            del faults[k]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, usual in (('-n', 200), ('--seed', 1), ('--jobs', 1)):
        options.add_argument(name, type=int, default=usual)
    options.add_argument('folders', nargs='*', default=PRODUCT)
    given = options.parse_args()
    places, chance = [], random.Random(given.seed)
    for path in sorted(p for folder in given.folders for p in (ROOT / folder).rglob('*') if p.suffix in ('.cpp', '.h')):
        lines = path.read_text().split('\n')
        places += [(path.relative_to(ROOT), number, lines) for number in range(len(lines)) if faults_of(lines, number)]
    step = max(1, len(places) // given.n)
    faults = {k: (file, number, *chance.choice(faults_of(lines, number)))
              for k, (file, number, lines) in enumerate(places[chance.randrange(step)::step], 1)}
    build(faults)
    tried, killed = collections.Counter(), collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for (file, number, name, new), result in zip(faults.values(), pool.map(lambda k: noticed(faults[k][0], k), faults)):
            for folder in ('/'.join(file.parts[:2]), 'all'):
                tried[folder] += 1
                killed[folder] += result != ''
            print(f'{"noticed " + result if result else "UNNOTICED"}: {file}:{number + 1} {name}: {new}', flush=True)
    for folder, count in sorted(tried.items(), key=lambda item: (item[0] == 'all', item[0])):
        print(f'{folder:30} {killed[folder]:3} of {count:3}, {100 * killed[folder] / count:.0f} %')


if __name__ == '__main__':
    main()
