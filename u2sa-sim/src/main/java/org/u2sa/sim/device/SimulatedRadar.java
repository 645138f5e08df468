package org.u2sa.sim.device;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.device.port.TrackingRadar;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** A radar that measures bearings relative to the vehicle's heading, and elevations. */
public final class SimulatedRadar extends NoisyDevice<TrackingRadar.Tracks>
    implements TrackingRadar {
  private final double reachM;
  private final double angleSigmaRad;
  private final Supplier<VehicleTruth> truth;
  private final Supplier<List<SimulatedTraffic.Other>> others;

  /**
   * Uses the random stream {@code radar}.
   *
   * @param errors errors of the range [m]
   * @param reachM maximum range [m]
   * @param angleSigmaRad standard deviation of bearing and elevation [rad]
   * @param truth current state of the vehicle
   * @param others current states of all targets
   */
  public SimulatedRadar(
      SensorErrors errors,
      double reachM,
      double angleSigmaRad,
      NoiseStreams streams,
      Supplier<VehicleTruth> truth,
      Supplier<List<SimulatedTraffic.Other>> others) {
    super(errors, streams, "radar");
    this.reachM = reachM;
    this.angleSigmaRad = angleSigmaRad;
    this.truth = truth;
    this.others = others;
  }

  @Override
  protected Tracks measure(double timeS, long measuredAtMicros) {
    VehicleTruth now = truth.get();
    List<Track> tracks = new ArrayList<>();
    for (SimulatedTraffic.Other other : others.get()) {
      Point to = other.position().minus(now.position());
      double rangeM = Math.max(0.0, noisy(to.distance()));
      double bearing = angle(Math.atan2(to.x(), to.y()) - now.attitude().psi());
      double elevation = angle(Math.atan2(to.z(), Math.hypot(to.x(), to.y())));
      Point velocity = other.velocity();
      if (to.distance() <= reachM) {
        tracks.add(
            new Track(
                other.id(),
                measuredAtMicros,
                rangeM,
                new Direction(bearing, false),
                OptionalDouble.of(elevation),
                OptionalDouble.of(Math.hypot(velocity.x(), velocity.y())),
                Optional.of(new Direction(Math.atan2(velocity.x(), velocity.y()), true))));
      }
    }
    tracks.sort(Comparator.comparing(Track::id));
    return new Tracks(measuredAtMicros, List.copyOf(tracks));
  }

  private double angle(double exactRad) {
    return exactRad + angleSigmaRad * gaussian();
  }
}
