package org.u2sa.core.communication.limit;

/**
 * Rations the network thread's time for decrypting, reading and forwarding clients' long messages
 * and grids. Several clients share a part of it, in small slices, so that short messages such as an
 * emergency stop are hardly delayed. A single client only has to pause between slices. Confined to
 * the network thread.
 */
public final class CostlyTime {
  private static final double PART = 0.5;
  private static final double PIECE_S = 0.005;
  private static final long PAUSE_MICROS = 1_000;
  private static final long ALONE_AFTER_MICROS = 100_000;

  private final Allowance shared; // [s]
  private Object last; // client that asked last
  private long sinceMicros; // start of the period in which no other client asked
  private double pieceS; // remaining time of a single client
  private long tookMicros; // time of the last charge

  /** Starts with the full allowance. */
  public CostlyTime(long nowMicros) {
    shared = Allowance.ofTime(PART, PIECE_S, nowMicros);
  }

  /** Whether the client may continue with its long messages. */
  public boolean isOpen(Object client, long nowMicros) {
    if (client != last) {
      last = client;
      sinceMicros = nowMicros;
    }
    if (!isAlone(client, nowMicros)) {
      return shared.isOpen(nowMicros);
    }
    if (nowMicros - tookMicros >= PAUSE_MICROS) {
      pieceS = PIECE_S;
    }
    return pieceS > 0.0;
  }

  /**
   * Charges time that a client's long message took or will take.
   *
   * @param seconds time charged, which may exceed the remaining allowance
   */
  public void take(Object client, double seconds, long nowMicros) {
    if (isAlone(client, nowMicros)) {
      pieceS -= seconds;
    } else {
      shared.take(seconds); // before the refill, which is capped at the burst
    }
    tookMicros = nowMicros;
  }

  private boolean isAlone(Object client, long nowMicros) {
    return client == last && nowMicros - sinceMicros >= ALONE_AFTER_MICROS;
  }
}
