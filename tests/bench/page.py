"""The bench's figures as a page of Markdown keeps them."""
import speed

BEGIN, END = '<!-- figures -->', '<!-- end of figures -->'


def beside_goal(value, goal, form):
    if goal is None:
        return form(value)
    return f'{form(value)} (goal {goal:g}{"" if value <= goal else ": **missed**"})'


def figures(rows, grown, notes, goals):
    """Medians of each row, exponents, notes: lines of Markdown."""
    lines = ['| a whole run | CPU s | wall s | peak MB |', '| --- | --- | --- | --- |']
    for name, row in rows.items():
        cpu_goal, peak_goal = goals.get(name, (None, None))
        cpu, wall, peak = (speed.median(row[figure]) for figure in ('cpu', 'wall', 'peak'))
        lines.append(f'| {name} | {beside_goal(cpu, cpu_goal, "{:.2f}".format)} | {wall:.2f} | '
                     f'{beside_goal(peak, peak_goal, "{:.0f}".format)} |')
    lines += ['', '| CPU time grows with | sizes | as N to the power of |', '| --- | --- | --- |']
    lines += [f'| {one.what} | {", ".join(map(str, one.sizes))} | {one.exponent:.2f} |' for one in grown]
    return lines + [''] + [f'- {line}' for line in notes]


def renewed(page, lines):
    """The page with these lines between its marks."""
    before, rest = page.split(BEGIN)
    return '\n'.join([before + BEGIN, *lines, END]) + rest.split(END)[1]
