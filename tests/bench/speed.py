"""The arithmetic of the bench's tables: medians, ratios and what cost grows with."""
import math
import statistics

FEWEST_RUNS = 5  # that a spread is told of


def median(runs):
    return statistics.median(runs)


def ratio(new, old):
    """Of medians, and between what the middle halves of the runs allow: (ratio, least, most). The
    spread is None where either has too few runs to tell."""
    middle = median(new) / median(old)
    if min(len(new), len(old)) < FEWEST_RUNS:
        return middle, None, None
    (n1, _, n3), (o1, _, o3) = (statistics.quantiles(runs, n=4, method='inclusive')
                                for runs in (new, old))
    return middle, n1 / o3, n3 / o1


def exponent(sizes, costs):
    """p of cost ~ size^p, by least squares of the logarithms."""
    xs, ys = [math.log(s) for s in sizes], [math.log(c) for c in costs]
    x, y = statistics.fmean(xs), statistics.fmean(ys)
    return (sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs))


def compared(new, old):
    """Lines of ratios, new to old, of every figure that both results have."""
    lines = []
    for name, row in new['rows'].items():
        before = old['rows'].get(name)
        if not before:
            lines.append(f'{name:44s} not in the older results')
            continue
        words = []
        for figure in ('cpu', 'wall', 'peak'):
            middle, least, most = ratio(row[figure], before[figure])
            spread = f' ({least:.2f} to {most:.2f})' if least is not None else ' (too few runs)'
            words.append(f'{figure} {middle:.2f}{spread}')
        lines.append(f'{name:44s} ' + '  '.join(words))
    return lines


def judged(value, goal):
    """A figure beside its goal; what is missed says so."""
    if goal is None:
        return ''
    return f'goal {goal:g}' + ('' if value <= goal else f': MISSED by {value / goal:.2f} times')
