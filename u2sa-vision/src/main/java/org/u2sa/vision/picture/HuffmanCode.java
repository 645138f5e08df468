package org.u2sa.vision.picture;

/** A Huffman code as in ITU-T T.81, annex C: number of codes of each length, and their symbols. */
final class HuffmanCode {
  /** Luminance DC (table K.3). */
  static final HuffmanCode LUMINANCE_DC =
      new HuffmanCode("00010501010101010100000000000000", "000102030405060708090a0b");

  /** Chrominance DC (table K.4). */
  static final HuffmanCode CHROMINANCE_DC =
      new HuffmanCode("00030101010101010101010000000000", "000102030405060708090a0b");

  /** Luminance AC (table K.5). */
  static final HuffmanCode LUMINANCE_AC =
      new HuffmanCode(
          "0002010303020403050504040000017d",
          "01020300041105122131410613516107227114328191a1082342b1c11552d1f0"
              + "2433627282090a161718191a25262728292a3435363738393a43444546474849"
              + "4a535455565758595a636465666768696a737475767778797a83848586878889"
              + "8a92939495969798999aa2a3a4a5a6a7a8a9aab2b3b4b5b6b7b8b9bac2c3c4c5"
              + "c6c7c8c9cad2d3d4d5d6d7d8d9dae1e2e3e4e5e6e7e8e9eaf1f2f3f4f5f6f7f8"
              + "f9fa");

  /** Chrominance AC (table K.6). */
  static final HuffmanCode CHROMINANCE_AC =
      new HuffmanCode(
          "00020102040403040705040400010277",
          "000102031104052131061241510761711322328108144291a1b1c109233352f0"
              + "156272d10a162434e125f11718191a262728292a35363738393a434445464748"
              + "494a535455565758595a636465666768696a737475767778797a828384858687"
              + "88898a92939495969798999aa2a3a4a5a6a7a8a9aab2b3b4b5b6b7b8b9bac2c3"
              + "c4c5c6c7c8c9cad2d3d4d5d6d7d8d9dae2e3e4e5e6e7e8e9eaf2f3f4f5f6f7f8"
              + "f9fa");

  private static final int SYMBOLS = 256;
  private static final int HEX = 16;

  private final byte[] counts; // number of codes with 1, 2, … 16 bits
  private final byte[] symbols; // in code order
  private final int[] words = new int[SYMBOLS];
  private final int[] lengths = new int[SYMBOLS]; // 0 if not in the code

  private HuffmanCode(String countsHex, String symbolsHex) {
    counts = bytes(countsHex);
    symbols = bytes(symbolsHex);
    int word = 0;
    int next = 0;
    for (int length = 1; length <= counts.length; length++) {
      for (int i = 0; i < counts[length - 1]; i++) {
        int symbol = symbols[next++] & 0xFF;
        words[symbol] = word++;
        lengths[symbol] = length;
      }
      word <<= 1;
    }
  }

  private static byte[] bytes(String hex) {
    byte[] bytes = new byte[hex.length() / 2];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) Integer.parseInt(hex.substring(2 * i, 2 * i + 2), HEX);
    }
    return bytes;
  }

  byte[] counts() {
    return counts;
  }

  byte[] symbols() {
    return symbols;
  }

  int word(int symbol) {
    return words[symbol];
  }

  /** Code of a symbol. */
  int length(int symbol) {
    return lengths[symbol];
  }
}
