package org.u2sa.network;

import java.nio.file.Path;
import java.util.Locale;
import org.u2sa.flightgear.link.EmbeddedStart;
import org.u2sa.flightgear.link.StandInFlightGear;
import org.u2sa.flightgear.link.StandInSetup;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.mission.Mission;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.atmosphere.Wind;

/**
 * A Cessna in the stand-in simulator as a process of its own, which flies on whatever becomes of
 * the services of its host. Says the truth ten times a second: {@link Aircraft} reads it.
 */
final class AircraftMain {
  private static final String HERE = "127.0.0.1";
  private static final long EVERY_MICROS = 100_000;

  private AircraftMain() {}

  /** Takes the mission's file, and the ports for readings, controls and properties. */
  public static void main(String[] arguments) throws Exception {
    Clock clock = new SystemClock();
    try (StandInFlightGear aircraft =
            new StandInFlightGear(
                Cessna172.onRunway(
                    EmbeddedStart.of(Mission.load(Path.of(arguments[0]))),
                    Wind.gusty(1.0, 4.0, 1),
                    true),
                StandInSetup.likeFlightGear(),
                HERE,
                Integer.parseInt(arguments[2]),
                Integer.parseInt(arguments[3]),
                clock);
        Clock.Waiter waiter = clock.newWaiter("truth")) {
      aircraft.start(HERE, Integer.parseInt(arguments[1]));
      while (!System.out.checkError()) { // until nobody reads
        System.out.println(truth(aircraft.said()));
        waiter.await(clock.micros() + EVERY_MICROS);
      }
    }
  }

  private static String truth(OutLine said) {
    return String.format(
        Locale.ROOT,
        "%.2f,%.6f,%.6f,%.1f,%.1f,%.1f,%b",
        said.get(OutField.ELAPSED),
        said.get(OutField.LONGITUDE),
        said.get(OutField.LATITUDE),
        said.get(OutField.HEIGHT),
        said.get(OutField.CALIBRATED_AIRSPEED),
        Math.toDegrees(said.get(OutField.ROLL)),
        said.isSet(OutField.CRASHED) || said.isSet(OutField.WEIGHT_ON_WHEEL));
  }
}
