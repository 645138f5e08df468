package org.u2sa.sim.file;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import org.u2sa.sim.device.SerialInstrument;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.RunningVehicle;

/** The sensors of a vehicle file that speak a protocol on a serial line. */
public final class VehicleInstruments {
  private VehicleInstruments() {}

  /**
   * Creates them.
   *
   * @param nowMicros time of the run [µs]
   * @param seed seed of the noise
   * @return instruments by element (gps, compass), with a hyphen and the service if only for that
   *     service
   */
  public static Map<String, SerialInstrument> of(
      VehicleFile file, RunningVehicle run, LongSupplier nowMicros, long seed) {
    Map<String, SerialInstrument> all = new LinkedHashMap<>();
    for (SensorEntry entry : file.sensors()) {
      String name = entry.kind() + entry.service().map(service -> "-" + service).orElse("");
      Aboard aboard =
          Aboard.of(
              run,
              nowMicros,
              List::of,
              new NoiseStreams(new NoiseStreams(seed).of("sensor " + name).nextLong()));
      entry.make(aboard).serial().ifPresent(instrument -> all.put(name, instrument));
    }
    return all;
  }
}
