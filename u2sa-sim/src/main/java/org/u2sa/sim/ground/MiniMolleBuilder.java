package org.u2sa.sim.ground;

import java.time.Instant;
import java.util.Objects;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.sensor.SpartonDevice;
import org.u2sa.sim.sensor.UbloxReceiver;
import org.u2sa.sim.sensor.UbloxSettings;
import org.u2sa.sim.sensor.UtcTime;
import org.u2sa.sim.sensor.VoltmeterModel;
import org.u2sa.sim.world.World;

/**
 * Puts a {@link MiniMolle} together. Without more it is the differential vehicle at the world's
 * origin, facing north, with a survey receiver that sends UBX eight times a second at 9600 baud,
 * which carries no more, a calibrated compass at 9600 baud, no hazards and seed 1.
 */
public final class MiniMolleBuilder {
  private static final int BAUD = 9600;
  private static final double AT_9600_HZ = 8.0;
  private static final double VOLTMETER_NOISE_V = 0.005;

  final World world;
  final MiniMolle.Wiring wiring = MiniMolle.Wiring.standard();
  GroundVehicle vehicle = new DifferentialVehicle(DifferentialParameters.miniMolle());
  Hazards hazards = Hazards.none();
  private GpsParameters gps = GpsParameters.survey();
  private UbloxSettings gpsSettings = UbloxSettings.binary(BAUD, AT_9600_HZ);
  private CompassParameters compass = CompassParameters.calibrated(0.0);
  private int compassBaud = BAUD;
  private final UtcTime utc = new UtcTime(Instant.parse("2026-06-01T12:00:00Z"));
  private NoiseStreams streams = new NoiseStreams(1L);

  MiniMolleBuilder(World world) {
    this.world = Objects.requireNonNull(world, "world");
  }

  /** Another vehicle. Its place is its own; it enters the world when it is built in. */
  public MiniMolleBuilder vehicle(GroundVehicle newVehicle) {
    vehicle = Objects.requireNonNull(newVehicle, "vehicle");
    return this;
  }

  /** Another receiver, and what it sends until it is told otherwise. */
  public MiniMolleBuilder gps(GpsParameters parameters, UbloxSettings settings) {
    gps = Objects.requireNonNull(parameters, "parameters");
    gpsSettings = Objects.requireNonNull(settings, "settings");
    return this;
  }

  /** Another compass, and the declination of the place with it. */
  public MiniMolleBuilder compass(CompassParameters parameters, int baud) {
    compass = Objects.requireNonNull(parameters, "parameters");
    compassBaud = baud;
    return this;
  }

  /** What goes wrong. */
  public MiniMolleBuilder hazards(Hazards newHazards) {
    hazards = Objects.requireNonNull(newHazards, "hazards");
    return this;
  }

  /** The seed of all sensors' noise. */
  public MiniMolleBuilder seed(long seed) {
    streams = new NoiseStreams(seed);
    return this;
  }

  /** The hardware, at rest. A vehicle serves once. */
  public MiniMolle build() {
    return new MiniMolle(this);
  }

  UbloxReceiver gps() {
    return new UbloxReceiver(gpsSettings, gps, world.plane(), utc, streams);
  }

  SpartonDevice compass() {
    return new SpartonDevice(compassBaud, compass, streams);
  }

  VoltmeterModel voltmeter() {
    return new VoltmeterModel(wiring.dividerRatio(), VOLTMETER_NOISE_V, streams);
  }
}
