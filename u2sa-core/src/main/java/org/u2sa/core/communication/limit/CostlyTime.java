package org.u2sa.core.communication.limit;

/**
 * The network thread's time for clients' long messages and grids: to decrypt, read and pass them
 * on. Several clients that send them share a part of it, in small pieces, so that short messages,
 * such as an emergency stop, wait for little. A client that is the only one need only pause between
 * pieces. For the network's thread only.
 */
public final class CostlyTime {
  private static final double PART = 0.5;
  private static final double PIECE_S = 0.005;
  private static final long PAUSE_MICROS = 1_000;
  private static final long ALONE_AFTER_MICROS = 100_000;

  private final Allowance shared; // [s]
  private Object last; // client that asked last
  private long sinceMicros; // since when no other client asked
  private double pieceS; // left to a client alone
  private long tookMicros; // when one took last

  /** Nothing is used up yet. */
  public CostlyTime(long nowMicros) {
    shared = Allowance.ofTime(PART, PIECE_S, nowMicros);
  }

  /** Whether the client may go on with its long messages. */
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
   * Charges time that a client's long message took, or will take.
   *
   * @param seconds may overdraw what is left
   */
  public void take(Object client, double seconds, long nowMicros) {
    if (isAlone(client, nowMicros)) {
      pieceS -= seconds;
    } else {
      shared.take(seconds); // before the refill of that time, which may exceed the burst
    }
    tookMicros = nowMicros;
  }

  private boolean isAlone(Object client, long nowMicros) {
    return client == last && nowMicros - sinceMicros >= ALONE_AFTER_MICROS;
  }
}
