package org.u2sa.drivers.ioio;

import org.u2sa.interfaces.time.Clock;

/** What the board's LED tells who stands beside the vehicle. */
enum StatusLed {
  /** It obeys commands: lit. Keep away. */
  OBEYS(1.0, 1.0),
  /** The radio's switch is at manual, or no receiver is there: a slow blink. */
  MANUAL(1.0, 0.5),
  /** An emergency stop holds, or the vehicle is not armed: a fast blink. */
  STOPPED(0.25, 0.5);

  private final long periodMicros;
  private final long litMicros;

  StatusLed(double periodS, double litShare) {
    periodMicros = Clock.micros(periodS);
    litMicros = Clock.micros(periodS * litShare);
  }

  /** Whether the LED is lit at a time of the run [µs]. */
  boolean isLit(long nowMicros) {
    return Math.floorMod(nowMicros, periodMicros) < litMicros;
  }
}
