package org.u2sa.sim.file;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.ground.BatteryParameters;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.ground.MotorParameters;
import org.u2sa.sim.ground.SkidSteerParameters;
import org.u2sa.sim.ground.SkidSteerVehicle;
import org.u2sa.sim.ground.TyreParameters;
import org.u2sa.sim.world.World;

/**
 * Any number of driven wheels per side.
 *
 * @param parameters parameters as a function of the motor mismatch
 */
record SkidSteerModel(
    DoubleFunction<SkidSteerParameters> parameters, Wheels measures, GroundParts.Mismatch mismatch)
    implements GroundModel {
  private static final int MAX_AXLES = 20;
  private static final double TURNING = 0.5; // command of a turn in place
  private static final double TURN_S = 3.0; // until the turn is steady
  private static final double MIN_TURN_RATE = 0.05; // [rad/s]

  static SkidSteerModel read(FileElement file, Body body) {
    GroundParts.Mismatch mismatch = GroundParts.mismatch(file);
    List<Double> axles = file.numbers("axles", "m", -20.0, 20.0, MAX_AXLES);
    double track = file.number("track", "m", 0.02, 10.0);
    double radius = file.number("wheelRadius", "m", 0.005, 5.0);
    double wheelInertia = file.number("wheelInertia", "kg m^2", 1e-6, 1_000.0);
    MotorParameters motor = GroundParts.motor(file.part("motor"));
    TyreParameters tyre = GroundParts.tyre(file.part("tyre"));
    BatteryParameters battery = GroundParts.battery(file.part("battery"));
    SkidSteerModel model =
        new SkidSteerModel(
            each ->
                new SkidSteerParameters(
                    body.massKg(),
                    body.inertiaAboutGravityCentre().z(),
                    body.gravityCentre().x(),
                    body.gravityHeightM(),
                    axles,
                    track,
                    radius,
                    wheelInertia,
                    each,
                    motor,
                    tyre,
                    battery,
                    body.footprint()),
            new Wheels(track, radius),
            mismatch);
    double turning = turningTrackM(model.make(Point.ORIGIN, 0.0, 0.0), track, radius);
    return new SkidSteerModel(model.parameters(), new Wheels(turning, radius), mismatch);
  }

  /**
   * Effective track from wheel speeds and turn rate in place, as in a calibration: the tyres drag
   * sideways, so the vehicle turns more slowly than its wheels' distance implies. Falls back to the
   * geometric track if it cannot turn at this power.
   */
  private static double turningTrackM(SkidSteerVehicle vehicle, double track, double radius) {
    vehicle.step(new DriveCommand(TURNING, -TURNING), TURN_S);
    GroundState turning = vehicle.state();
    double apartMps = radius * (turning.leftWheelRadPerS() - turning.rightWheelRadPerS());
    double yawRate = turning.yawRateRadPerS();
    return yawRate > MIN_TURN_RATE ? Math.max(track, apartMps / yawRate) : track;
  }

  private SkidSteerVehicle make(Point start, double headingRad, double mismatch) {
    return new SkidSteerVehicle(
        parameters.apply(mismatch), new GroundStart(start.x(), start.y(), headingRad));
  }

  @Override
  public List<String> actuators() {
    return List.of("LEFT MOTOR", "RIGHT MOTOR");
  }

  @Override
  public Optional<Wheels> wheels() {
    return Optional.of(measures);
  }

  @Override
  public GroundVehicle make(World world, Point start, double headingRad, long seed) {
    SkidSteerVehicle vehicle = make(start, headingRad, mismatch.of(seed));
    vehicle.enter(world);
    return vehicle;
  }
}
