package org.u2sa.gcs.mavlink;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Finds packets that look like an order to stop or disarm, without the cost of a checksum for every
 * other packet (mavlink.io/en/guide/serialization; COMMAND_LONG and COMMAND_INT have their first
 * parameter and the command's number at the same offsets).
 */
final class StopSearch {
  private static final int COMMAND_INT = 75;
  private static final int COMMAND_LONG = 76;
  private static final int TERMINATE = 185;
  private static final int ARM = 400;
  private static final int COMMAND = 28; // offset in the payload
  private static final int LARGEST_PAYLOAD = 35;
  private static final int HEADER_1 = 6;
  private static final int HEADER_2 = 10;
  private static final int CHECKSUM = 2;
  private static final int SIGNATURE = 13;
  private static final int BYTE = 8;

  private byte[] kept = new byte[0]; // beginning of what may be one

  /** Discards what has been kept of a packet whose rest has not arrived; returns its bytes. */
  byte[] reset() {
    byte[] partial = kept;
    kept = new byte[0];
    return partial;
  }

  /** Searches bytes that continue those of the last call. */
  void search(byte[] bytes, int length, Consumer<byte[]> found) {
    byte[] all = Arrays.copyOf(kept, kept.length + length);
    System.arraycopy(bytes, 0, all, kept.length, length);
    int at = 0;
    int size = 0;
    while (at < all.length && (size = size(all, at)) <= all.length - at) {
      if (size > 0 && isStop(all, at)) {
        found.accept(Arrays.copyOfRange(all, at, at + size));
      }
      at++;
    }
    kept = Arrays.copyOfRange(all, at, all.length);
  }

  /** Bytes of the command that begins there, as far as known; 0 if none begins. */
  private static int size(byte[] all, int at) {
    int header = header(all, at);
    if (header == 0 || all.length - at < header) {
      return header;
    }
    boolean isSecond = header == HEADER_2;
    int flags = isSecond ? all[at + 2] : 0;
    int message = all[at + header - 1] & 0xFF;
    if (isSecond) {
      message =
          all[at + 7] & 0xFF | (all[at + 8] & 0xFF) << BYTE | (all[at + 9] & 0xFF) << 2 * BYTE;
    }
    int payload = all[at + 1] & 0xFF;
    boolean isCommand = message == COMMAND_INT || message == COMMAND_LONG;
    boolean isLong = payload > COMMAND && payload <= LARGEST_PAYLOAD;
    if (!isCommand || !isLong || flags < 0 || flags > 1) {
      return 0;
    }
    return header + payload + CHECKSUM + flags * SIGNATURE;
  }

  private static int header(byte[] all, int at) {
    return switch (all[at] & 0xFF) {
      case 0xFE -> HEADER_1;
      case 0xFD -> HEADER_2;
      default -> 0;
    };
  }

  private static boolean isStop(byte[] all, int at) {
    int payload = at + header(all, at);
    int high = (all[at + 1] & 0xFF) > COMMAND + 1 ? all[payload + COMMAND + 1] & 0xFF : 0;
    int command = all[payload + COMMAND] & 0xFF | high << BYTE;
    int bits = 0;
    for (int i = 3; i >= 0; i--) {
      bits = bits << BYTE | all[payload + i] & 0xFF; // the least significant byte comes first
    }
    return command == TERMINATE || command == ARM && Float.intBitsToFloat(bits) == 0.0f;
  }
}
