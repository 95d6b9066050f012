"""How CPU time grows with the grid, parts and frames, as a picture."""
import dataclasses
import math

import speed

PANEL, HEIGHT, GAP = 300, 240, 60  # pixels: a plot's sides, and what lies between two for its numbers
LEFT, TOP, BOTTOM = 56, 84, 52
INK, SOFT, LINE, DOT, PAPER = '#1f2937', '#6b7280', '#d1d5db', '#0f766e', '#f6f7f9'


@dataclasses.dataclass
class Growth:
    what: str
    sizes: list
    costs: list  # CPU seconds

    @property
    def exponent(self):
        return speed.exponent(self.sizes, self.costs)


def text(x, y, words, size=12, colour=SOFT, anchor='middle'):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{colour}" '
            f'text-anchor="{anchor}">{words}</text>')


def ticks(low, high):
    """1, 2 and 5 times powers of ten within the range."""
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    return [m * 10 ** p for p in powers for m in (1, 2, 5) if low <= m * 10 ** p * 1.001 <= high * 1.002]


class Axis:
    """Logarithms of low … high on begin … end."""
    def __init__(self, values, begin, end):
        self.low, self.high = min(values) / 1.25, max(values) * 1.25
        self.begin, self.end = begin, end

    def __call__(self, value):
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.begin + share * (self.end - self.begin)


def panel(grown, left, y):
    x = Axis(grown.sizes, left, left + PANEL)
    bottom = TOP + HEIGHT
    out = [f'<rect x="{left}" y="{TOP}" width="{PANEL}" height="{HEIGHT}" rx="6" fill="#fff" stroke="{LINE}"/>',
           text(left, TOP - 14, f'{grown.what}: N<tspan dy="-5" font-size="10">{grown.exponent:.2f}</tspan>', 14, INK,
                'start')]
    for cost in ticks(y.low, y.high):
        out.append(f'<path d="M{left} {y(cost):.1f}h{PANEL}" stroke="{LINE}" stroke-dasharray="2 4"/>')
        out.append(text(left - 8, y(cost) + 4, f'{cost:g}', anchor='end'))
    room = -math.inf  # numbers stand below their dots where they don't touch
    for size in grown.sizes:
        if x(size) - room >= 24:
            out.append(text(x(size), bottom + 18, f'{size:g}'))
            room = x(size)
    # The fitted line passes the middle of the logarithms.
    middle = math.exp(sum(map(math.log, grown.sizes)) / len(grown.sizes))
    cost = math.exp(sum(map(math.log, grown.costs)) / len(grown.costs))
    ends = [(s, cost * (s / middle) ** grown.exponent) for s in (grown.sizes[0], grown.sizes[-1])]
    clamp = lambda c: y(min(max(c, y.low), y.high))
    out.append('<path d="M' + 'L'.join(f'{x(s):.1f} {clamp(c):.1f}' for s, c in ends)
               + f'" stroke="{SOFT}" stroke-width="1.5" fill="none"/>')
    out += [f'<circle cx="{x(s):.1f}" cy="{y(c):.1f}" r="4" fill="{DOT}"/>'
            for s, c in zip(grown.sizes, grown.costs)]
    return out


def picture(all_grown):
    """An SVG with a plot of each, all with one scale of time; both axes are logarithmic."""
    width = LEFT + len(all_grown) * (PANEL + GAP)
    height = TOP + HEIGHT + BOTTOM
    y = Axis([c for grown in all_grown for c in grown.costs], TOP + HEIGHT, TOP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
           'font-family="Inter, system-ui, sans-serif">',
           f'<rect width="{width}" height="{height}" fill="{PAPER}"/>',
           text(LEFT, 30, 'CPU seconds of a whole run, on one core', 15, INK, 'start')]
    for i, grown in enumerate(all_grown):
        out += panel(grown, LEFT + i * (PANEL + GAP), y)
    return '\n'.join(out + ['</svg>', ''])
