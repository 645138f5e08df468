package org.u2sa.gcs.mavlink.file;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Payload of FILE_TRANSFER_PROTOCOL (mavlink.io/en/services/ftp), little-endian.
 *
 * @param sequence number of the packet, 0…65535
 * @param size stated number of bytes; a malformed request may state more than fit
 * @param requestOpcode in an answer, opcode of the request
 * @param data 239 bytes, or fewer in an answer
 */
record FilePacket(
    int sequence,
    int session,
    int opcode,
    int size,
    int requestOpcode,
    boolean burstComplete,
    long offset,
    byte[] data) {
  static final int TERMINATE_SESSION = 1;
  static final int RESET_SESSIONS = 2;
  static final int LIST_DIRECTORY = 3;
  static final int OPEN_FILE = 4;
  static final int READ_FILE = 5;
  static final int CREATE_FILE = 6;
  static final int RENAME = 13; // CREATE_FILE…RENAME write
  static final int CHECKSUM = 14;
  static final int BURST_READ = 15;
  static final int ACK = 128;
  static final int NAK = 129;

  static final int MAX_DATA = 239;
  private static final int HEADER = 12;
  private static final int PAYLOAD = HEADER + MAX_DATA;

  /** Why a request is refused; the ordinal plus 1 is the code on the wire. */
  enum Refusal {
    FAIL,
    FAIL_ERRNO,
    INVALID_DATA_SIZE,
    INVALID_SESSION,
    NO_SESSIONS_AVAILABLE,
    END_OF_FILE,
    UNKNOWN_COMMAND,
    FILE_EXISTS,
    FILE_PROTECTED,
    FILE_NOT_FOUND
  }

  static FilePacket parse(byte[] payload) {
    ByteBuffer in = ByteBuffer.wrap(Arrays.copyOf(payload, PAYLOAD)).order(ByteOrder.LITTLE_ENDIAN);
    int sequence = in.getShort() & 0xFFFF;
    int session = in.get() & 0xFF;
    int opcode = in.get() & 0xFF;
    int size = in.get() & 0xFF;
    int requestOpcode = in.get() & 0xFF;
    boolean burstComplete = in.get() != 0;
    in.get(); // padding
    long offset = in.getInt() & 0xFFFF_FFFFL;
    byte[] data = new byte[MAX_DATA];
    in.get(data);
    return new FilePacket(
        sequence, session, opcode, size, requestOpcode, burstComplete, offset, data);
  }

  byte[] payload() {
    ByteBuffer out = ByteBuffer.allocate(PAYLOAD).order(ByteOrder.LITTLE_ENDIAN);
    out.putShort((short) sequence).put((byte) session).put((byte) opcode).put((byte) size);
    out.put((byte) requestOpcode).put((byte) (burstComplete ? 1 : 0)).put((byte) 0);
    return out.putInt((int) offset).put(data).array();
  }

  /** Path in a request: the stated number of bytes, up to the first zero. */
  String path() {
    int end = 0;
    while (end < Math.min(size, data.length) && data[end] != 0) {
      end++;
    }
    return new String(data, 0, end, StandardCharsets.ISO_8859_1);
  }

  FilePacket ack(byte[] answer) {
    return ack(session, offset, answer);
  }

  FilePacket ack(int ofSession, long at, byte[] answer) {
    return new FilePacket(
        sequence + 1 & 0xFFFF, ofSession, ACK, answer.length, opcode, false, at, answer);
  }

  /** One of the answers to a burst request. */
  FilePacket burst(int number, long at, byte[] answer, boolean last) {
    return new FilePacket(
        sequence + 1 + number & 0xFFFF, session, ACK, answer.length, opcode, last, at, answer);
  }

  FilePacket nak(Refusal why) {
    byte[] code = {(byte) (why.ordinal() + 1)};
    return new FilePacket(sequence + 1 & 0xFFFF, session, NAK, 1, opcode, false, offset, code);
  }
}
