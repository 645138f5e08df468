package org.u2sa.gcs.mavlink;

import java.io.IOException;
import java.util.List;
import org.u2sa.interfaces.communication.SerialLine;

/**
 * One station on a serial line. Sends no faster than the line's rate, so that answers are not
 * queued behind telemetry.
 */
final class SerialLink implements StationLink {
  private static final int BITS_PER_BYTE = 10; // bits per byte, including start and stop bit
  private static final double MICROS_PER_S = 1.0e6;
  private static final double BURST_S = 0.05;
  private static final double ROOM_S = 0.1;
  private static final int LARGEST_PACKET = 293; // MAVLink 2, signed
  private static final double PAUSE_S = 0.1; // of adapters and radios within a packet

  private final SerialLine line;
  private final StationSession session;
  private final double bytesPerS;
  private final StationReader reader = new StationReader();
  private double allowed; // bytes that may be sent; negative if the last packet was longer
  private long filledMicros = Long.MIN_VALUE;

  SerialLink(SerialLine line, int baud, StationSession session) {
    this.line = line;
    this.session = session;
    bytesPerS = (double) baud / BITS_PER_BYTE;
    session.overdueAfter((long) ((PAUSE_S + LARGEST_PACKET / bytesPerS) * MICROS_PER_S));
    session.room(Math.max(LARGEST_PACKET, (int) (bytesPerS * ROOM_S)));
  }

  @Override
  public void exchange(long nowMicros) throws IOException {
    reader.read(line::read, session, nowMicros);
    if (filledMicros != Long.MIN_VALUE) {
      double passedS = (nowMicros - filledMicros) / MICROS_PER_S;
      allowed = Math.min(bytesPerS * BURST_S, allowed + bytesPerS * passedS);
    }
    filledMicros = nowMicros;
    send();
  }

  private void send() {
    for (byte[] packet = next(); packet != null; packet = next()) {
      line.write(packet); // dropped if nobody listens, as with a radio; later packets are newer
      allowed -= packet.length;
    }
  }

  private byte[] next() {
    return allowed > 0.0 ? session.poll() : null;
  }

  @Override
  public Iterable<StationSession> sessions() {
    return List.of(session);
  }

  @Override
  public void close() {
    line.close();
  }
}
