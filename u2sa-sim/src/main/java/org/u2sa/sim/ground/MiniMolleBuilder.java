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
 * Builder of a {@link MiniMolle}. Defaults: differential vehicle at the world's origin, facing
 * north, a survey receiver sending UBX at 8 Hz and 9600 baud (the most that fits), a calibrated
 * compass at 9600 baud, no hazards, seed 1.
 */
public final class MiniMolleBuilder {
  private static final int BAUD = 9600;
  private static final double AT_9600_HZ = 8.0;
  private static final double VOLTMETER_NOISE_V = 0.005;

  final World world;
  MiniMolle.Wiring wiring = MiniMolle.Wiring.standard();
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

  /** Sets the vehicle, which keeps its pose and is placed in the world by {@code build}. */
  public MiniMolleBuilder vehicle(GroundVehicle newVehicle) {
    vehicle = Objects.requireNonNull(newVehicle, "vehicle");
    return this;
  }

  /** Sets the pins. */
  public MiniMolleBuilder wiring(MiniMolle.Wiring newWiring) {
    wiring = Objects.requireNonNull(newWiring, "wiring");
    return this;
  }

  /** Sets the receiver and its initial output. */
  public MiniMolleBuilder gps(GpsParameters parameters, UbloxSettings settings) {
    gps = Objects.requireNonNull(parameters, "parameters");
    gpsSettings = Objects.requireNonNull(settings, "settings");
    return this;
  }

  /** Sets the compass, including the local declination. */
  public MiniMolleBuilder compass(CompassParameters parameters, int baud) {
    compass = Objects.requireNonNull(parameters, "parameters");
    compassBaud = baud;
    return this;
  }

  public MiniMolleBuilder hazards(Hazards newHazards) {
    hazards = Objects.requireNonNull(newHazards, "hazards");
    return this;
  }

  /** Sets the seed of all sensor noise. */
  public MiniMolleBuilder seed(long seed) {
    streams = new NoiseStreams(seed);
    return this;
  }

  /** Builds the hardware at rest. A vehicle instance can be used only once. */
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
