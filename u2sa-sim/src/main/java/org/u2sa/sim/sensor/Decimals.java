package org.u2sa.sim.sensor;

/** Writes numbers as instruments do: fixed digits, a point, nothing of the machine's language. */
final class Decimals {
  private Decimals() {}

  /**
   * Appends a number, rounded.
   *
   * @param digits before the point at least, filled with zeros
   * @param decimals after it, 0…9
   */
  static StringBuilder append(StringBuilder text, double value, int digits, int decimals) {
    long scale = 1;
    for (int i = 0; i < decimals; i++) {
      scale *= 10;
    }
    long scaled = Math.round(Math.abs(value) * scale);
    if (value < 0.0 && scaled > 0) {
      text.append('-');
    }
    pad(text, scaled / scale, digits);
    if (decimals > 0) {
      text.append('.');
      pad(text, scaled % scale, decimals);
    }
    return text;
  }

  private static void pad(StringBuilder text, long number, int digits) {
    String plain = Long.toString(number);
    for (int i = plain.length(); i < digits; i++) {
      text.append('0');
    }
    text.append(plain);
  }
}
