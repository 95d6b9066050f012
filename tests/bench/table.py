#!/usr/bin/env python3
"""Times whole runs of the program, each in a process of its own, and prints them beside their goals.

    table.py PROGRAM EXAMPLES [--web PROGRAM.js] [--quick] [--runs N] [--json OUT] [--against OLD]
             [--picture OUT.svg] [--page BENCH.md]

CPU time is of all threads and what the kernel did for them: on a machine that others use as well it
is what tells. Peak is the most memory held at once. Results of one machine compare with its own."""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

import capsules
import growth
import page
import peers
import speed

# Per row: CPU seconds, MB. Of the 15 parts of hero in 3 frames unless the name says otherwise.
GOALS = {
    'hero, grid 100, 1 thread': (0.45, None),
    'hero, grid 512': (20, 2048),
    'hero, by the paper': (6, None),
    'hero, drawings 10 times as large': (3, 1024),
    '60 parts, 12 frames': (None, 2048),
}
WALL_GOALS = {'hero, grid 100, 2 threads': 0.28}
GALLERY_GOAL = 2.5      # CPU seconds of any of its figures, grid 100, 1 thread
ONE_SKIN_GOAL = 0.4     # seconds, of any figure
CALIBRATE_GOAL = 2.5    # of 60 parts in 12 frames
GRID_EXPONENT_GOAL = 2.3


def timed(command, environment=None):
    """Wall seconds, CPU seconds and peak MB of a process that must end well."""
    began = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                             env=environment)
    _, status, usage = os.wait4(child.pid, 0)
    wall = time.monotonic() - began
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode:
        raise SystemExit(f'{" ".join(map(str, command))} ended with {child.returncode}')
    return wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


class Bench:
    def __init__(self, program, examples, runs, place):
        self.program, self.examples, self.runs, self.place = program, examples, runs, place
        self.rows = {}
        self.grown = []  # growth.Growth
        self.notes = []  # further lines: a stage beside its goal, what others took or why they are left out

    def capsules(self, parts, frames):
        path = self.place / f'{parts}x{frames}.artisketch'
        path.write_text(json.dumps(capsules.document(parts, frames)))
        return path

    def example(self, name):
        return self.examples / name / f'{name}.artisketch'

    def row(self, name, document, *flags, program=None, runs=None):
        report = self.place / 'report.json'
        command = [*(program or [self.program]), 'reconstruct', document, '-o', self.place / 'out.glb',
                   '--quiet', '--report', report, *map(str, flags)]
        found = {'wall': [], 'cpu': [], 'peak': [], 'stages': {}}
        for _ in range(runs or self.runs):
            for figure, value in zip(('wall', 'cpu', 'peak'), timed(command)):
                found[figure].append(value)
            for stage in json.loads(report.read_text())['stages']:
                found['stages'].setdefault(stage['stage'], []).append(stage['cpu_seconds'])
        self.rows[name] = found
        self.show(name, found)
        return found

    def show(self, name, found):
        wall, cpu, peak = (speed.median(found[f]) for f in ('wall', 'cpu', 'peak'))
        cpu_goal, peak_goal = GOALS.get(name, (None, None))
        words = [speed.judged(cpu, cpu_goal), speed.judged(peak, peak_goal),
                 speed.judged(wall, WALL_GOALS.get(name))]
        skin = speed.median(found['stages'].get('one skin', [0]))
        if skin > ONE_SKIN_GOAL:
            words.append(f'one skin {skin:.2f} s: ' + speed.judged(skin, ONE_SKIN_GOAL))
        print(f'{name:40s} {wall:7.2f} s wall {cpu:7.2f} s CPU {peak:6.0f} MB  '
              + '  '.join(w for w in words if w), flush=True)

    def growth(self, what, sizes, names, goal=None):
        grown = growth.Growth(what, sizes, [speed.median(self.rows[name]['cpu']) for name in names])
        self.grown.append(grown)
        print(f'{"CPU time grows with " + what + " ^":40s} {grown.exponent:7.2f}  '
              f'{speed.judged(grown.exponent, goal)}', flush=True)


def larger_drawings(bench, times):
    """The hero's drawings enlarged, and the document with them."""
    document = json.loads(bench.example('hero').read_text())
    place = bench.place / 'large'
    place.mkdir()
    scale = lambda points: [[times * c for c in p] for p in points]
    camera = document['camera']
    for figure in ('pixels_per_unit', 'focal_length'):
        if figure in camera:
            camera[figure] *= times
    for frame in document['frames']:
        subprocess.run(['convert', bench.example('hero').parent / frame['image'], '-filter', 'point',
                        '-resize', f'{100 * times}%', place / frame['image']], check=True)
        frame['size'] = [times * side for side in frame['size']]
        if 'principal_point' in frame:
            frame['principal_point'] = [times * c for c in frame['principal_point']]
        for contour in frame['contours']:
            contour['points'] = scale(contour['points'])
    path = place / 'hero.artisketch'
    path.write_text(json.dumps(document))
    return path


