package org.u2sa.mavlink;

import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Signs MAVLink 2 packets of one link and checks signatures (mavlink.io/en/guide/message_signing).
 * A link's own timestamps follow those of its stations, so that stations with another clock hear
 * it. The links of a system share the {@link SignedStreams}.
 */
public final class MavlinkSigning {
  private static final long EPOCH_MICROS = 1_420_070_400_000_000L; // 2015-01-01 UTC
  private static final long TICK_MICROS = 10;
  private static final double TICKS_PER_S = 100_000.0;
  private static final long SET_BACK_TICKS = 1_000_000; // networks do not delay packets by so much
  private static final long LATEST = (1L << 48) - (1L << 40); // later ones are not followed
  private static final int LINK_ID = 0;
  private static final int BYTE = 8;
  private static final int MAGIC_2 = 0xFD;
  private static final int FLAGS = 2; // offsets in the frame
  private static final int SYSTEM = 5;
  private static final int SIGNED = 0x01;
  private static final int TIMESTAMP = 6; // bytes
  private static final int SIGNATURE = 6;

  private final byte[] key;
  private final LongSupplier unixMicros;
  private final SignedStreams streams;
  private final Consumer<String> warnings;
  private long newest; // newest timestamp of this link, received or sent [10 µs since 2015]

  /** As the other constructor, without warnings. */
  public MavlinkSigning(String passphrase, LongSupplier unixMicros) {
    this(passphrase, unixMicros, warning -> {});
  }

  /**
   * Packets that were signed before now are refused: an earlier run may have admitted them.
   *
   * @param passphrase shared with the stations, which hash it the same way
   * @param unixMicros the process's clock [µs since 1970]
   * @param warnings receives a line when a packet with the right signature is too old, at most once
   *     a minute
   */
  public MavlinkSigning(String passphrase, LongSupplier unixMicros, Consumer<String> warnings) {
    this(
        sha256(passphrase.getBytes(StandardCharsets.UTF_8)),
        unixMicros,
        new SignedStreams(ticks(unixMicros.getAsLong())),
        warnings);
  }

  private MavlinkSigning(
      byte[] key, LongSupplier unixMicros, SignedStreams streams, Consumer<String> warnings) {
    this.key = key;
    this.unixMicros = unixMicros;
    this.streams = streams;
    this.warnings = warnings;
  }

  /** Another link of the same system: a packet admitted by one is refused by the others. */
  public MavlinkSigning link() {
    return new MavlinkSigning(key, unixMicros, streams, warnings);
  }

  private static byte[] sha256(byte[] text) {
    try {
      return MessageDigest.getInstance("SHA-256").digest(text);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }

  /** Signed packet of a payload. */
  byte[] sign(int sequence, int system, int component, int message, int crc, byte[] payload) {
    newest = Math.max(newest + 1, wallTicks());
    byte[] frame =
        MavlinkPacket.createSignedMavlink2Packet(
                sequence, system, component, message, crc, payload, LINK_ID, newest, key)
            .getRawBytes();
    // The library's signature deviates from the specification.
    System.arraycopy(signature(frame), 0, frame, frame.length - SIGNATURE, SIGNATURE);
    return frame;
  }

  /** First 48 bits of SHA-256 over the key and the frame up to the signature. */
  private byte[] signature(byte[] frame) {
    byte[] text = Arrays.copyOf(key, key.length + frame.length - SIGNATURE);
    System.arraycopy(frame, 0, text, key.length, frame.length - SIGNATURE);
    return Arrays.copyOf(sha256(text), SIGNATURE);
  }

  private long wallTicks() {
    return ticks(unixMicros.getAsLong());
  }

  private static long ticks(long unixMicros) {
    return (unixMicros - EPOCH_MICROS) / TICK_MICROS;
  }

  /** Reason to reject a frame; empty if admitted, after which its timestamp is used up. */
  String refusal(byte[] frame) {
    String wrong = wrongSignature(frame);
    if (!wrong.isEmpty()) {
      return wrong;
    }
    long time = time(frame);
    long now = wallTicks();
    String refusal = streams.refusal(stream(frame), time, now);
    if (refusal.isEmpty()) {
      newest = Math.max(newest, Math.min(time, LATEST));
      return refusal;
    }
    boolean isNew = refusal.equals(SignedStreams.OUTDATED_STREAM);
    long newestOfStream = streams.newest(stream(frame));
    boolean isSetBack = !isNew && newestOfStream - time > SET_BACK_TICKS;
    if (isSetBack) {
      newest = Math.max(newest, Math.min(newestOfStream, LATEST)); // for its station to follow
    }
    if ((isNew || isSetBack) && streams.isWarningDue(now)) {
      warnings.accept(
          isNew
              ? warning(frame, streams.age(time, now), streams.maxAge(now))
              : setBack(frame, newestOfStream - time));
    }
    return refusal;
  }

  private static String setBack(byte[] frame, long ticks) {
    return String.format(
        Locale.ROOT,
        "MAVLink system %d, component %d is refused: its packet was signed %.1f s before its newest"
            + " one. It was recorded, or the station's clock has been set back; then it is heard"
            + " once it has heard the vehicle",
        frame[SYSTEM] & 0xFF,
        frame[SYSTEM + 1] & 0xFF,
        ticks / TICKS_PER_S);
  }

  private static String warning(byte[] frame, long ageTicks, long allowedTicks) {
    return String.format(
        Locale.ROOT,
        "MAVLink system %d, component %d is refused: its packet was signed %.1f s ago; expected"
            + " at most %.1f s, a minute or the time since the start. It was recorded, or the"
            + " station's clock is behind",
        frame[SYSTEM] & 0xFF,
        frame[SYSTEM + 1] & 0xFF,
        ageTicks / TICKS_PER_S,
        allowedTicks / TICKS_PER_S);
  }

  /** Whether a frame would be admitted; its timestamp is not used up. */
  boolean isAdmissible(byte[] frame) {
    return wrongSignature(frame).isEmpty()
        && !streams.isOutdated(stream(frame), time(frame), wallTicks());
  }

  private String wrongSignature(byte[] frame) {
    boolean isSigned = (frame[0] & 0xFF) == MAGIC_2 && frame[FLAGS] == SIGNED;
    if (!isSigned) {
      return "not signed";
    }
    byte[] signature = Arrays.copyOfRange(frame, frame.length - SIGNATURE, frame.length);
    return MessageDigest.isEqual(signature(frame), signature) ? "" : "wrong signature";
  }

  private static int stream(byte[] frame) {
    int link = frame[frame.length - SIGNATURE - TIMESTAMP - 1] & 0xFF;
    return (frame[SYSTEM] & 0xFF) << 2 * BYTE | (frame[SYSTEM + 1] & 0xFF) << BYTE | link;
  }

  private static long time(byte[] frame) {
    int end = frame.length - SIGNATURE;
    long time = 0;
    for (int i = end - 1; i >= end - TIMESTAMP; i--) {
      time = time << BYTE | frame[i] & 0xFF; // the least significant byte comes first
    }
    return time;
  }
}
