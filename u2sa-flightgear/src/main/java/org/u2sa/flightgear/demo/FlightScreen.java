package org.u2sa.flightgear.demo;

import java.util.function.Consumer;
import org.u2sa.gcs.report.FlightPlan;
import org.u2sa.gcs.report.FlightSample;
import org.u2sa.gcs.terminal.FlightStatus;
import org.u2sa.gcs.terminal.LiveStatus;
import org.u2sa.gcs.terminal.Terminal;
import org.u2sa.interfaces.Clock;

/**
 * Shows a flight on the terminal while it goes on. Belongs to the thread that calls {@link
 * #accept}.
 */
final class FlightScreen implements Consumer<FlightSample>, AutoCloseable {
  private final FlightPlan plan;
  private final PlannedLegs legs;
  private final LiveStatus live;
  private final Clock stopwatch;
  private final long startMicros;

  /**
   * @param stopwatch real time, also where the flight is faster
   */
  FlightScreen(FlightPlan plan, Terminal terminal, Clock stopwatch) {
    this.plan = plan;
    legs = new PlannedLegs(plan);
    live = new LiveStatus(terminal);
    this.stopwatch = stopwatch;
    startMicros = stopwatch.micros();
  }

  @Override
  public void accept(FlightSample sample) {
    int count = plan.waypoints().size();
    boolean flying = sample.leg() >= 0 && sample.leg() < count;
    live.update(
        new FlightStatus(
            sample.phase(),
            Math.min(sample.leg() + 1, count),
            count,
            flying ? plan.waypoints().get(sample.leg()).name() : "",
            legs.distanceM(sample.leg(), sample.longitudeDeg(), sample.latitudeDeg()),
            sample.altitudeM(),
            sample.calibratedAirspeedMps(),
            sample.rollRad(),
            sample.crossTrackM(),
            sample.timeS(),
            Clock.seconds(stopwatch.micros() - startMicros)));
  }

  @Override
  public void close() {
    live.close();
  }
}
