package org.u2sa.gcs.mavlink.file;

import java.io.IOException;
import java.util.Optional;
import org.u2sa.gcs.mavlink.file.FilePacket.Refusal;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;

/** A file opened by a station, and the burst being sent. */
final class FileSession {
  private static final int BURST_PACKETS = 256;
  private static final int LATE_REQUESTS = 16;
  private static final long LATE_MICROS = 5_000_000;

  final Sender owner;
  final ReadableFile file;
  long usedMicros;
  private final int opening; // sequence number of the request
  private final long openedMicros;
  private Optional<FilePacket> burst = Optional.empty();
  private int sent;

  FileSession(FilePacket opening, Sender owner, ReadableFile file, long nowMicros) {
    this.opening = opening.sequence();
    openedMicros = nowMicros;
    this.owner = owner;
    this.file = file;
    usedMicros = nowMicros;
  }

  /**
   * Whether a request is a late repetition, sent shortly before this session was opened and meant
   * for the previous session of this number. Sequence numbers wrap around: at 65536, MAVProxy's at
   * 256.
   */
  boolean isAfter(FilePacket request, long nowMicros) {
    int requestsAgo = opening - request.sequence() & 0xFFFF;
    return requestsAgo < LATE_REQUESTS && nowMicros - openedMicros < LATE_MICROS;
  }

  /** Answers a read. */
  FilePacket read(FilePacket request) throws IOException {
    if (request.size() == 0 || request.size() > FilePacket.MAX_DATA) {
      return request.nak(Refusal.INVALID_DATA_SIZE);
    }
    if (request.offset() >= file.size()) {
      return request.nak(Refusal.END_OF_FILE);
    }
    return request.ack(file.read(request.offset(), request.size()));
  }

  /** Starts a burst, replacing a running one; returns an answer if it cannot start. */
  Optional<FilePacket> begin(FilePacket request) {
    burst = Optional.empty();
    if (request.size() == 0 || request.size() > FilePacket.MAX_DATA) {
      return Optional.of(request.nak(Refusal.INVALID_DATA_SIZE));
    }
    if (request.offset() >= file.size()) {
      return Optional.of(request.nak(Refusal.END_OF_FILE));
    }
    burst = Optional.of(request);
    sent = 0;
    return Optional.empty();
  }

  /** Next packet of the burst; empty if there is none. */
  Optional<FilePacket> next() throws IOException {
    if (burst.isEmpty()) {
      return Optional.empty();
    }
    FilePacket request = burst.get();
    long at = request.offset() + (long) sent * request.size();
    byte[] data = file.read(at, request.size());
    boolean isLast = sent == BURST_PACKETS - 1 || at + data.length >= file.size();
    FilePacket packet = request.burst(sent, at, data, isLast);
    sent++;
    if (isLast) {
      burst = Optional.empty();
    }
    return Optional.of(packet);
  }

  /** Ends the burst because the file cannot be read. */
  FilePacket fail() {
    FilePacket failed = burst.orElseThrow().nak(Refusal.FAIL);
    burst = Optional.empty();
    return failed;
  }
}
