package org.u2sa.drivers.rc;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;

/**
 * The radio's automatic/manual switch (thesis 4.6.3). Automatic requires several consecutive long
 * pulses. An invalid pulse, or none within the time-out, means that the receiver is lost, until its
 * position is confirmed again. Not thread-safe.
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
    /** No receiver: who drives is for the owner of the switch to decide. */
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
          @Description(
              "Debounce: consecutive pulses required for automatic; at a board, manual requires one.")
          int confirmations,
      @Variable(name = "RC TIMEOUT", unit = "s", min = 0.05, max = 5, ifAbsent = 0.25)
          @Description("Time without a pulse after which the receiver counts as lost.")
          double timeout) {}

  private final Variables tuning;
  private final long timeoutMicros;
  private final int manualConfirmations;
  private Position position = Position.LOST;
  private Position next = Position.LOST; // position of the last pulses, not yet confirmed
  private int inRow;
  private long lastMicros;

  /** A switch at which one short pulse selects manual. */
  public RcSwitch(Variables tuning) {
    this(tuning, 1);
  }

  /**
   * @param manualConfirmations consecutive pulses required for manual
   */
  RcSwitch(Variables tuning, int manualConfirmations) {
    this.tuning = tuning;
    this.manualConfirmations = manualConfirmations;
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
      lose();
      return;
    }
    Position before = position(nowMicros);
    lastMicros = nowMicros;
    double thresholdUs =
        tuning.automaticAbove() - (before == Position.AUTOMATIC ? tuning.hysteresis() : 0.0);
    Position pulse = us > thresholdUs ? Position.AUTOMATIC : Position.MANUAL;
    inRow = pulse == next ? inRow + 1 : 1;
    next = pulse;
    boolean isAutomatic = pulse == Position.AUTOMATIC;
    if (inRow >= (isAutomatic ? tuning.confirmations() : manualConfirmations)) {
      position = pulse;
    }
  }

  /** Switch position at a time of the run's clock [µs]. */
  public Position position(long nowMicros) {
    if (nowMicros - lastMicros > timeoutMicros) {
      lose();
    }
    return position;
  }

  private void lose() {
    position = Position.LOST;
    next = Position.LOST;
  }
}
