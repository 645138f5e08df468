package org.u2sa.sim.file;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** Two driven wheels and a castor in front; the reference point is between the driven wheels. */
record DifferentialModel(
    DifferentialParameters parameters, Footprint footprint, GroundParts.Mismatch mismatch)
    implements GroundModel {

  static DifferentialModel read(FileElement file, Body body) {
    GroundParts.Mismatch mismatch = GroundParts.mismatch(file);
    DifferentialParameters parameters =
        new DifferentialParameters(
            body.massKg(),
            body.inertiaAboutGravityCentre().z(),
            body.gravityCentre().x(),
            body.gravityHeightM(),
            file.number("track", "m", 0.02, 10.0),
            file.number("castorAhead", "m", 0.01, 10.0),
            file.number("castorTrail", "m", 0.005, 2.0),
            file.number("wheelRadius", "m", 0.005, 5.0),
            file.number("wheelInertia", "kg m^2", 1e-6, 1_000.0),
            0.0,
            GroundParts.motor(file.part("motor")),
            GroundParts.tyre(file.part("tyre")),
            GroundParts.battery(file.part("battery")),
            GroundParts.payload(file, body));
    DifferentialModel model = new DifferentialModel(parameters, body.footprint(), mismatch);
    model.make(Point.ORIGIN, 0.0, 0.0); // rejects a vehicle that would tip over
    return model;
  }

  private DifferentialVehicle make(Point start, double headingRad, double mismatch) {
    return new DifferentialVehicle(
        parameters.withMismatch(mismatch),
        new GroundStart(start.x(), start.y(), headingRad),
        footprint);
  }

  @Override
  public List<String> actuators() {
    return List.of("LEFT MOTOR", "RIGHT MOTOR");
  }

  @Override
  public Optional<Wheels> wheels() {
    return Optional.of(new Wheels(parameters.trackM(), parameters.wheelRadiusM()));
  }

  @Override
  public GroundVehicle make(World world, Point start, double headingRad, long seed) {
    DifferentialVehicle vehicle = make(start, headingRad, mismatch.of(seed));
    vehicle.enter(world);
    return vehicle;
  }
}
