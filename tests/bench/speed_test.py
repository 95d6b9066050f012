#!/usr/bin/env python3
import unittest

import capsules
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


if __name__ == '__main__':
    unittest.main()
