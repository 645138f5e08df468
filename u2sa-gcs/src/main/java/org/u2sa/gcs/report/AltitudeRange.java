package org.u2sa.gcs.report;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/** Lowest and highest altitude [m] of a flight and its plan, at least 100 m apart. */
record AltitudeRange(double lowM, double highM) {

  private static final double LEAST_SPAN_M = 100.0;

  static AltitudeRange of(FlightPlan plan, List<FlightSample> track) {
    DoubleStream planned =
        Stream.concat(
                plan.home().stream().map(Home::altitudeM),
                plan.waypoints().stream()
                    .filter(w -> w.altitudeM().isPresent())
                    .map(w -> w.altitudeM().getAsDouble()))
            .mapToDouble(Double::doubleValue);
    double[] all =
        DoubleStream.concat(planned, track.stream().mapToDouble(FlightSample::altitudeM))
            .sorted()
            .toArray();
    double low = all.length == 0 ? 0.0 : all[0];
    double high = all.length == 0 ? 0.0 : all[all.length - 1];
    return new AltitudeRange(low, Math.max(high, low + LEAST_SPAN_M));
  }
}
