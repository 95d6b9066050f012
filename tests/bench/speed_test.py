#!/usr/bin/env python3
import re
import unittest
import xml.dom.minidom

import capsules
import growth
import page
import speed


class Ratio(unittest.TestCase):
    def test_of_medians_and_not_of_outliers(self):
        self.assertEqual(speed.ratio([2, 2, 2, 2, 50], [1, 1, 1, 1, 1])[0], 2)

    def test_spread_holds_the_ratio_and_shrinks_with_quieter_runs(self):
        loud = speed.ratio([1, 2, 3, 4, 5], [1, 2, 3, 4, 5])
        quiet = speed.ratio([2.9, 3, 3, 3, 3.1], [2.9, 3, 3, 3, 3.1])
        for middle, least, most in (loud, quiet):
            self.assertEqual(middle, 1)
            self.assertTrue(least <= 1 <= most)
        self.assertEqual(loud[1:], (0.5, 2))
        self.assertEqual(quiet[1:], (1, 1))

    def test_too_few_runs_tell_no_spread(self):
        self.assertEqual(speed.ratio([4] * 4, [2] * 5), (2, None, None))


class Exponent(unittest.TestCase):
    def test_of_a_power_is_that_power(self):
        sizes = [48, 100, 200, 512]
        for power in (0, 1, 2.3):
            self.assertAlmostEqual(speed.exponent(sizes, [7 * n ** power for n in sizes]), power)


class Compared(unittest.TestCase):
    def test_every_row_has_its_line(self):
        row = {'cpu': [1] * 5, 'wall': [2] * 5, 'peak': [3] * 5}
        half = {'cpu': [2] * 5, 'wall': [2] * 5, 'peak': [6] * 5}
        lines = speed.compared({'rows': {'hero': row, 'fox': row}}, {'rows': {'hero': half}})
        self.assertIn('cpu 0.50 (0.50 to 0.50)', lines[0])
        self.assertIn('wall 1.00', lines[0])
        self.assertIn('not in the older', lines[1])

    def test_a_missed_goal_says_so(self):
        self.assertIn('MISSED by 2.00', speed.judged(1, 0.5))
        self.assertNotIn('MISSED', speed.judged(0.5, 0.5))
        self.assertEqual(speed.judged(1, None), '')


class Capsules(unittest.TestCase):
    def test_have_the_parts_and_frames_asked_for(self):
        for parts, frames in ((1, 1), (5, 2), (60, 12)):
            made = capsules.document(parts, frames)
            self.assertEqual(len(made['skeleton']['joints']), parts)
            self.assertEqual([len(f['contours']) for f in made['frames']], [parts] * frames)

    def test_are_the_same_every_time_and_within_the_drawing(self):
        self.assertEqual(capsules.document(15, 3), capsules.document(15, 3))
        for frame in capsules.document(60, 3)['frames']:
            for contour in frame['contours']:
                for point in contour['points']:
                    self.assertTrue(all(0 < c < capsules.SIZE for c in point), contour['joint'])


class Page(unittest.TestCase):
    def test_is_written_anew_between_its_marks_alone(self):
        rows = {'hero': {'cpu': [1, 3, 2], 'wall': [4] * 3, 'peak': [100] * 3}}
        lines = page.figures(rows, [growth.Growth('parts', [1, 2], [3, 6])], ['nobody else'],
                             {'hero': (1.5, 200)})
        old = f'above\n{page.BEGIN}\nold\n{page.END}\nbelow\n'
        new = page.renewed(old, lines)
        self.assertTrue(new.startswith('above\n') and new.endswith('\nbelow\n'))
        self.assertNotIn('old', new)
        self.assertIn('| hero | 2.00 (goal 1.5: **missed**) | 4.00 | 100 (goal 200) |', new)
        self.assertIn('| parts | 1, 2 | 1.00 |', new)
        self.assertEqual(page.renewed(new, lines), new)


class Picture(unittest.TestCase):
    def test_has_each_figure_where_its_line_is(self):
        squares = growth.Growth('cells', [50, 100, 400], [0.5, 2, 32])
        few = growth.Growth('parts', [5, 60], [1, 1.5])
        drawn = growth.picture([squares, few])
        xml.dom.minidom.parseString(drawn)
        dots = [(float(x), float(y)) for x, y in re.findall(r'cx="([\d.]+)" cy="([\d.]+)"', drawn)]
        self.assertEqual(len(dots), 5)
        (ax, ay), (bx, by), (cx, cy) = dots[:3]
        self.assertAlmostEqual((by - ay) / (bx - ax), (cy - by) / (cx - bx), places=2)
        self.assertLess(cy, ay)
        self.assertIn('>2.00<', drawn)


if __name__ == '__main__':
    unittest.main()
