package org.u2sa.service.inbox;

/** Quickselect: finds the nth smallest number without sorting (Hoare 1961, algorithm 65). */
final class Selection {
  private Selection() {}

  /**
   * The number at an index of the ascending order.
   *
   * @param numbers input, whose first {@code count} numbers are reordered
   * @param count how many of the numbers to use
   * @param index 0 to count − 1
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
