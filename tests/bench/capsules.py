"""Documents of as many parts and frames as a bench asks for: capsules on chains that leave a trunk,
turned a little further in each frame, outlined exactly, with poses a few degrees off."""
import math
import random

PIXELS_PER_UNIT = 220
SIZE = 800
LIMB = 4  # parts of a chain


def quaternion(axis, degrees):
    half = math.radians(degrees) / 2
    length = math.sqrt(sum(a * a for a in axis)) or 1.0
    return [math.sin(half) * a / length for a in axis] + [math.cos(half)]


def product(p, q):
    (a, b, c, d), (e, f, g, h) = p, q
    return [d * e + a * h + b * g - c * f, d * f - a * g + b * h + c * e,
            d * g + a * f - b * e + c * h, d * h - a * e - b * f - c * g]


def turned(q, v):
    x, y, z, w = product(product(q, [*v, 0.0]), [-q[0], -q[1], -q[2], q[3]])
    return [x, y, z]


def skeleton(parts):
    """Joints as the document has them, and per part the end of its bone."""
    joints = [{'name': 'trunk', 'parent': None, 'offset': [0, 0, 0]}]
    ends = [[0, 0.5, 0]]
    chains = math.ceil((parts - 1) / LIMB)
    for i in range(parts - 1):
        chain, link = divmod(i, LIMB)
        angle = 2 * math.pi * (chain + 0.5) / chains
        rise = 0.35 * math.sin(2.4 * chain)
        along = [math.cos(angle), rise, 0.6 * math.sin(3 * angle)]
        length = 0.9 / LIMB
        bone = [length * a for a in along]
        joints.append({
            'name': f'limb{chain}.{link}',
            'parent': joints[-1]['name'] if link else 'trunk',
            'offset': bone if link else [0.25 * along[0], 0.1 + 0.3 * rise, 0.25 * along[2]]})
        ends.append(bone)
    return joints, ends


def posed(joints, rotations):
    at, turn = [], []
    names = {joint['name']: i for i, joint in enumerate(joints)}
    for joint in joints:
        own = rotations.get(joint['name'], [0, 0, 0, 1])
        if joint['parent'] is None:
            at.append(list(joint['offset']))
            turn.append(own)
            continue
        parent = names[joint['parent']]
        step = turned(turn[parent], joint['offset'])
        at.append([a + b for a, b in zip(at[parent], step)])
        turn.append(product(turn[parent], own))
    return at, turn


def capsule(a, b, radius):
    """The outline of two discs and all between them."""
    along = math.atan2(b[1] - a[1], b[0] - a[0])
    points = []
    for centre, start in ((b, along - math.pi / 2), (a, along + math.pi / 2)):
        for i in range(13):
            angle = start + math.pi * i / 12
            points.append([round(centre[0] + radius * math.cos(angle), 2),
                           round(centre[1] + radius * math.sin(angle), 2)])
    return points


def document(parts, frames, seed=1):
    chance = random.Random(seed)
    joints, ends = skeleton(parts)
    drawn = []
    for f in range(frames):
        true = {'trunk': quaternion([0, 1, 0], 150 * f / max(frames, 2))}
        for joint in joints[1:]:
            axis = [chance.uniform(-1, 1) for _ in range(3)]
            true[joint['name']] = quaternion(axis, chance.uniform(-12, 12) if f else 0)
        at, turn = posed(joints, true)
        contours = []
        for j, joint in enumerate(joints):
            end = [p + d for p, d in zip(at[j], turned(turn[j], ends[j]))]
            to_pixel = lambda p: (SIZE / 2 + PIXELS_PER_UNIT * p[0], SIZE / 2 - PIXELS_PER_UNIT * p[1])
            slim = min(1, math.sqrt(16 / parts))  # so that many limbs have room
            radius = (0.28 if j == 0 else 0.09 * slim) * PIXELS_PER_UNIT
            contours.append({'joint': joint['name'],
                             'points': capsule(to_pixel(at[j]), to_pixel(end), radius)})
        given = dict(true)
        for joint in joints if f else []:
            axis = [chance.uniform(-1, 1) for _ in range(3)]
            off = quaternion(axis, 4)
            given[joint['name']] = product(true[joint['name']], off)
        drawn.append({'name': f'view {f + 1}', 'size': [SIZE, SIZE],
                      'pose': {'root_position': [0, 0, 0], 'rotations': given},
                      'contours': contours})
    return {'artisketch': 1, 'name': f'{parts} capsules', 'skeleton': {'joints': joints},
            'camera': {'type': 'orthographic', 'pixels_per_unit': PIXELS_PER_UNIT},
            'frames': drawn}
