#!/usr/bin/env python3
"""Draws what `perf script -F comm,ip,sym` tells as a flame graph (Gregg 2016): SVG on standard output.

Each box is a function, as wide as the share of samples in which it ran, above whoever called it; where
the pointer rests the whole name and the share are shown."""
import html
import re
import sys

WIDTH, ROW, LEAST = 1400, 17, 0.4  # pixels; narrower boxes are left out


def short(symbol):
    """A C++ name without what its arguments and its templates are."""
    symbol = symbol.replace('(anonymous namespace)::', '').replace('artisketch::', '')
    symbol = re.sub(r'\[clone[^]]*\]', '', symbol).replace('operator()', 'operator call')
    depth, kept = 0, []
    for c in symbol:
        depth += c in '<('
        if depth == 0:
            kept.append(c)
        depth -= c in '>)' and depth > 0
    name = ''.join(kept).strip()
    return name.split(' ')[-1] if not name.startswith('operator') else name


def stacks(lines):
    """Of each sample the functions that ran, the outermost first."""
    stack = []
    for line in lines:
        if not line.strip():
            if stack:
                yield stack[::-1]
            stack = []
        elif line[0] in ' \t':
            words = line.split(None, 1)
            stack.append(words[1].strip() if len(words) > 1 else '?')
    if stack:
        yield stack[::-1]


def tree_of(all_stacks):
    """Nested {name: [samples, {...}]}. What nobody names counts for its caller."""
    root = [0, {}]
    for stack in all_stacks:
        root[0] += 1
        node = root
        for symbol in stack:
            name = short(symbol)
            if name in ('', '?', '[unknown]', '_start', '__libc_start_main_impl', '__libc_start_call_main'):
                continue
            node = node[1].setdefault(name, [0, {}])
            node[0] += 1
    return root


def depth_of(node):
    return 1 + max((depth_of(child) for child in node[1].values()), default=0)


def boxes(name, node, x, level, per_sample, whole):
    width = node[0] * per_sample
    if width < LEAST:
        return
    share = 100 * node[0] / whole
    yield x, level, width, name, share
    for child_name, child in sorted(node[1].items(), key=lambda item: -item[1][0]):
        yield from boxes(child_name, child, x, level + 1, per_sample, whole)
        x += child[0] * per_sample


def svg(root):
    height = ROW * (depth_of(root) + 1)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" '
           'font-family="sans-serif" font-size="11">',
           f'<rect width="{WIDTH}" height="{height}" fill="#fff"/>']
    for x, level, width, name, share in boxes('all', root, 0, 0, WIDTH / max(root[0], 1), max(root[0], 1)):
        y = height - ROW * (level + 1)
        hue = sum(map(ord, name)) % 50
        fits = int(width / 6.2)
        text = name if len(name) <= fits else name[:max(fits - 1, 0)] + '…' if fits > 3 else ''
        out.append(f'<g><title>{html.escape(name)}: {share:.1f} %</title>'
                   f'<rect x="{x:.1f}" y="{y}" width="{max(width - 0.5, 0.3):.1f}" height="{ROW - 1}" '
                   f'fill="hsl({hue},75%,68%)"/>'
                   f'<text x="{x + 3:.1f}" y="{y + 12}">{html.escape(text)}</text></g>')
    out.append('</svg>')
    return '\n'.join(out)


if __name__ == '__main__':
    print(svg(tree_of(stacks(sys.stdin))))
