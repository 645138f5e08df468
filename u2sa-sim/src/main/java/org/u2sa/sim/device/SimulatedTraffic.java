package org.u2sa.sim.device;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.Supplier;
import org.u2sa.device.port.TrafficPicture;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.world.LocalPlane;

/** A traffic receiver (ADS-B) with limited range and report loss. */
public final class SimulatedTraffic extends SimulatedDevice<TrafficReceiver.Traffic>
    implements TrafficReceiver {
  private final SensorErrors errors;
  private final double reachM;
  private final LocalPlane plane;
  private final Supplier<Point> own;
  private final Supplier<List<Other>> others;
  private final Random noise;
  private final TrafficPicture picture = new TrafficPicture();

  /**
   * True state of another vehicle.
   *
   * @param id identifier in its reports
   * @param position east, north, up on the world's plane [m]
   * @param velocity east, north, up [m/s]
   */
  public record Other(String id, String kind, Point position, Point velocity) {}

  /**
   * Uses the random stream {@code traffic}.
   *
   * @param errors position errors per axis [m]; the loss rate applies to whole reports
   * @param reachM reception range [m]
   * @param own current position of the receiver
   * @param others current states of all others
   */
  public SimulatedTraffic(
      SensorErrors errors,
      double reachM,
      LocalPlane plane,
      NoiseStreams streams,
      Supplier<Point> own,
      Supplier<List<Other>> others) {
    super(errors.rateHz(), errors.latencyS());
    this.errors = errors;
    this.reachM = reachM;
    this.plane = plane;
    this.own = own;
    this.others = others;
    noise = streams.of("traffic");
  }

  @Override
  protected Traffic measure(double timeS, long measuredAtMicros) {
    Point here = own.get();
    for (Other other : others.get()) {
      boolean isLost = noise.nextDouble() < errors.lost();
      Geodetic place =
          plane.at(
              noisy(other.position().x()),
              noisy(other.position().y()),
              noisy(other.position().z()));
      if (!isLost && other.position().distanceTo(here) <= reachM) {
        picture.heard(
            new TrafficTarget(
                other.id(),
                "",
                other.kind(),
                measuredAtMicros,
                place.latitudeDeg(),
                place.longitudeDeg(),
                OptionalDouble.of(place.altitudeM()),
                false,
                Optional.of(other.velocity()),
                OptionalDouble.of(errors.sigma())),
            measuredAtMicros);
      }
    }
    picture.alive(measuredAtMicros);
    return picture.latest().orElseThrow();
  }

  private double noisy(double metres) {
    return metres + errors.sigma() * noise.nextGaussian();
  }
}
