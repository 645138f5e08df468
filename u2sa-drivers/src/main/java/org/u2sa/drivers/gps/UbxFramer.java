package org.u2sa.drivers.gps;

/**
 * Extracts UBX messages from a byte stream with arbitrary boundaries and garbage: {@code B5 62
 * class id length payload checksum}, little-endian (u-blox 6 Receiver Description, GPS.G6-SW-10018,
 * section 24).
 *
 * <p>A false start is rejected and counted, and parsing resumes at its second byte. Bytes that do
 * not start a message (NMEA, for example) are skipped.
 */
final class UbxFramer {
  /** Length of header and checksum. */
  static final int OVERHEAD = 8;

  private static final int SYNC_1 = 0xB5;
  private static final int SYNC_2 = 0x62;
  private static final int HEADER = 6;
  private static final int LONGEST_PAYLOAD = 1_024; // longer than any requested message

  private final byte[] kept = new byte[LONGEST_PAYLOAD + OVERHEAD];
  private int count;
  private long refused;
  private String lastRefusal = "";

  /** Receives messages. */
  @FunctionalInterface
  interface Sink {
    /** Handles a message; its payload is valid only during this call. */
    void message(UbxPayload payload);
  }

  private final UbxPayload payload = new UbxPayload(kept);

  /** Encodes a message. */
  static byte[] frame(int messageClass, int id, byte... payload) {
    byte[] frame = new byte[payload.length + OVERHEAD];
    frame[0] = (byte) SYNC_1;
    frame[1] = SYNC_2;
    frame[2] = (byte) messageClass;
    frame[3] = (byte) id;
    frame[4] = (byte) payload.length;
    frame[5] = (byte) (payload.length >> 8);
    System.arraycopy(payload, 0, frame, HEADER, payload.length);
    int sum = checksum(frame, 0, payload.length);
    frame[HEADER + payload.length] = (byte) sum;
    frame[HEADER + payload.length + 1] = (byte) (sum >> 8);
    return frame;
  }

  /** Fletcher checksum over class, id, length and payload; the second sum is in the high byte. */
  private static int checksum(byte[] bytes, int frameAt, int payloadLength) {
    int first = 0;
    int second = 0;
    for (int i = frameAt + 2; i < frameAt + HEADER + payloadLength; i++) {
      first = first + bytes[i] & 0xFF;
      second = second + first & 0xFF;
    }
    return second << 8 | first;
  }

  /** Consumes bytes and delivers completed messages. */
  void accept(byte[] from, int length, Sink sink) {
    int taken = 0;
    while (taken < length) {
      int part = Math.min(length - taken, kept.length - count);
      System.arraycopy(from, taken, kept, count, part);
      count += part;
      taken += part;
      search(sink);
    }
  }

  private void search(Sink sink) {
    int at = 0;
    int used = 1;
    while (used > 0 && at < count) {
      used = messageAt(at, sink);
      at += used;
    }
    System.arraycopy(kept, at, kept, 0, count - at);
    count -= at;
  }

  /** Number of bytes consumed; 0 if more are needed. */
  private int messageAt(int at, Sink sink) {
    int there = count - at;
    if (byteAt(at) != SYNC_1 || there > 1 && byteAt(at + 1) != SYNC_2) {
      return 1;
    }
    if (there < HEADER) {
      return 0;
    }
    int length = byteAt(at + 4) | byteAt(at + 5) << 8;
    if (length > LONGEST_PAYLOAD) {
      refuse(at, length + " bytes long");
      return 1;
    }
    if (there < length + OVERHEAD) {
      return 0;
    }
    int end = at + HEADER + length;
    if (checksum(kept, at, length) != (byteAt(end) | byteAt(end + 1) << 8)) {
      refuse(at, "wrong checksum");
      return 1;
    }
    payload.set(byteAt(at + 2), byteAt(at + 3), at + HEADER, length);
    sink.message(payload);
    return length + OVERHEAD;
  }

  private int byteAt(int index) {
    return kept[index] & 0xFF;
  }

  private void refuse(int at, String why) {
    refused++;
    lastRefusal = String.format("UBX message %02X-%02X: %s", byteAt(at + 2), byteAt(at + 3), why);
  }

  /** Discards a partial message. */
  void reset() {
    count = 0;
  }

  long refused() {
    return refused;
  }

  String lastRefusal() {
    return lastRefusal;
  }
}