def native(bench, quick):
    hero = bench.example('hero')
    for threads in (1, 2):
        bench.row(f'hero, grid 100, {threads} thread' + 's' * (threads > 1), hero, '--threads', threads)
    for name in ('fox', 'robot'):
        bench.row(f'{name}, grid 100', bench.example(name), '--threads', 1)
    grids = (48, 100, 200, 512) if quick else (48, 72, 100, 144, 200, 288, 400, 512)
    for grid in grids:
        bench.row(f'hero, grid {grid}', hero, '--grid', grid, '--threads', 1,
                  runs=1 if grid > 200 else None)
    bench.growth('the grid', grids, [f'hero, grid {g}' for g in grids], GRID_EXPONENT_GOAL)
    parts = (5, 15, 30) if quick else (5, 15, 30, 60)
    for n in parts:
        bench.row(f'{n} parts, 3 frames', bench.capsules(n, 3), '--threads', 1)
    bench.growth('parts', parts, [f'{n} parts, 3 frames' for n in parts])
    frames = (2, 6) if quick else (2, 4, 8, 12)
    for n in frames:
        bench.row(f'15 parts, {n} frames', bench.capsules(15, n), '--threads', 1)
    bench.growth('frames', frames, [f'15 parts, {n} frames' for n in frames])
    if not quick:
        largest = bench.row('60 parts, 12 frames', bench.capsules(60, 12), '--threads', 1, runs=1)
        took = speed.median(largest['stages']['calibrate'])
        print(f'{"  of it calibration":40s} {took:7.2f} s  {speed.judged(took, CALIBRATE_GOAL)}')
        bench.notes.append(f'calibration of 60 parts in 12 frames: {took:.2f} s '
                           f'({speed.judged(took, CALIBRATE_GOAL)})')
        if shutil.which('convert'):
            bench.row('hero, drawings 10 times as large', larger_drawings(bench, 10), '--threads', 1,
                      runs=1)
        else:
            print('large drawings: left out, there is no convert (imagemagick)')
    bench.row('hero, by the paper', hero, '--method', 'paper', '--threads', 1, runs=1)
    for document in [] if quick else sorted(bench.examples.parent.glob('gallery/*/*.artisketch')):
        GOALS[f'{document.stem}, gallery'] = (GALLERY_GOAL, None)
        bench.row(f'{document.stem}, gallery', document, '--threads', 1)


def web(bench, program):
    """The page's modules under node: how long they take to start, and the stages beside native ones."""
    node = ['node', '--no-experimental-fetch', program]
    if subprocess.run([*node, '--version'], capture_output=True).returncode:
        node = ['node', program]
    starts = [timed([*node, '--version'])[0] for _ in range(bench.runs)]
    print(f'{"WebAssembly: start":40s} {speed.median(starts):7.2f} s wall')
    document = bench.example('hero')
    made = bench.row('hero, grid 64, WebAssembly', document, '--grid', 64, program=node)
    here = bench.row('hero, grid 64', document, '--grid', 64, '--threads', 1)
    for stage, seconds in made['stages'].items():
        natively = speed.median(here['stages'][stage])
        print(f'  {stage:38s} {speed.median(seconds):7.3f} s, native {natively:.3f} s: '
              f'{speed.median(seconds) / max(natively, 1e-9):.2f} times')


def main():
    words = argparse.ArgumentParser(description=__doc__,
                                    formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument('program')
    words.add_argument('examples', type=pathlib.Path)
    words.add_argument('--web', help='the program compiled for the web')
    words.add_argument('--quick', action='store_true', help='some two minutes: fewer and smaller figures')
    words.add_argument('--runs', type=int, help='of each figure (5; quick: 3)')
    words.add_argument('--json', type=pathlib.Path, help='where to keep the results')
    words.add_argument('--picture', type=pathlib.Path, help='where to draw how time grows')
    words.add_argument('--page', type=pathlib.Path, help='a page whose figures are written anew')
    words.add_argument('--against', type=pathlib.Path, help='older results to print ratios with')
    asked = words.parse_args()
    with tempfile.TemporaryDirectory() as place:
        bench = Bench(asked.program, asked.examples, asked.runs or (3 if asked.quick else 5),
                      pathlib.Path(place))
        native(bench, asked.quick)
        if asked.web:
            web(bench, asked.web)
        else:
            print('WebAssembly: left out, build/web/artisketch.js is not there (./dev web)')
        peers.compare(bench)
    results = {'runs': bench.runs, 'rows': bench.rows}
    if asked.json:
        asked.json.write_text(json.dumps(results, indent=1))
    if asked.picture:
        asked.picture.write_text(growth.picture(bench.grown))
    if asked.page:
        figures = page.figures(bench.rows, bench.grown, bench.notes, GOALS)
        asked.page.write_text(page.renewed(asked.page.read_text(), figures))
    if asked.against:
        print(f'ratios to {asked.against}, and what the middle halves of the runs allow:')
        print('\n'.join(speed.compared(results, json.loads(asked.against.read_text()))))


if __name__ == '__main__':
    main()
