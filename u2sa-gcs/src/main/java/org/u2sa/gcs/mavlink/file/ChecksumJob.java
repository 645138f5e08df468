package org.u2sa.gcs.mavlink.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import org.u2sa.gcs.mavlink.file.FilePacket.Refusal;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;
import org.u2sa.mavlink.MavlinkCrc32;

/** Computes a file's checksum in parts, so that a large recording does not delay telemetry. */
final class ChecksumJob {
  private static final int PER_STEP = 256 * 1024;

  private FilePacket request; // this and the next are null when idle
  private Sender from;
  private ReadableFile file;
  private MavlinkCrc32 crc;
  private long at;

  /** Starts a checksum, replacing a running one. */
  void begin(FilePacket asked, Sender sender, ReadableFile content) {
    request = asked;
    from = sender;
    file = content;
    crc = new MavlinkCrc32();
    at = 0;
  }

  /** Sender that receives the answer of {@link #step}. */
  Sender from() {
    return from;
  }

  /** Computes the next part; returns the answer when it is complete. */
  Optional<FilePacket> step() {
    if (request == null) {
      return Optional.empty();
    }
    try {
      byte[] part = file.read(at, PER_STEP);
      crc.update(part);
      at += part.length;
    } catch (IOException e) {
      return Optional.of(done(request.nak(Refusal.FAIL)));
    }
    if (at < file.size()) {
      return Optional.empty();
    }
    byte[] answer =
        ByteBuffer.allocate(Integer.BYTES)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putInt(crc.value())
            .array();
    return Optional.of(done(request.ack(answer)));
  }

  private FilePacket done(FilePacket answer) {
    request = null;
    file = null;
    return answer;
  }
}
