package org.u2sa.trials.run;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;

/**
 * Real-time watchdog of the vehicle's readings: reports when they stop and resume, and when to give
 * up. Not thread-safe.
 */
final class ReadingsWatch {
  private static final long SILENCE_MICROS = 2 * Clock.MICROS_PER_SECOND;
  private static final double APPEARS_WITHIN_S = 300.0;
  private static final double RETURNS_WITHIN_S = 60.0;

  private final Clock clock;
  private final String vehicle;
  private final Consumer<String> console;
  private final double appearsWithinS;
  private final double returnsWithinS;
  private final long beganMicros;
  private long seen; // number of readings
  private long seenMicros; // when the number last increased
  private boolean silent;

  /**
   * @param vehicle its name in messages, e.g. {@code aircraft}
   * @param patience timeout for the first reading and after a loss [s]; empty for 300 s and 60 s,
   *     respectively
   * @param console receives messages about the link
   */
  ReadingsWatch(Clock clock, String vehicle, OptionalDouble patience, Consumer<String> console) {
    this.clock = clock;
    this.vehicle = vehicle;
    this.console = console;
    appearsWithinS = patience.orElse(APPEARS_WITHIN_S);
    returnsWithinS = patience.orElse(RETURNS_WITHIN_S);
    beganMicros = clock.micros();
    seenMicros = beganMicros;
  }

  /**
   * Updates the watchdog with the number of readings so far.
   *
   * @return whether to give up
   */
  boolean isHopeless(long readings) {
    long now = clock.micros();
    if (readings != seen) {
      if (silent) {
        say("Readings are back after %.1f s.", now - seenMicros);
      }
      silent = false;
      seen = readings;
      seenMicros = now;
      return false;
    }
    double silenceS = Clock.seconds(now - seenMicros);
    if (seen > 0 && !silent && now - seenMicros >= SILENCE_MICROS) {
      silent = true;
      say("No readings from the " + vehicle + " for %.1f s; waiting for them.", now - seenMicros);
    }
    if (silenceS < (seen > 0 ? returnsWithinS : appearsWithinS)) {
      return false;
    }
    say("No readings from the " + vehicle + " for %.1f s: giving up.", now - seenMicros);
    return true;
  }

  private void say(String format, long micros) {
    console.accept(String.format(Locale.ROOT, format, Clock.seconds(micros)));
  }
}
