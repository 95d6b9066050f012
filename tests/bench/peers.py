"""The same work by others, in the same run, where they are installed; who isn't is named."""
import importlib.util
import json
import pathlib
import shutil
import subprocess
import time

import speed

BLENDER = '''
import numpy; numpy.bool = bool
import bpy, time
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath={model!r})
rig = next(o for o in bpy.data.objects if o.type == 'ARMATURE')
skins = [o for o in bpy.data.objects if o.type == 'MESH' and o.parent == rig]
best = 1e9
for _ in range(3):
    bpy.ops.object.select_all(action='DESELECT')
    for skin in skins:
        skin.vertex_groups.clear(); skin.select_set(True)
    rig.select_set(True); bpy.context.view_layer.objects.active = rig
    began = time.time(); bpy.ops.object.parent_set(type='ARMATURE_AUTO'); best = min(best, time.time() - began)
print('SECONDS', best)
'''


def report(bench, *flags):
    path = bench.place / 'peer.json'
    subprocess.run([bench.program, 'reconstruct', bench.example('hero'), '-o', bench.place / 'peer.glb',
                    '--quiet', '--report', path, '--threads', '1', *flags], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return {stage['stage']: stage for stage in json.loads(path.read_text())['stages']}


def told(bench, words):
    bench.notes.append(' '.join(words.split()))
    print(words, flush=True)


def line(bench, work, ours, name, theirs, wanted):
    times = theirs / max(ours, 1e-9)
    missed = '' if times >= wanted else ': MISSED'
    told(bench, f'{work + ":":40s} {ours:7.3f} s, {name} {theirs:.3f} s: {times:.1f} times ours '
                f'(goal {wanted:g}{missed})')


def blender(bench):
    ours = report(bench, '--no-texture')['weights']['cpu_seconds']
    done = subprocess.run(['blender', '-b', '--python-exit-code', '1', '--python-expr',
                           BLENDER.format(model=str(bench.place / 'peer.glb'))],
                          capture_output=True, text=True)
    seconds = [float(l.split()[1]) for l in done.stdout.splitlines() if l.startswith('SECONDS')]
    if not seconds:
        return told(bench, 'weights: Blender could not: ' + ' '.join((done.stderr or done.stdout).split())[-200:])
    line(bench, "weights of hero's 15,000 triangles", ours, 'Blender', seconds[0], 10)


def visual_hull(bench):
    """The hulls of hero's parts by voxels in numpy, as a first try would have them: every voxel asked
    in every view, then skimage's marching cubes. Ours: carving and surface, --visual-hull."""
    import numpy
    from skimage import draw, measure
    document = json.loads(bench.example('hero').read_text())
    stages = report(bench, '--no-texture', '--visual-hull', '--no-calibrate')
    n = 100
    began = time.process_time()
    joints = {c['joint'] for f in document['frames'] for c in f['contours']}
    axis = numpy.arange(n)
    grid = numpy.stack(numpy.meshgrid(axis, axis, axis, indexing='ij'), -1).reshape(-1, 3)
    for joint in joints:
        inside = numpy.ones(len(grid), bool)
        for number, frame in enumerate(document['frames']):
            for contour in frame['contours']:
                if contour['joint'] != joint or not contour.get('closed', True):
                    continue
                points = numpy.array(contour['points'])
                low, size = points.min(0), numpy.ptp(points, axis=0).max()
                mask = draw.polygon2mask((n, n), (points - low) / size * (n - 1))
                # Which axes a view sees costs the same whatever its pose.
                inside &= mask[grid[:, number % 3], grid[:, (number + 1) % 3]]
        volume = numpy.pad(inside.reshape(n, n, n).astype(numpy.float32), 1)
        if volume.any():
            measure.marching_cubes(volume, 0.5)
    line(bench, "visual hulls of hero's parts", stages['surfaces']['cpu_seconds'], 'scikit-image',
         time.process_time() - began, 1)


def union(bench):
    """Hero's part surfaces united. Ours is one skin: it keeps parts that touch apart, closes gaps, fairs and
    simplifies besides."""
    source = pathlib.Path(__file__).with_name('union_by_cgal.cpp')
    program = bench.place / 'union_by_cgal'
    built = subprocess.run(['c++', '-std=c++17', '-O2', '-DNDEBUG', source, '-o', program, '-lgmp', '-lmpfr'],
                           capture_output=True, text=True)
    if built.returncode:
        return told(bench, 'union: CGAL could not be built with: ' + built.stderr[-200:])
    trace = bench.place / 'trace'
    ours = report(bench, '--no-texture', '--trace', trace)['one skin']['cpu_seconds']
    done = subprocess.run([program, *sorted(trace.glob('* surface.ply'))], capture_output=True, text=True)
    if done.returncode:
        return told(bench, 'union: CGAL could not: ' + done.stderr.strip())
    line(bench, "union of hero's 15 parts", ours, 'CGAL', float(done.stdout.split()[1]), 2)


# How many times ours others should take, at least.
WANTED = {'isosurface of a ball': 1, "40 steps of the hero's chest": 10}
LIBRARIES = {'OpenVDB': 'libopenvdb-dev', 'ITK': 'libinsighttoolkit5-dev', 'CHOLMOD': 'libsuitesparse-dev'}


def libraries(bench):
    """What peer_bench.cpp and solver_bench.cpp were built with."""
    program = pathlib.Path(bench.program).parent / 'tests' / 'bench' / 'artisketch_bench'
    if not program.exists():
        return told(bench, f'{", ".join(LIBRARIES)}: left out, there is no {program.name} (./dev bench stages)')
    done = subprocess.run([program, '--benchmark_filter=^peers/', '--benchmark_format=json'],
                          capture_output=True, text=True, check=True)
    missing = dict(LIBRARIES)
    for one in json.loads(done.stdout)['benchmarks']:
        if 'theirs' not in one:
            continue
        _, work, name, *size = one['name'].split('/')
        missing.pop(name, None)
        line(bench, work + ''.join(f', {n}³' for n in size), one['ours'] / 1000, name,
             one['theirs'] / 1000, WANTED.get(work, 1))
    for name, package in missing.items():
        told(bench, f'{name}: left out, it is not installed ({package})')


def compare(bench):
    if shutil.which('blender'):
        blender(bench)
    else:
        told(bench, 'weights: left out, there is no Blender (blender)')
    if importlib.util.find_spec('skimage'):
        visual_hull(bench)
    else:
        told(bench, 'visual hulls: left out, there is no scikit-image (python3-skimage)')
    if shutil.which('c++') and pathlib.Path('/usr/include/CGAL').is_dir():
        union(bench)
    else:
        told(bench, 'union: left out, there is no CGAL (libcgal-dev)')
    libraries(bench)
