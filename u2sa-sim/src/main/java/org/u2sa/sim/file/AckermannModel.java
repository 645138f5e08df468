package org.u2sa.sim.file;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.ground.AckermannParameters;
import org.u2sa.sim.ground.AckermannVehicle;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** A driven rear axle and steered front wheels; the reference point is below the rear axle. */
record AckermannModel(AckermannParameters parameters, Footprint footprint) implements GroundModel {
  private static final String STEERING = "STEERING";

  static AckermannModel read(FileElement file, Body body) {
    AckermannParameters parameters =
        new AckermannParameters(
            body.massKg(),
            body.inertiaAboutGravityCentre().z(),
            body.gravityCentre().x(),
            body.gravityHeightM(),
            file.number("wheelbase", "m", 0.02, 20.0),
            file.number("wheelRadius", "m", 0.005, 5.0),
            file.number("wheelInertia", "kg m^2", 1e-6, 1_000.0),
            file.number("steeringAngle", "rad", 0.01, 1.2),
            file.number("steeringLag", "s", 0.01, 10.0),
            file.number("steeringRate", "rad/s", 0.01, 100.0),
            GroundParts.motor(file.part("motor")),
            GroundParts.tyre(file.part("tyre")),
            GroundParts.battery(file.part("battery")),
            GroundParts.payload(file, body));
    AckermannModel model = new AckermannModel(parameters, body.footprint());
    model.make(Point.ORIGIN, 0.0); // rejects a vehicle that would tip over
    return model;
  }

  private AckermannVehicle make(Point start, double headingRad) {
    return new AckermannVehicle(
        parameters, new GroundStart(start.x(), start.y(), headingRad), footprint);
  }

  @Override
  public List<String> actuators() {
    return List.of("THROTTLE", STEERING);
  }

  @Override
  public OptionalDouble travelRad(String actuator) {
    return actuator.equals(STEERING)
        ? OptionalDouble.of(parameters.steerMaxRad())
        : OptionalDouble.empty();
  }

  @Override
  public GroundVehicle make(World world, Point start, double headingRad, long seed) {
    AckermannVehicle vehicle = make(start, headingRad);
    vehicle.enter(world);
    return vehicle;
  }
}
