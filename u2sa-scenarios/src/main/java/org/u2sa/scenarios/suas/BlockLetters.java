package org.u2sa.scenarios.suas;

import java.util.Map;

/** Letters of the targets, in blocks of 5 × 7. No letter is a rotated copy of another. */
final class BlockLetters {
  /** All of them. */
  static final String ALL = "ABEFHJKLPRTUXY2348";

  private static final double WIDTH = 0.34; // fraction of the target's side
  private static final double HEIGHT = 0.46;

  private static final Map<Character, String> ROWS =
      Map.ofEntries(
          Map.entry('A', ".###.#...##...#######...##...##...#"),
          Map.entry('B', "####.#...##...#####.#...##...#####."),
          Map.entry('E', "######....#....####.#....#....#####"),
          Map.entry('F', "######....#....####.#....#....#...."),
          Map.entry('H', "#...##...##...#######...##...##...#"),
          Map.entry('J', "....#....#....#....##...##...#.###."),
          Map.entry('K', "#...##..#.#.#..##...#.#..#..#.#...#"),
          Map.entry('L', "#....#....#....#....#....#....#####"),
          Map.entry('P', "####.#...##...#####.#....#....#...."),
          Map.entry('R', "####.#...##...#####.#.#..#..#.#...#"),
          Map.entry('T', "#####..#....#....#....#....#....#.."),
          Map.entry('U', "#...##...##...##...##...##...#.###."),
          Map.entry('X', "#...##...#.#.#...#...#.#.#...##...#"),
          Map.entry('Y', "#...##...#.#.#...#....#....#....#.."),
          Map.entry('2', ".###.#...#....#..##..#...#....#####"),
          Map.entry('3', "####.....#....#.###.....#....#####."),
          Map.entry('4', "...#...##..#.#.#..#.#####...#....#."),
          Map.entry('8', ".###.#...##...#.###.#...##...#.###."));

  private BlockLetters() {}

  /**
   * Whether a point on a target belongs to its letter.
   *
   * @param right distance right of the middle, in sides of the target
   * @param up distance towards the letter's top, likewise
   */
  static boolean isInk(String letter, double right, double up) {
    int column = (int) Math.floor((right / WIDTH + 0.5) * 5.0);
    int row = (int) Math.floor((0.5 - up / HEIGHT) * 7.0);
    return column >= 0
        && column < 5
        && row >= 0
        && row < 7
        && ROWS.get(letter.charAt(0)).charAt(5 * row + column) == '#';
  }
}
