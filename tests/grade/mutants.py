#!/usr/bin/env python3
"""Checks that `vidno grade` catches mutants: copies of right programs that differ in one token or one statement.

    mutants.py VIDNO CLANG HEADER WORK [--every N] [--least PERCENT] [--report FILE]

HEADER is the folder of the precompiled header. Each mutant is compiled once and graded. A mutant that is called right survives. A survivor
is graded again on many more random scenes. If it is wrong on one of them, that scene distinguishes it from a right program, so the grader
has missed it. Otherwise its traces are compared with those of the right program, and the report says how they differ. The exit status is 1
if the grader catches fewer than PERCENT of the mutants that some scene distinguishes.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
STUDENT = HERE.parent.parent / 'lessons' / 'student'
PROGRAMS = [HERE / 'right' / 'warnock.cpp', HERE / 'right' / 'z_buffer.cpp']

OPERATORS = {'<': ['<=', '>'], '<=': ['<'], '>': ['>=', '<'], '>=': ['>'], '==': ['!='], '!=': ['=='], '+': ['-'], '-': ['+'], '*': ['/'],
             '/': ['*'], '%': ['*'], '&&': ['||'], '||': ['&&'], '+=': ['-='], '*=': ['/=']}
NAMES = {'true': 'false', 'false': 'true', 'min': 'max', 'max': 'min', 'ceil': 'floor', 'x': 'y', 'y': 'x', 'width': 'height',
         'height': 'width', 'left': 'right', 'right': 'left', 'xmin': 'xmax', 'xmax': 'xmin', 'ymin': 'ymax', 'ymax': 'ymin',
         'front': 'back', 'back': 'front', 'p': 'q', 'q': 'p', 'from': 'to', 'to': 'from', 'u': 'v', 'v': 'u', 'dx': 'dz', 'dz': 'dx',
         'first_row': 'last_row', 'last_row': 'first_row', 'bottom': 'right', 'first': 'end', 'z': 'x', 'a': 'b', 'b': 'a', 'd': 'c',
         'all_of': 'any_of', 'p_outward': 'q_outward', 'q_outward': 'p_outward'}
TOKEN = re.compile(r'(?P<number>(?<![\w.])\d+(?:\.\d+)?(?![\w.]))|(?P<name>\b[A-Za-z_]\w*\b)|'
                   r'(?P<operator>(?<= )(?:<=|>=|==|!=|&&|\|\||\+=|\*=|[-+*/%<>])(?= ))|(?P<step>\+\+|--)|(?P<prefix>(?<=[( ])[!-](?=[\w(]))')
DECLARES = re.compile(r'\s*(?:return\b(?!;)|const\b|double\b|int\b|bool\b|std::vector|auto\b|using\b|struct\b|Window \w|Vertex \w|Summary \w|'
                      r'Scene|Color \w|Point \w|Area|Plane \w|WarnockTrace|ZBufferTrace|Box \w|Edge \w)')


def without_comments(line):
    return re.sub(r'//.*', '', line)


def mutants_of(text):
    """Yields each mutant as its line number, the change in words, and its whole text."""
    lines = text.split('\n')

    def changed(number, line):
        return '\n'.join(lines[:number] + [line] + lines[number + 1:])

    for number, line in enumerate(lines):
        code = without_comments(line)
        if code.startswith('#') or 'using namespace' in code or '"' in code or not code.startswith('    '):
            if not re.match(r'(?:const|int|inline|double) .*[;}]', code):
                continue
        for match in TOKEN.finditer(code):
            old, kind = match.group(), match.lastgroup
            if kind == 'number':
                value = float(old)
                new = ['1'] if value == 0 else ['0', '2'] if value == 1 else [str(int(value) + 1), str(int(value) - 1)] if value.is_integer() else ['0']
            elif kind == 'name':
                new = [NAMES[old]] if old in NAMES else []
            elif kind == 'operator':
                new = OPERATORS.get(old, [])
            elif kind == 'step':
                new = ['--' if old == '++' else '++']
            else:
                new = ['']
            for each in new:
                yield number + 1, f'{old} -> {each or "nothing"}', changed(number, code[:match.start()] + each + code[match.end():])
        statement = code.strip()
        if statement.endswith(';') and not DECLARES.match(code) and statement.count('(') == statement.count(')'):
            yield number + 1, 'dropped', changed(number, re.match(r'\s*', code).group() + ';')


class Course:
    """Compiles programs and grades them."""

    def __init__(self, vidno, clang, header, work):
        self.vidno, self.clang, self.header, self.work = vidno, clang, header, work
        work.mkdir(parents=True, exist_ok=True)

    def compiled(self, name, text):
        """The path of the program; None if it does not compile."""
        source, program = self.work / f'{name}.cpp', self.work / name
        source.write_text(text, encoding='utf-8')
        done = subprocess.run([self.clang, '-std=c++14', '-w', '-I', str(STUDENT), '-include-pch', str(self.header / 'example.pch'),
                               str(source), str(self.header / 'example.o'), '-o', str(program)], capture_output=True, check=False)
        source.unlink()
        return program if done.returncode == 0 else None

    def is_caught(self, program, *options, patience=5):
        """Whether the grader fails the program, and its report."""
        caught, said = self.graded(program, '--seconds', '1', *options)
        # On a busy machine a program that ends may exceed the short limit.
        is_late = caught and 'did not end within' in said
        return self.graded(program, '--seconds', str(patience), *options) if is_late else (caught, said)

    def graded(self, program, *options):
        done = subprocess.run([self.vidno, 'grade', str(program), '--first', '--no-sandbox', *options], text=True, errors='replace',
                              capture_output=True, check=False)
        if done.returncode not in (0, 1, 2):
            raise RuntimeError(f'{program}: exit status {done.returncode}\n{done.stdout}{done.stderr}')
        return done.returncode != 0, done.stdout + done.stderr

    def scenes(self, program):
        """The files of the scenes on which a program is graded."""
        folder = self.work / 'scenes'
        folder.mkdir(exist_ok=True)
        for old in folder.iterdir():
            old.unlink()
        listener = self.work / 'listener'
        listener.write_text(f'#!/bin/sh\ncp "$VIDNO_SCENE" "{folder}/$$"\nexec "{program}"\n', encoding='utf-8')
        listener.chmod(0o755)
        self.is_caught(listener)
        return sorted(folder.iterdir())

    def traces(self, program, scenes):
        """Maps each scene to the lines of the program's trace."""
        trace = self.work / f'{program.name}.trace'
        found = {}
        for scene in scenes:
            environment = dict(os.environ, VIDNO_SCENE=str(scene), VIDNO_TRACE=str(trace))
            subprocess.run([str(program)], env=environment, capture_output=True, check=False, timeout=120)
            found[scene] = trace.read_text(encoding='utf-8').split('\n')
        return found


