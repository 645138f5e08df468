package org.u2sa.flightgear.link;

import org.u2sa.interfaces.time.Clock;

/**
 * Measurement time of a line on the run's clock: an anchor (arrival of one line) plus FlightGear's
 * own time since then, so that steps between readings are steps of the flight, not of the network.
 * Three rules keep the age of a reading right:
 *
 * <ul>
 *   <li>Never later than the arrival. A line that comes sooner than expected (less delay than the
 *       anchor's, or FlightGear runs faster than the run's clock) becomes the anchor.
 *   <li>A line that arrives late keeps its early time, because lines that piled up during a network
 *       stall are old. Only if all lines within {@link #WINDOW_MICROS} were late by more than
 *       {@link #LATE_MICROS} has FlightGear itself lost time; the anchor then moves by the smallest
 *       lateness.
 *   <li>A line with FlightGear's time unchanged is not a new measurement (FlightGear is paused);
 *       the anchor moves with it.
 * </ul>
 *
 * With FlightGear at n times real time, measurement times are therefore arrival times, and one
 * second between readings is n seconds of flight. Confined to one thread.
 */
final class MeasuringTime {
  static final long LATE_MICROS = 30_000;
  static final long WINDOW_MICROS = 400_000;

  private boolean anchored;
  private long anchorMicros;
  private double anchorS;
  private double lastS;
  private long lastMicros = Long.MIN_VALUE;
  private long windowMicros; // arrival of the window's first line
  private long leastLateMicros; // of the window's lines

  /**
   * Records a line.
   *
   * @param elapsedS FlightGear's time [s]
   * @param arrivalMicros run's clock [µs]
   * @return whether it is a new measurement, whose time is then {@link #micros()}
   */
  boolean take(double elapsedS, long arrivalMicros) {
    boolean paused = anchored && elapsedS == lastS;
    if (!anchored || elapsedS <= lastS) { // earlier: FlightGear was reset or restarted
      anchor(elapsedS, arrivalMicros);
    }
    lastS = elapsedS;
    if (!paused) {
      lastMicros = Math.max(lastMicros + 1, measured(elapsedS, arrivalMicros));
    }
    return !paused;
  }

  /** Time of the newest measurement [µs]; strictly increasing. */
  long micros() {
    return lastMicros;
  }

  private long measured(double elapsedS, long arrivalMicros) {
    if (arrivalMicros - windowMicros > WINDOW_MICROS) {
      if (leastLateMicros > LATE_MICROS) {
        anchorMicros += leastLateMicros;
      }
      windowMicros = arrivalMicros;
      leastLateMicros = Long.MAX_VALUE;
    }
    long expected = anchorMicros + Clock.micros(elapsedS - anchorS);
    if (expected > arrivalMicros) {
      anchor(elapsedS, arrivalMicros);
      return arrivalMicros;
    }
    leastLateMicros = Math.min(leastLateMicros, arrivalMicros - expected);
    return expected;
  }

  private void anchor(double elapsedS, long arrivalMicros) {
    anchored = true;
    anchorS = elapsedS;
    anchorMicros = arrivalMicros;
    windowMicros = arrivalMicros;
    leastLateMicros = 0;
  }
}
