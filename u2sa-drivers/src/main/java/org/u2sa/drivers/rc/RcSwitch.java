package org.u2sa.drivers.rc;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;

/**
 * The radio's automatic/manual switch (thesis 4.6.3). A short pulse, an invalid pulse, or none
 * within the time-out selects manual immediately; automatic requires several consecutive long
 * pulses. A lost receiver therefore means manual. Not thread-safe.
 */
public final class RcSwitch {
  private static final double MICRO = 1.0e-6;
  private static final double SHORTEST_US = 800.0; // allows for radios with trims at their ends
  private static final double LONGEST_US = 2200.0;

  /** Switch position. */
  public enum Position {
    /** System commands are passed on. */
    AUTOMATIC,
    /** The radio operator drives. */
    MANUAL,
    /** No receiver; treated as manual. */
    LOST
  }

  /** Configuration variables of the switch. */
  public record Variables(
      @Variable(name = "RC AUTOMATIC ABOVE", unit = "us", min = 1000, max = 2000, ifAbsent = 1700)
          @Description("Pulse width of the radio's switch above which commands are obeyed.")
          double automaticAbove,
      @Variable(name = "RC HYSTERESIS", unit = "us", min = 0, max = 150, ifAbsent = 100)
          @Description("Hysteresis: how much shorter the pulse must be to return to manual.")
          double hysteresis,
      @Variable(name = "RC CONFIRMATIONS", min = 1, max = 50, ifAbsent = 3)
          @Description("Debounce: consecutive pulses required for automatic; manual requires one.")
          int confirmations,
      @Variable(name = "RC TIMEOUT", unit = "s", min = 0.05, max = 5, ifAbsent = 0.25)
          @Description("Time without a pulse after which the receiver counts as lost: manual.")
          double timeout) {}

  private final Variables tuning;
  private final long timeoutMicros;
  private Position position = Position.LOST;
  private int inRow;
  private long lastMicros;

  public RcSwitch(Variables tuning) {
    this.tuning = tuning;
    timeoutMicros = Clock.micros(tuning.timeout());
  }

  /**
   * Handles a measured pulse.
   *
   * @param pulseS width [s]; NaN or out of range means the receiver is lost
   * @param nowMicros time of the run's clock [µs]
   */
  public void accept(double pulseS, long nowMicros) {
    double us = pulseS / MICRO;
    if (!(us >= SHORTEST_US && us <= LONGEST_US)) {
      becomes(Position.LOST);
      return;
    }
    Position before = position(nowMicros);
    lastMicros = nowMicros;
    double thresholdUs =
        tuning.automaticAbove() - (before == Position.AUTOMATIC ? tuning.hysteresis() : 0.0);
    if (!(us > thresholdUs)) {
      becomes(Position.MANUAL);
    } else if (before != Position.AUTOMATIC) {
      inRow++;
      position = inRow >= tuning.confirmations() ? Position.AUTOMATIC : Position.MANUAL;
    }
  }

  /** Switch position at a time of the run's clock [µs]. */
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
