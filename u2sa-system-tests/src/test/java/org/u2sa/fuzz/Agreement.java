package org.u2sa.fuzz;

/** What must hold of an input that was taken. */
final class Agreement {
  private Agreement() {}

  /**
   * @throws AssertionError naming the property and both values if it does not hold
   */
  static void require(boolean holds, String what, Object actual, Object expected) {
    if (!holds) {
      throw new AssertionError(what + ": " + actual + ", expected " + expected);
    }
  }
}