def difference(right, told):
    """Says how the traces of a survivor differ from the right ones."""
    kinds = set()
    pictures = 0
    for scene, lines in right.items():
        mine = told[scene]
        pictures += lines[-2].split('sha256')[-1] != mine[-2].split('sha256')[-1]
        for line in set(lines) ^ set(mine):
            kinds.update(re.findall(r'^\{"e":"(\w+)"', line))
    if not kinds and all(lines == told[scene] for scene, lines in right.items()):
        return 'the same traces'
    if not pictures:
        return 'the same pictures; other events: ' + (', '.join(sorted(kinds)) or 'their order')
    return f'{pictures} other pictures, as right (outlines or equal depths); other events: ' + ', '.join(sorted(kinds))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('vidno')
    parser.add_argument('clang')
    parser.add_argument('header', type=pathlib.Path)
    parser.add_argument('work', type=pathlib.Path)
    parser.add_argument('--every', type=int, default=1, help='take one mutant in N')
    parser.add_argument('--least', type=float, default=95, help='percent that must be caught')
    parser.add_argument('--more', type=int, default=300, help='random scenes for each survivor')
    parser.add_argument('--jobs', type=int, default=2)
    parser.add_argument('--report', type=pathlib.Path)
    options = parser.parse_args()
    course = Course(options.vidno, options.clang, options.header, options.work.resolve())

    counts = {'made': 0, 'mutants': 0, 'caught': 0, 'missed': 0, 'never told': 0}
    survivors = []

    def judge(job):
        """The line and the change; the program if it survives; whether the grader missed it, and its report."""
        source, index, line, change, text = job
        program = course.compiled(f'{source.stem}_{index}', text)
        if not program:
            return None
        caught, _ = course.is_caught(program)
        if caught:
            program.unlink()
            return line, change, None, False, ''
        missed, said = course.is_caught(program, '--random', str(options.more), '--seed', '4711', patience=60)
        return line, change, program, missed, said

    for source in PROGRAMS:
        text = source.read_text(encoding='utf-8')
        right = course.compiled(source.stem, text)
        caught, said = course.is_caught(right)
        if caught:
            sys.exit(f'{source}: called wrong\n{said}')
        unique = {}
        for line, change, mutant in mutants_of(text):
            unique.setdefault(mutant, (line, change))
        jobs = [(source, index, line, change, mutant) for index, (mutant, (line, change)) in enumerate(unique.items())]
        jobs = jobs[options.every // 2::options.every]
        counts['made'] += len(jobs)
        right_traces = None
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            for judged in pool.map(judge, jobs):
                if not judged:
                    continue
                line, change, program, missed, said = judged
                counts['mutants'] += 1
                if not program:
                    counts['caught'] += 1
                    continue
                if missed:
                    counts['missed'] += 1
                    reason = 'MISSED: ' + ' '.join(said.split('Wrong on')[-1].split())[:300]
                else:
                    counts['never told'] += 1
                    right_traces = right_traces or course.traces(right, course.scenes(right))
                    reason = difference(right_traces, course.traces(program, list(right_traces)))
                survivors.append(f'{source.name}:{line}: {change}: {text.split(chr(10))[line - 1].strip()}\n    {reason}')
                print(f"{counts['mutants']} mutants: {survivors[-1]}", flush=True)
                program.unlink()

    told = counts['caught'] + counts['missed']
    percent = 100 * counts['caught'] / max(told, 1)
    summary = (f"{counts['made']} mutants, {counts['mutants']} that compile: {counts['caught']} caught; {counts['missed']} missed; "
               f"{counts['never told']} that no scene was found to tell. Caught of those that a scene tells: {percent:.1f} %\n")
    report = summary + ''.join(each + '\n' for each in survivors)
    print(summary, end='')
    if options.report:
        options.report.write_text(report, encoding='utf-8')
    sys.exit(0 if percent >= options.least else 1)


main()
