package org.u2sa.sim.guide;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.vehicle.FixedStep;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * A carriage on a straight {@link Guide}, such as an elevator's. It keeps its attitude, and its
 * brake holds it while the drive has no signal. Integrates internally at 500 Hz. Not thread-safe.
 */
public final class Carriage implements SimulatedVehicle {
  /** Name of the only actuator; positive commands drive along the guide's direction. */
  public static final String DRIVE = "DRIVE";

  private static final int TICKS_PER_SECOND = 500;
  private static final double TICK_S = 1.0 / TICKS_PER_SECOND;

  private final Guide guide;
  private final double massKg;
  private final Footprint footprint;
  private final World world;
  private final Point start;
  private final double headingRad;
  private final Point way; // unit vector east, north, up
  private final double weightN; // of carriage and counterweight, along the guide
  private final FixedStep steps = new FixedStep(TICKS_PER_SECOND);
  private double command = Double.NaN;
  private double forceN;
  private double placeM;
  private double speedMps;
  private double accelerationMps2;
  private double energyJ;

  /**
   * Creates a carriage at rest, with the drive off.
   *
   * @param massKg mass of the carriage, without the counterweight
   * @param start east, north, up [m]
   * @param headingRad clockwise from north [rad]
   */
  public Carriage(
      Guide guide,
      double massKg,
      Footprint footprint,
      World world,
      Point start,
      double headingRad) {
    this.guide = guide;
    this.massKg = massKg;
    this.footprint = footprint;
    this.world = world;
    this.start = start;
    this.headingRad = headingRad;
    double sin = StrictMath.sin(headingRad);
    double cos = StrictMath.cos(headingRad);
    Point body = guide.direction();
    way = Point.of(body.x() * sin + body.y() * cos, body.x() * cos - body.y() * sin, -body.z());
    weightN = (massKg - guide.counterweightKg()) * Gravity.STANDARD_MPS2 * body.z();
  }

  @Override
  public List<String> actuators() {
    return List.of(DRIVE);
  }

  @Override
  public void command(String actuator, double value) {
    if (!actuator.equals(DRIVE)) {
      throw new IllegalArgumentException("actuator \"" + actuator + "\": expected " + actuators());
    }
    command =
        Double.isNaN(value)
            ? value
            : Arguments.requireInside("command of " + actuator, value, -1.0, 1.0);
  }

  @Override
  public void step(double dtS) {
    steps.step(dtS, this::tick);
  }

  private void tick() {
    boolean isDriven = !Double.isNaN(command);
    double wanted = isDriven ? command * guide.forceN() : 0.0;
    forceN += (wanted - forceN) * -StrictMath.expm1(-TICK_S / guide.lagS());
    double before = speedMps;
    double mass = massKg + guide.counterweightKg();
    double free = speedMps + (forceN + weightN) / mass * TICK_S;
    free /= 1.0 + guide.dragNsPerM() / mass * TICK_S; // implicit: any drag is stable
    double friction = guide.frictionN() + (isDriven ? 0.0 : guide.brakeN());
    double slowing = friction / mass * TICK_S;
    speedMps = StrictMath.copySign(StrictMath.max(0.0, StrictMath.abs(free) - slowing), free);
    double next = placeM + speedMps * TICK_S;
    placeM = StrictMath.max(guide.lowestM(), StrictMath.min(guide.highestM(), next));
    if (placeM != next) {
      speedMps = 0.0;
    }
    accelerationMps2 = (speedMps - before) / TICK_S;
    energyJ += forceN * speedMps * TICK_S;
  }

  /** {@inheritDoc} Counts the work of the drive. */
  @Override
  public OptionalDouble energyJ() {
    return OptionalDouble.of(energyJ);
  }

  @Override
  public OptionalDouble thrustN(String actuator) {
    return actuator.equals(DRIVE) ? OptionalDouble.of(forceN) : OptionalDouble.empty();
  }

  private Point along(double amount) {
    return Point.of(amount * way.x(), amount * way.y(), amount * way.z());
  }

  @Override
  public VehicleTruth truth() {
    return new VehicleTruth(
        steps.timeS(),
        start.plus(along(placeM)),
        new Attitude(0.0, 0.0, headingRad),
        along(speedMps),
        Point.ORIGIN,
        along(accelerationMps2));
  }

  @Override
  public Footprint footprint() {
    return footprint;
  }

  @Override
  public World world() {
    return world;
  }
}
