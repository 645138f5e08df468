package org.u2sa.vision.picture;

import java.io.ByteArrayOutputStream;

/** Huffman-encodes blocks of coefficients (ITU-T T.81, annex F.1.2). */
final class EntropyWriter {
  private static final int END_OF_BLOCK = 0x00;
  private static final int SIXTEEN_ZEROS = 0xF0;
  private static final int LONGEST_RUN = 15;
  private static final int RUN_SHIFT = 4;
  private static final int MARKER = 0xFF; // in data, followed by a stuffed 0

  private final ByteArrayOutputStream out;
  private int pending; // lowest bits not yet written
  private int count; // number of pending bits: 0…7 between calls

  EntropyWriter(ByteArrayOutputStream out) {
    this.out = out;
  }

  /**
   * Writes a block.
   *
   * @param coefficients in zigzag order
   * @param previous DC coefficient of the component's previous block; 0 for the first
   */
  void block(int[] coefficients, int previous, HuffmanCode constant, HuffmanCode others) {
    number(constant, 0, coefficients[0] - previous);
    int zeros = 0;
    for (int i = 1; i < coefficients.length; i++) {
      if (coefficients[i] == 0) {
        zeros++;
      } else {
        for (; zeros > LONGEST_RUN; zeros -= LONGEST_RUN + 1) {
          symbol(others, SIXTEEN_ZEROS);
        }
        number(others, zeros, coefficients[i]);
        zeros = 0;
      }
    }
    if (zeros > 0) {
      symbol(others, END_OF_BLOCK);
    }
  }

  /** Writes zeros and size as a symbol, then the number's bits, minus one if negative. */
  private void number(HuffmanCode code, int zeros, int value) {
    int size = Integer.SIZE - Integer.numberOfLeadingZeros(Math.abs(value));
    symbol(code, zeros << RUN_SHIFT | size);
    int bits = value < 0 ? value - 1 : value;
    put(bits & (1 << size) - 1, size);
  }

  private void symbol(HuffmanCode code, int symbol) {
    put(code.word(symbol), code.length(symbol));
  }

  private void put(int bits, int length) {
    pending = pending << length | bits;
    count += length;
    while (count >= Byte.SIZE) {
      count -= Byte.SIZE;
      int whole = pending >>> count & 0xFF;
      out.write(whole);
      if (whole == MARKER) {
        out.write(0);
      }
    }
  }

  void end() {
    int missing = (Byte.SIZE - count) % Byte.SIZE;
    put((1 << missing) - 1, missing);
  }
}
