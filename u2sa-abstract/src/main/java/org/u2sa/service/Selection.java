package org.u2sa.service;

/** Finds the nth of numbers by size without sorting them all (Hoare 1961, algorithm 65). */
final class Selection {
  private Selection() {}

  /**
   * The number that would stand at an index if they were sorted, smallest first.
   *
   * @param numbers the first of them are reordered by this
   * @param count how many of them count
   * @param index 0 or more, less than their count
   */
  static long nth(long[] numbers, int count, int index) {
    int low = 0;
    int high = count - 1;
    while (low < high) {
      long pivot = numbers[index];
      int up = low;
      int down = high;
      while (up <= down) {
        while (numbers[up] < pivot) {
          up++;
        }
        while (numbers[down] > pivot) {
          down--;
        }
        if (up <= down) {
          long swapped = numbers[up];
          numbers[up++] = numbers[down];
          numbers[down--] = swapped;
        }
      }
      low = down < index ? up : low;
      high = index < up ? down : high;
    }
    return numbers[index];
  }
}
