package org.u2sa.sim.device;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.u2sa.device.payload.HydrophoneArray;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Hydrophones that measure the arrival times of one pinger's spherical waves, at any distance. A
 * hydrophone may miss the direct wave and mistake an echo for it.
 */
public final class SimulatedHydrophoneTimes extends NoisyDevice<HydrophoneArray.Heard>
    implements HydrophoneArray {
  private static final double MAX_ECHO_S = 2e-3; // detour of 3 m

  private final Source source;
  private final Supplier<VehicleTruth> truth;
  private final List<Point> places;
  private final double[] biasesS;

  /**
   * A pinger.
   *
   * @param place east, north, up [m]
   * @param soundMps speed of sound [m/s]
   * @param echoes fraction of echoes among a hydrophone's arrivals, 0…1
   */
  public record Source(double frequencyHz, Point place, double soundMps, double echoes) {}

  /**
   * Uses the random stream {@code hydrophones}.
   *
   * @param errors errors of the arrival times [s]; their rate is that of the pings
   * @param places positions of the hydrophones on the array: forward, left, down [m]
   * @param truth current state of the array
   */
  public SimulatedHydrophoneTimes(
      SensorErrors errors,
      Source source,
      List<Point> places,
      NoiseStreams streams,
      Supplier<VehicleTruth> truth) {
    super(errors, streams, "hydrophones");
    this.source = source;
    this.truth = truth;
    this.places = List.copyOf(places);
    biasesS = places.stream().mapToDouble(place -> bias()).toArray();
  }

  @Override
  protected Heard measure(double timeS, long measuredAtMicros) {
    VehicleTruth now = truth.get();
    Point pinger = VehicleAxes.of(now, source.place().minus(now.position()));
    List<Double> arrivalsS = new ArrayList<>();
    for (int i = 0; i < places.size(); i++) {
      double echoS = uniform() < source.echoes() ? MAX_ECHO_S * uniform() : 0.0;
      double travelS = pinger.distanceTo(places.get(i)) / source.soundMps();
      arrivalsS.add(noisy(travelS + biasesS[i] + echoS));
    }
    return new Arrivals(measuredAtMicros, source.frequencyHz(), List.copyOf(arrivalsS));
  }
}
