package org.u2sa.drivers.range;

/**
 * Numbers and checksums of SCIP 2 (Hokuyo C-42-03320B, "Communication Protocol Specification for
 * SCIP2.0 Standard", chapters 6 and 7).
 */
final class Scip {
  private static final int SIX_BITS = 0x3F;
  private static final int OFFSET = 0x30;

  private Scip() {}

  /** The check character of a text: the low six bits of the sum, as a printable character. */
  static char sum(CharSequence text) {
    int sum = 0;
    for (int i = 0; i < text.length(); i++) {
      sum += text.charAt(i);
    }
    return (char) ((sum & SIX_BITS) + OFFSET);
  }

  /** Whether a line ends with the check character of what is before it. */
  static boolean isChecked(CharSequence line) {
    int end = line.length() - 1;
    return end >= 0 && line.charAt(end) == sum(line.subSequence(0, end));
  }

  /** The number that some characters stand for, six bits each; −1 if one cannot be. */
  static int decode(CharSequence text, int from, int characters) {
    int value = 0;
    for (int i = from; i < from + characters; i++) {
      int six = text.charAt(i) - OFFSET;
      if (six < 0 || six > SIX_BITS) {
        return -1;
      }
      value = value << 6 | six;
    }
    return value;
  }
}
