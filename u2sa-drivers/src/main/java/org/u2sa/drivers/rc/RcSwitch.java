package org.u2sa.drivers.rc;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;

/**
 * The switch on the radio between automatic and manual (thesis 4.6.3). A short pulse, one that no
 * receiver gives, or none for the time-out is manual at once; automatic needs several long pulses
 * in a row. So a lost receiver is manual. Not safe for several threads.
 */
public final class RcSwitch {
  private static final double MICRO = 1.0e-6;

  /** What the switch and its receiver say. */
  public enum Position {
    /** Commands of the system may pass. */
    AUTOMATIC,
    /** Whoever holds the radio drives. */
    MANUAL,
    /** No receiver: as manual. */
    LOST
  }

  private final RcChannel channel;
  private final double automaticAboveUs;
  private final double hysteresisUs;
  private final int confirmations;
  private final long timeoutMicros;
  private Position position = Position.LOST;
  private int inRow;
  private long lastMicros;

  /**
   * @param channel which pulses count
   * @param automaticAboveUs longer pulses are automatic [µs]
   * @param hysteresisUs how much shorter a pulse must be to be manual again [µs], not negative
   * @param confirmations pulses in a row that automatic needs, at least 1
   * @param timeoutS without a pulse for longer the receiver is lost [s], positive
   * @throws BadInputException naming the value that does not fit
   */
  public RcSwitch(
      RcChannel channel,
      double automaticAboveUs,
      double hysteresisUs,
      int confirmations,
      double timeoutS) {
    if (!channel.isValid((automaticAboveUs - hysteresisUs) * MICRO)
        || !channel.isValid(automaticAboveUs * MICRO)
        || !(hysteresisUs >= 0.0)) {
      throw new BadInputException(
          "RC switch: automatic above "
              + automaticAboveUs
              + " us with a hysteresis of "
              + hysteresisUs
              + " us leaves the receiver's range of pulses");
    }
    if (confirmations < 1) {
      throw new BadInputException("RC switch confirmations: " + confirmations + " is below 1");
    }
    if (!(timeoutS > 0.0)) {
      throw new BadInputException("RC switch time-out: " + timeoutS + " s is not positive");
    }
    this.channel = channel;
    this.automaticAboveUs = automaticAboveUs;
    this.hysteresisUs = hysteresisUs;
    this.confirmations = confirmations;
    this.timeoutMicros = Clock.micros(timeoutS);
  }

  /**
   * Takes a measured pulse.
   *
   * @param pulseS its width [s]; NaN or out of range: the receiver is lost
   * @param nowMicros time of the run's clock [µs]
   */
  public void accept(double pulseS, long nowMicros) {
    if (!channel.isValid(pulseS)) {
      becomes(Position.LOST);
      return;
    }
    Position before = position(nowMicros);
    lastMicros = nowMicros;
    double us = pulseS / MICRO;
    double thresholdUs =
        before == Position.AUTOMATIC ? automaticAboveUs - hysteresisUs : automaticAboveUs;
    if (!(us > thresholdUs)) {
      becomes(Position.MANUAL);
    } else if (before != Position.AUTOMATIC) {
      inRow++;
      position = inRow >= confirmations ? Position.AUTOMATIC : Position.MANUAL;
    }
  }

  /** Where the switch is at a time of the run's clock [µs]. */
  public Position position(long nowMicros) {
    if (position != Position.LOST && nowMicros - lastMicros > timeoutMicros) {
      becomes(Position.LOST);
    }
    return position;
  }

  private void becomes(Position other) {
    position = other;
    inRow = 0;
  }
}
